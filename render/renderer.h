// Draws scenes into framebuffers: the one renderer of every target, off screen or in a window.
// Knows no context and no window; whoever calls it has made a context current.
#pragma once

#include <optional>

#include "render/frame.h"
#include "render/full_screen.h"
#include "render/gl_framebuffer.h"
#include "render/gpu_scene.h"
#include "render/sun_shadow.h"

namespace parti::render {

/// A scene on the GPU with the sun's shadow: what is made once and drawn often.
struct LoadedScene {
  GpuScene scene;
  SunShadow shadow;
};

/// Used and destroyed while its context is current. Leaves GL's state as its last pass did.
class Renderer {
 public:
  /// `gl` must outlive the renderer and all that it loads.
  /// errors  kGraphics  a shader that fails.
  static Result<Renderer> Create(const Gl& gl, const Look& look = {});

  /// Memory beyond the GPU's own is bounded (VertexStream::kBlockBytes a kind).
  /// `instead_of`: what is not drawn any more; what it took of the GPU is used again.
  /// errors  kGraphics  out of memory.
  Result<LoadedScene> Load(const Scene& scene, std::optional<LoadedScene> instead_of = {}) const;

  /// Draws a tile of the camera's picture over pixels 0, 0 to tile.width, tile.height of
  /// `framebuffer`, whose colour must be GL_SRGB8_ALPHA8 without multisampling.
  /// errors  kGraphics  too large, out of memory;  kBadNumber  an invalid camera.
  Result<void> Draw(const LoadedScene& loaded, const Camera& camera, const Tile& tile,
                    GLuint framebuffer, const Detail& detail = {});

  /// Draws ids into the bound framebuffer (GL_RGBA8, depth, no multisampling).
  Result<void> DrawIds(const LoadedScene& loaded, const Camera& camera, const Tile& tile) const;

 private:
  struct Programs {
    GlProgram ground, face, face_image, line, ink, ink_over, id, depth;
  };
  Renderer(const Gl& gl, const Look& look, Programs programs, GLint most_samples);
  Result<void> SizeFor(const Tile& tile);
  void Resolve(const Tile& tile, const GlFramebuffer& from, GLuint to, GLbitfield what) const;

  const Gl* gl_;
  Look look_;
  Programs programs_;
  GLint most_samples_;
  FullScreenTriangle full_screen_;
  // At least as large as the last tile:
  std::optional<GlFramebuffer> samples_;   ///< multisampled: ground and faces
  std::optional<GlFramebuffer> picture_;   ///< those resolved, and lines
  std::optional<GlFramebuffer> coverage_;  ///< of ink
};

}  // namespace parti::render
