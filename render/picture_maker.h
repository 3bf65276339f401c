// Makes pictures of scenes in textures, tile by tile, and keeps what can be kept on the GPU.
// Whose thread this is, and which picture is wanted next, ScenePainter knows.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "render/gl_context.h"
#include "render/painted_picture.h"
#include "render/renderer.h"

namespace parti::render {

/// Owns a context, which stays current on the thread that made this. One thread uses it.
class PictureMaker {
 public:
  /// errors  kGraphics.
  static Result<std::unique_ptr<PictureMaker>> Create(std::unique_ptr<GlContext> context,
                                                      const PainterParams& params);
  /// Pictures that are still held stay valid; their textures end with the last context that shares.
  ~PictureMaker();

  /// Null when `stop` said so between two tiles. A scene is uploaded when it is another than the
  /// last one's. On return the GPU has finished.
  /// errors  kGraphics  too large, out of memory;  kBadNumber  an invalid camera.
  Result<std::shared_ptr<const PaintedPicture>> Make(const std::shared_ptr<const Scene>& scene,
                                                     const Camera& camera, bool coarse,
                                                     const std::function<bool()>& stop);

 private:
  /// Framebuffers that no picture uses. Pictures outlive their maker, and so does this.
  struct Pool {
    std::mutex mutex;
    std::vector<GlFramebuffer> free;
    bool closed = false;
  };
  struct TileTargets {
    GlFramebuffer color, ids;
  };
  PictureMaker(std::unique_ptr<GlContext> context, const Gl& gl, const PainterParams& params);
  Result<void> Load(const std::shared_ptr<const Scene>& scene);
  Result<std::shared_ptr<GlFramebuffer>> Slot(const glm::ivec2& size);
  Result<void> DrawTile(const Camera& camera, const Tile& tile, PaintedPicture* picture,
                        const GlFramebuffer& slot);
  std::vector<uint8_t> Read(const Tile& tile) const;
  void ReadIds(const Tile& tile, PaintedPicture* picture) const;

  std::unique_ptr<GlContext> context_;
  Gl gl_;
  PainterParams params_;
  std::shared_ptr<Pool> pool_;
  std::optional<Renderer> renderer_;
  std::optional<TileTargets> tile_;
  std::shared_ptr<const Scene> scene_;  ///< that is loaded
  std::optional<LoadedScene> loaded_;
  int uploads_ = 0;
};

}  // namespace parti::render
