#include "app/picking.h"

#include <cmath>

namespace parti::app {
namespace {

/// Distance along the ray at which it passes through the triangle; nothing where it misses or
/// grazes it (Möller and Trumbore, 1997).
std::optional<double> Hit(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 across = glm::cross(ray.direction, ac);
  const double det = glm::dot(ab, across);
  if (std::abs(det) < 1e-12 * glm::length(ab) * glm::length(ac)) return std::nullopt;
  const Vec3 from_a = ray.origin - a;
  const double u = glm::dot(from_a, across) / det;
  const Vec3 around = glm::cross(from_a, ab);
  const double v = glm::dot(ray.direction, around) / det;
  const double t = glm::dot(ac, around) / det;
  if (u < 0 || v < 0 || u + v > 1 || t <= 0) return std::nullopt;
  return t;
}

}  // namespace

std::optional<ShapeRef> RefOfId(const Model& model, uint32_t id) {
  if (id == 0) return std::nullopt;
  uint32_t shape = id - 1;
  for (size_t lot = 0; lot < model.derived.size(); ++lot) {
    const uint32_t size = model.derived[lot]->tree.size();
    if (shape < size) return ShapeRef{lot, shape};
    shape -= size;
  }
  return std::nullopt;
}

uint32_t IdOfRef(const Model& model, const ShapeRef& ref) {
  uint32_t id = 1 + ref.shape;
  for (size_t lot = 0; lot < ref.lot; ++lot) id += model.derived[lot]->tree.size();
  return id;
}

std::optional<Plane> PlaneAt(const Model& model, const ShapeRef& ref, const Camera& camera,
                             const Vec2& px) {
  const Ray ray = View(camera).RayThrough(px);
  std::vector<Vec3> corners;
  grammar::TrianglesOf(ShapeAt(model, ref).item, &corners);
  double nearest = INFINITY;
  Plane plane;
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    const auto t = Hit(ray, corners[i], corners[i + 1], corners[i + 2]);
    if (!t || *t >= nearest) continue;
    nearest = *t;
    const Vec3 normal =
        glm::normalize(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]));
    plane.normal = glm::dot(normal, ray.direction) > 0 ? -normal : normal;
    plane.offset = glm::dot(plane.normal, corners[i]);
  }
  if (!std::isfinite(nearest)) return std::nullopt;
  return plane;
}

}  // namespace parti::app
