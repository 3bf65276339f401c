// Pictures without a window: OSMesa where there is one, else EGL surfaceless.
#pragma once

#include <memory>

#include "render/scene.h"

namespace parti::render {

enum class OffscreenTarget { kBest, kOsMesa, kEglSurfaceless };

/// Owns a GL context; not thread-safe. Draw as many pictures with one as you like.
class OffscreenRenderer {
 public:
  /// errors  kGraphics  neither is there, or the one asked for is not; says what to install.
  static Result<std::unique_ptr<OffscreenRenderer>> Create(
      OffscreenTarget target = OffscreenTarget::kBest);
  virtual ~OffscreenRenderer() = default;

  /// The picture has the camera's size.
  /// errors  kGraphics  larger than the device can;  kBadNumber  an invalid camera.
  virtual Result<Image> Draw(const Scene& scene, const Camera& camera) = 0;
  /// The id of the nearest Faces at each pixel, rows from the top (0: none).
  virtual Result<std::vector<uint32_t>> DrawIds(const Scene& scene, const Camera& camera) = 0;
  virtual std::string_view name() const = 0;  ///< "OSMesa", "EGL surfaceless"
};

}  // namespace parti::render
