// Random polygons for properties: awkward on purpose, simple by construction.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "grammar/polygon.h"

namespace parti::grammar::tests {

/// A skyline of 2 to 7 columns with whole widths and heights: many edges on common lines, so that
/// cuts at whole numbers run along edges. Columns that are wide and high enough may have a
/// courtyard.
inline Polygon Skyline(Random* random) {
  const int columns = 2 + static_cast<int>(random->Uniform(0, 6));
  std::vector<Ring> rings = {{Vec2(0, 0)}};
  double x = 0, height = 0;
  Ring top;
  for (int i = 0; i < columns; ++i) {
    const double width = 1 + std::floor(random->Uniform(0, 5));
    const double h = 1 + std::floor(random->Uniform(0, 8));
    if (h != height) {
      top.emplace_back(x, height);
      top.emplace_back(x, h);
    }
    if (width >= 3 && h >= 3 && random->Uniform() < 0.7) {
      rings.push_back(
          {Vec2(x + 1, 1), Vec2(x + width - 1, 1), Vec2(x + width - 1, h - 1), Vec2(x + 1, h - 1)});
    }
    x += width;
    height = h;
  }
  top.emplace_back(x, height);
  top.emplace_back(x, 0);
  rings[0] = Ring(top.rbegin(), top.rend());
  if (rings[0].back() != Vec2(0, 0)) rings[0].emplace_back(0, 0);
  return PolygonFrom(rings).value();
}

/// A star-shaped outline of 3 to 24 corners with radii of 1 to 10 m about `centre`.
inline Ring Star(Random* random, const Vec2& centre, double scale) {
  const int corners = 3 + static_cast<int>(random->Uniform(0, 22));
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * (i + random->Uniform(-0.3, 0.3)) / corners;
    const double radius = scale * random->Uniform(1, 10);
    ring.push_back(centre + Vec2(std::cos(angle), std::sin(angle)) * radius);
  }
  return ring;
}

/// A star with a star-shaped hole in its middle, half of the time.
inline Polygon StarPolygon(Random* random) {
  const Vec2 centre(random->Uniform(-50, 50), random->Uniform(-50, 50));
  std::vector<Ring> rings = {Star(random, centre, 1)};
  if (random->Uniform() < 0.5) rings.push_back(Star(random, centre, 0.03));
  const auto polygon = PolygonFrom(rings);
  if (polygon) return *polygon;
  rings.resize(1);
  return PolygonFrom(rings).value_or(Rectangle(Vec2(3, 4)));
}

inline Polygon AnyPolygon(Random* random) {
  return random->Uniform() < 0.5 ? Skyline(random) : StarPolygon(random);
}

inline Vec2 PointIn(const Box2& box, Random* random) {
  return {random->Uniform(box.low.x, box.high.x), random->Uniform(box.low.y, box.high.y)};
}

/// Distance of a point from the polygon's border.
inline double DistanceToBorder(const Polygon& polygon, const Vec2& p) {
  double nearest = 1e300;
  const auto visit = [&](const Ring& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
      nearest = std::min(nearest, glm::distance(p, a + (b - a) * t));
    }
  };
  visit(polygon.outer);
  for (const Ring& hole : polygon.holes) visit(hole);
  return nearest;
}

}  // namespace parti::grammar::tests
