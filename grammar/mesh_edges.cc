#include "grammar/mesh_edges.h"

#include <algorithm>

namespace parti::grammar {
namespace {

/// Faces whose normal is nearer than about 2.6 deg to the vertical lie flat.
constexpr double kFlat = 0.999;
constexpr double kSameDirection = 1e-9;
constexpr double kSameHeight_m = 1e-9;

}  // namespace

void StartAlong(const std::vector<Vec3>& points, const Vec3& direction,
                std::vector<uint32_t>* loop) {
  size_t best = 0;
  double best_along = -2, best_height = 0;
  for (size_t i = 0; i < loop->size(); ++i) {
    const Vec3& a = points[(*loop)[i]];
    const Vec3& b = points[(*loop)[(i + 1) % loop->size()]];
    const double length = glm::length(b - a);
    const double along = length > 0 ? glm::dot(b - a, direction) / length : -1;
    const double height = a.y + b.y;
    const bool better =
        along > best_along + kSameDirection ||
        (along > best_along - kSameDirection && height < best_height - kSameHeight_m);
    if (!better) continue;
    best = i;
    best_along = along;
    best_height = height;
  }
  std::rotate(loop->begin(), loop->begin() + static_cast<std::ptrdiff_t>(best), loop->end());
}

Vec3 BottomDirection(const Vec3& normal) {
  if (std::abs(normal.y) > kFlat) return {0, 0, 0};
  return glm::normalize(glm::cross(Vec3(0, 1, 0), normal));
}

void StartAtBottom(Mesh* mesh) {
  for (MeshFace& face : mesh->faces) {
    const Vec3 direction = BottomDirection(Normal(*mesh, face));
    if (direction != Vec3(0, 0, 0)) StartAlong(mesh->points, direction, &face.loop);
  }
}

}  // namespace parti::grammar
