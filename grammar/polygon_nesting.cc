#include "grammar/polygon_nesting.h"

#include <cstdint>
#include <limits>
#include <utility>

namespace parti::grammar {
namespace {

/// How many of the hole's corners and edge middles lie in the outline. All but those on shared
/// stretches of border vote alike, so the majority decides also where loops touch.
bool LiesIn(const Ring& hole, const Polygon& outline) {
  size_t inside = 0;
  for (size_t i = 0; i < hole.size(); ++i) {
    const Vec2 middle = (hole[i] + hole[(i + 1) % hole.size()]) * 0.5;
    inside += Contains(outline, hole[i]) ? 1 : 0;
    inside += Contains(outline, middle) ? 1 : 0;
  }
  return inside > hole.size();
}

}  // namespace

std::vector<Polygon> Nest(std::vector<Ring> outlines, std::vector<Ring> holes) {
  std::vector<Polygon> polygons;
  polygons.reserve(outlines.size());
  for (Ring& outline : outlines) polygons.push_back({std::move(outline), {}});
  std::vector<size_t> owner_of(holes.size(), SIZE_MAX);
  for (size_t h = 0; h < holes.size(); ++h) {
    double smallest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < polygons.size(); ++i) {
      const double area = SignedArea(polygons[i].outer);
      if (area >= smallest || !LiesIn(holes[h], polygons[i])) continue;
      smallest = area;
      owner_of[h] = i;
    }
  }
  for (size_t h = 0; h < holes.size(); ++h) {
    if (owner_of[h] != SIZE_MAX) polygons[owner_of[h]].holes.push_back(std::move(holes[h]));
  }
  return polygons;
}

void DropRepeatedCorners(Ring* ring) {
  Ring kept;
  kept.reserve(ring->size());
  for (const Vec2& p : *ring) {
    if (kept.empty() || glm::distance(kept.back(), p) > kLengthTolerance_m) kept.push_back(p);
  }
  while (kept.size() > 1 && glm::distance(kept.back(), kept.front()) <= kLengthTolerance_m) {
    kept.pop_back();
  }
  *ring = std::move(kept);
}

}  // namespace parti::grammar
