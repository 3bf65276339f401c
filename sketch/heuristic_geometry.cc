#include "sketch/heuristic_geometry.h"

#include <algorithm>

namespace parti::sketch {
namespace {

Vec2 InwardNormal(const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length = glm::length(along);
  return length > 0 ? Vec2(-along.y, along.x) / length : Vec2(0, 0);
}

// The corner between edges with inward normals m and n moves to where both moved lines meet.
Vec2 Mitre(const Vec2& m, const Vec2& n) {
  const double together = 1 + glm::dot(m, n);
  constexpr double kSpike = 1e-3;  // an angle under 3 degrees; its corner moves as if it were blunt
  return (m + n) / std::max(together, kSpike);
}

void AddRing(const grammar::Ring& ring, std::vector<OutlineEdge>* edges) {
  const size_t n = ring.size();
  std::vector<Vec2> normals;
  for (size_t i = 0; i < n; ++i) normals.push_back(InwardNormal(ring[i], ring[(i + 1) % n]));
  for (size_t i = 0; i < n; ++i) {
    edges->push_back({ring[i], ring[(i + 1) % n], normals[i],
                      Mitre(normals[(i + n - 1) % n], normals[i]),
                      Mitre(normals[i], normals[(i + 1) % n])});
  }
}

}  // namespace

Vec3 DirectionOf(const Segment3& line) {
  const double length = LengthOf(line);
  return length > 0 ? (line.b - line.a) / length : Vec3(0, 0, 0);
}

bool Parallel(const Vec3& u, const Vec3& v, Angle tolerance) {
  return std::abs(glm::dot(u, v)) >= std::cos(tolerance.radians());
}

bool Orthogonal(const Vec3& u, const Vec3& v, Angle tolerance) {
  return std::abs(glm::dot(u, v)) <= std::sin(tolerance.radians());
}

bool LooksUp(const grammar::Item& planar) {
  constexpr double kLies = 0.7071;  // errata 10: 45 degrees tell up from the four winds
  return planar.scope.z.y >= kLies;
}

std::vector<OutlineEdge> OutlineOf(const grammar::Item& planar) {
  const grammar::Polygon polygon = grammar::PolygonOf(planar);
  std::vector<OutlineEdge> edges;
  AddRing(polygon.outer, &edges);
  for (const grammar::Ring& hole : polygon.holes) AddRing(hole, &edges);
  return edges;
}

}  // namespace parti::sketch
