// The box around what can be drawn: cameras, depth range, shadow and grid are chosen from it.
// The matrix from the world to the picture is here too; what fills the picture is not.
#pragma once

#include "base/camera.h"
#include "render/scene.h"

namespace parti::render {

/// Vertices beyond this distance from the origin along an axis are not drawn: float has no
/// millimetres long before, and no picture shows them. [m]
inline constexpr float kWorldLimit_m = 1e7f;

/// Finite and within kWorldLimit_m. What is not is left out of pictures, bounds and ids.
bool IsDrawable(const Vec3f& p);

/// Axis-aligned; low > high while it holds nothing.
struct Bounds {
  Vec3 low{1, 1, 1};
  Vec3 high{-1, -1, -1};

  bool empty() const { return low.x > high.x; }
  void Add(const Vec3& p);  ///< p must be finite
  Vec3 middle() const { return empty() ? Vec3(0) : (low + high) * 0.5; }
  /// Half the diagonal [m]; 0 while empty.
  double radius() const { return empty() ? 0.0 : glm::length(high - low) * 0.5; }
};

/// Of drawable faces, and of lines too where asked.
Bounds BoundsOf(const Scene& scene, bool with_lines);

/// Distances from the eye's plane between which things are drawn; 0 < near < far.
struct DepthRange {
  double near_m = 0.1;
  double far_m = 100;
};

/// The least range that holds the bounds as the camera sees them, with near at least far / 4000, so
/// that 24 bits of depth tell apart what pixels do.
DepthRange DepthRangeFor(const Bounds& bounds, const Camera& camera);

/// Clip coordinates of GL (y up, z from -1) for a picture of round(width) x round(height) px;
/// View's pixels and this agree.
glm::mat4 ClipFromWorld(const Camera& camera, const DepthRange& range);

/// The integer size of a camera's picture.
glm::ivec2 PictureSize(const Camera& camera);

}  // namespace parti::render
