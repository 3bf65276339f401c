// Draws marks onto a canvas's target. What they are, marks.h says; when, Canvas.
// Nothing stays on the GPU from one frame to the next.
#pragma once

#include "render/full_screen.h"
#include "render/gl_framebuffer.h"
#include "render/gl_program.h"
#include "render/marks.h"
#include "render/piece_batch.h"

namespace parti::render {

/// Used and destroyed while its context is current.
class MarkLayer {
 public:
  /// errors  kGraphics.
  static Result<MarkLayer> Create(const Gl& gl, const glm::ivec2& size);

  /// Draws what lies in `repair` into `framebuffer` (GL_RGBA8 or a window's, of the layer's size).
  void Draw(const std::vector<MarkGroup>& groups, const Damage& repair, GLuint framebuffer) const;

 private:
  struct Programs {
    GlProgram ink, over;
  };
  MarkLayer(const Gl& gl, const glm::ivec2& size, Programs programs, GlFramebuffer coverage);
  void DrawCoverage(const MarkGroup& group, const Damage& where) const;

  const Gl* gl_;
  glm::ivec2 size_;
  Programs programs_;
  FullScreenTriangle full_screen_;
  PieceBatch batch_;
  GlFramebuffer coverage_;
};

}  // namespace parti::render
