#include "grammar/polygon_nesting.h"

#include <limits>
#include <utility>

namespace parti::grammar {
namespace {

/// Whether most of the hole's corners and edge middles lie in the outline. All but those on shared
/// stretches of border vote alike, so the majority decides also where loops touch.
bool LiesIn(const Ring& hole, const Ring& outline) {
  const Polygon region{outline, {}};
  size_t inside = 0;
  for (size_t i = 0; i < hole.size(); ++i) {
    const Vec2 middle = (hole[i] + hole[(i + 1) % hole.size()]) * 0.5;
    inside += Contains(region, hole[i]) ? 1 : 0;
    inside += Contains(region, middle) ? 1 : 0;
  }
  return inside > hole.size();
}

}  // namespace

size_t OutlineAround(const Ring& hole, const std::vector<Polygon>& outlines) {
  size_t best = outlines.size();
  double smallest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < outlines.size(); ++i) {
    const double area = SignedArea(outlines[i].outer);
    if (area >= smallest || !LiesIn(hole, outlines[i].outer)) continue;
    smallest = area;
    best = i;
  }
  return best;
}

std::vector<Polygon> Nest(std::vector<Ring> outlines, std::vector<Ring> holes) {
  std::vector<Polygon> polygons;
  polygons.reserve(outlines.size());
  for (Ring& outline : outlines) polygons.push_back({std::move(outline), {}});
  for (Ring& hole : holes) {
    const size_t owner = OutlineAround(hole, polygons);
    if (owner < polygons.size()) polygons[owner].holes.push_back(std::move(hole));
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
