// Measures of rings and polygons, and point location.
#include "grammar/polygon.h"

#include <algorithm>

namespace parti::grammar {
namespace {

/// Squared distance of p from segment ab.
double DistanceSquared(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length_squared = glm::dot(d, d);
  const double t =
      length_squared > 0 ? std::clamp(glm::dot(p - a, d) / length_squared, 0.0, 1.0) : 0.0;
  const Vec2 off = p - (a + d * t);
  return glm::dot(off, off);
}

enum class Side { kOutside, kInside, kOn };

Side Locate(const Ring& ring, const Vec2& p) {
  bool inside = false;
  for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2 &a = ring[j], &b = ring[i];
    if (DistanceSquared(p, a, b) <= kLengthTolerance_m * kLengthTolerance_m) return Side::kOn;
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
  }
  return inside ? Side::kInside : Side::kOutside;
}

}  // namespace

double SignedArea(const Ring& ring) {
  // Measured from a corner: coordinates far from the origin would cancel badly.
  double doubled = 0;
  for (size_t i = 2; i < ring.size(); ++i) {
    doubled += Cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  }
  return doubled / 2;
}

double Area(const Polygon& polygon) {
  double area = SignedArea(polygon.outer);
  for (const Ring& hole : polygon.holes) area += SignedArea(hole);
  return area;
}

Box2 Bounds(const Polygon& polygon) {
  if (polygon.outer.empty()) return {};
  Box2 box{polygon.outer[0], polygon.outer[0]};
  for (const Vec2& p : polygon.outer) {
    box.low = Vec2(std::min(box.low.x, p.x), std::min(box.low.y, p.y));
    box.high = Vec2(std::max(box.high.x, p.x), std::max(box.high.y, p.y));
  }
  return box;
}

Polygon Rectangle(const Vec2& size) {
  return {{Vec2(0, 0), Vec2(size.x, 0), size, Vec2(0, size.y)}, {}};
}

bool Contains(const Polygon& polygon, const Vec2& point) {
  if (polygon.outer.size() < 3) return false;
  const Side side = Locate(polygon.outer, point);
  if (side != Side::kInside) return side == Side::kOn;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(),
                      [&](const Ring& hole) { return Locate(hole, point) == Side::kInside; });
}

}  // namespace parti::grammar
