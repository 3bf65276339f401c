#include "render/bounds.h"

#include <algorithm>
#include <cmath>

namespace parti::render {

bool IsDrawable(const Vec3f& p) {
  // NaN fails every comparison.
  return std::abs(p.x) <= kWorldLimit_m && std::abs(p.y) <= kWorldLimit_m &&
         std::abs(p.z) <= kWorldLimit_m;
}

void Bounds::Add(const Vec3& p) {
  low = empty() ? p : glm::min(low, p);
  high = glm::max(high, p);
}

Bounds BoundsOf(const Scene& scene, bool with_lines) {
  Bounds bounds;
  const auto add = [&bounds](const std::vector<Vec3f>& points) {
    for (const Vec3f& p : points) {
      if (IsDrawable(p)) bounds.Add(Vec3(p));
    }
  };
  for (const Faces& faces : scene.faces) add(faces.corners);
  if (!with_lines) return bounds;
  for (const Lines& lines : scene.lines) add(lines.ends);
  return bounds;
}

DepthRange DepthRangeFor(const Bounds& bounds, const Camera& camera) {
  constexpr double kMostRatio = 4000;
  if (bounds.empty()) return {};
  const View view(camera);
  double nearest = INFINITY, farthest = -INFINITY;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p(corner & 1 ? bounds.high.x : bounds.low.x,
                 corner & 2 ? bounds.high.y : bounds.low.y,
                 corner & 4 ? bounds.high.z : bounds.low.z);
    nearest = std::min(nearest, view.Depth(p));
    farthest = std::max(farthest, view.Depth(p));
  }
  DepthRange range;
  range.far_m = std::max(farthest * 1.01 + 0.01, 10 * View::kNear);
  range.near_m = std::max({nearest * 0.99 - 0.01, range.far_m / kMostRatio, View::kNear});
  return range;
}

glm::ivec2 PictureSize(const Camera& camera) {
  return {std::max(1, static_cast<int>(std::lround(camera.width_px))),
          std::max(1, static_cast<int>(std::lround(camera.height_px)))};
}

glm::mat4 ClipFromWorld(const Camera& camera, const DepthRange& range) {
  const View view(camera);
  const glm::ivec2 size = PictureSize(camera);
  const double focal_px = camera.height_px * 0.5 / std::tan(camera.vertical_fov.radians() * 0.5);
  const double n = range.near_m, f = range.far_m;
  const Vec3 forward = view.forward();
  // Rows over (x, y, z, 1); the second summands keep cameras of fractional size exact.
  const Vec3 x = view.right() * (2 * focal_px / size.x) + forward * (camera.width_px / size.x - 1);
  const Vec3 y = view.up() * (2 * focal_px / size.y) + forward * (1 - camera.height_px / size.y);
  const Vec3 z = forward * ((f + n) / (f - n));
  const auto row = [&camera](const Vec3& axis, double constant) {
    return Vec4(axis, constant - glm::dot(axis, camera.eye));
  };
  const Mat4 rows(row(x, 0), row(y, 0), row(z, -2 * f * n / (f - n)), row(forward, 0));
  return glm::mat4(glm::transpose(rows));
}

}  // namespace parti::render
