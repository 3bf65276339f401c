// The ink of a canvas on the GPU: the groups of strokes that are done in one texture with colours,
// the coverage of the last group and of the tail in one each. Which ink there is, InkStrokes knows.
#pragma once

#include "render/full_screen.h"
#include "render/gl_framebuffer.h"
#include "render/gl_program.h"
#include "render/ink_strokes.h"
#include "render/piece_batch.h"

namespace parti::render {

/// Used and destroyed while its context is current.
class InkLayer {
 public:
  /// errors  kGraphics  too large for the device, a shader that fails.
  static Result<InkLayer> Create(const Gl& gl, const glm::ivec2& size);

  /// Brings the textures up to date. O(pieces in the news), and for a rebuild those that it
  /// touches.
  void Update(const InkStrokes& strokes, const InkNews& news);

  /// All have the canvas's size. Premultiplied colours, GL_SRGB8_ALPHA8:
  GLuint settled() const { return settled_.color_texture(); }
  GLuint coverage() const { return coverage_.color_texture(); }  ///< of color()
  GLuint tail() const { return tail_.color_texture(); }          ///< of color() too
  /// There is no ink elsewhere.
  const Damage& extent() const { return extent_; }
  const Vec4f& color() const { return color_; }  ///< sRGB, alpha

 private:
  struct Programs {
    GlProgram ink, over;
  };
  InkLayer(const Gl& gl, const glm::ivec2& size, Programs programs, GlFramebuffer settled,
           GlFramebuffer coverage, GlFramebuffer tail);
  void DrawCoverage(const GlFramebuffer& target, std::span<const InkPiece> pieces) const;
  void Clear(const GlFramebuffer& target, const PixelRect& rect) const;
  void Settle(const PixelRect& rect) const;
  void SettleGroup();
  void DrawFresh(const InkGroupPieces& fresh);
  void Rebuild(const InkStrokes& strokes, const PixelRect& rect);
  void UpdateTail(const std::vector<InkPiece>& tail);

  const Gl* gl_;
  glm::ivec2 size_;
  Programs programs_;
  FullScreenTriangle full_screen_;
  PieceBatch batch_;
  GlFramebuffer settled_, coverage_, tail_;
  Vec4f color_{0, 0, 0, 1};  ///< of the last group
  Damage extent_;            ///< of all ink
  Damage group_extent_;      ///< of the last group
  Damage tail_extent_;
};

}  // namespace parti::render
