// A canvas without a window: a context that stays current, and framebuffers to draw it into.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "render/canvas.h"
#include "render/offscreen.h"

namespace parti::render::tests {

/// Buffers like those of a window that swaps between several.
class CanvasTarget {
 public:
  /// Null without such a context.
  static std::unique_ptr<CanvasTarget> Create(OffscreenTarget target, const glm::ivec2& size,
                                              int buffers = 1);
  ~CanvasTarget();

  GlContext& context() { return *context_; }
  const Gl& gl() const { return gl_; }
  Canvas& canvas() { return *canvas_; }
  void Resize(const glm::ivec2& size);

  /// Draws into the buffer that was drawn longest ago, and makes it the one that is shown.
  Damage Draw();
  /// The shown buffer, from the top.
  Image Shown() const;
  /// What a canvas that is drawn whole would show.
  Image Whole();
  void DestroyCanvas() { canvas_.reset(); }

 private:
  CanvasTarget(std::unique_ptr<GlContext> context, const Gl& gl, int buffers)
      : context_(std::move(context)), gl_(gl), count_(buffers) {}
  void MakeBuffers(const glm::ivec2& size);
  Image Read(const GlFramebuffer& buffer) const;

  std::unique_ptr<GlContext> context_;
  Gl gl_;
  std::unique_ptr<Canvas> canvas_;
  int count_;
  struct Buffer {
    GlFramebuffer framebuffer;
    int drawn = -1;  ///< in which frame; -1: never
  };
  std::vector<Buffer> buffers_;
  std::optional<GlFramebuffer> whole_;
  int frame_ = 0;
  size_t shown_ = 0;
};

/// A size x size picture of one colour, rows alike, as a texture that outlives the canvas.
CanvasPicture PlainPicture(const Gl& gl, const glm::ivec2& size, const Vec3f& color);

}  // namespace parti::render::tests
