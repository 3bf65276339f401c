#include "sketch/visibility.h"

#include <algorithm>

namespace parti::sketch {
namespace {

// Faces nearer to a point than this share of its distance touch it.
constexpr double kTouching = 1e-4;
// How far sample points lie from the middle of a face towards its corners.
constexpr double kTowardsCorner = 0.85;

bool LooksAtEye(const Facet& facet, const Vec3& eye) {
  return glm::dot(facet.plane.normal, eye) > facet.plane.offset;
}

// A point that surely lies inside: of the outline's triangles, the middle of the largest.
Vec2 MiddleOf(const grammar::Polygon& polygon) {
  Vec2 sum(0, 0);
  for (const Vec2& corner : polygon.outer) sum += corner;
  const Vec2 mean = sum / static_cast<double>(polygon.outer.size());
  if (grammar::Contains(polygon, mean)) return mean;
  return (polygon.outer[0] + polygon.outer[1]) / 2.0;
}

std::vector<Vec3> PointsOn(const Facet& facet) {
  const Vec2 middle = MiddleOf(facet.outline);
  std::vector<Vec3> points = {facet.scope.ToWorld(Vec3(middle, 0))};
  for (const Vec2& corner : facet.outline.outer) {
    const Vec2 p = middle + (corner - middle) * kTowardsCorner;
    if (grammar::Contains(facet.outline, p)) points.push_back(facet.scope.ToWorld(Vec3(p, 0)));
  }
  return points;
}

bool Hides(const Facet& facet, const Vec3& eye, const Vec3& point) {
  const Vec3 way = point - eye;
  const double slope = glm::dot(facet.plane.normal, way);
  if (slope == 0) return false;
  const double t = (facet.plane.offset - glm::dot(facet.plane.normal, eye)) / slope;
  if (!(t > 0 && t < 1 - kTouching)) return false;
  const Vec3 local = facet.scope.ToLocal(eye + way * t);
  return grammar::Contains(facet.outline, Vec2(local.x, local.y));
}

bool IsHidden(const Vec3& point, size_t item, const std::vector<Facet>& facets, const Vec3& eye) {
  return std::any_of(facets.begin(), facets.end(), [&](const Facet& facet) {
    return facet.item != item && Hides(facet, eye, point);
  });
}

}  // namespace

std::vector<Facet> FacetsOf(std::span<const grammar::Item> items, std::span<const size_t> which) {
  std::vector<Facet> facets;
  for (const size_t i : which) {
    for (const grammar::Item& face : grammar::FacesOf(items[i])) {
      const Plane plane{face.scope.z, glm::dot(face.scope.z, face.scope.origin)};
      facets.push_back({i, plane, face.scope, grammar::PolygonOf(face)});
    }
  }
  return facets;
}

bool IsOver(const Vec2& pixel, const Facet& facet, const View& view) {
  const auto met = Intersect(view.RayThrough(pixel), facet.plane);
  if (!met) return false;
  const Vec3 local = facet.scope.ToLocal(*met);
  return grammar::Contains(facet.outline, Vec2(local.x, local.y));
}

double HiddenShare(size_t item, const std::vector<Facet>& facets, const View& view) {
  const Vec3& eye = view.camera().eye;
  int hidden = 0, all = 0;
  for (const Facet& facet : facets) {
    if (facet.item != item || !LooksAtEye(facet, eye)) continue;
    for (const Vec3& point : PointsOn(facet)) {
      ++all;
      hidden += IsHidden(point, item, facets, eye) ? 1 : 0;
    }
  }
  return all == 0 ? 1.0 : static_cast<double>(hidden) / all;
}

}  // namespace parti::sketch
