// Pictures without a window: OSMesa where there is one, else EGL surfaceless.
// The facade of render for commands and tests; how a picture is made is Renderer's.
#pragma once

#include <memory>

#include "render/gl_context.h"
#include "render/scene.h"

namespace parti::render {

/// kBest: OSMesa, which draws alike on every machine, before EGL, which may find a GPU.
enum class OffscreenTarget { kBest, kOsMesa, kEglSurfaceless };

/// A context without a window.
/// errors  kGraphics  neither is there, or the one asked for is not; says what to install.
Result<std::unique_ptr<GlContext>> CreateOffscreenContext(
    OffscreenTarget target = OffscreenTarget::kBest);

/// Larger pictures are drawn in square tiles of this side, so that memory stays bounded. [px]
inline constexpr int kTileSide_px = 2048;

/// Owns a GL context, current only within its functions, so that several may live in one process;
/// not thread-safe. Draw as many pictures with one as you like.
class OffscreenRenderer {
 public:
  /// errors  kGraphics  neither is there, or the one asked for is not; says what to install.
  static Result<std::unique_ptr<OffscreenRenderer>> Create(
      OffscreenTarget target = OffscreenTarget::kBest, int tile_side_px = kTileSide_px);
  virtual ~OffscreenRenderer() = default;

  /// The picture has the camera's size, rounded; what can't be drawn is left out (see GpuScene).
  /// errors  kGraphics  larger than the device can;  kBadNumber  an invalid camera.
  virtual Result<Image> Draw(const Scene& scene, const Camera& camera) = 0;
  /// The id of the nearest Faces at the middle of each pixel, rows from the top (0: none).
  /// errors  as Draw.
  virtual Result<std::vector<uint32_t>> DrawIds(const Scene& scene, const Camera& camera) = 0;
  virtual std::string_view name() const = 0;  ///< "OSMesa", "EGL surfaceless"
};

}  // namespace parti::render
