// Leaving out the corners that straight walls have no need of (Straightened).
#include <algorithm>

#include "grammar/polygon_skeleton.h"

namespace parti::grammar {
namespace {

bool LiesBetween(const Vec2& p, const Vec2& a, const Vec2& b, double tolerance) {
  const Vec2 chord = b - a;
  const double length = glm::length(chord);
  if (glm::distance(a, p) <= tolerance) return true;
  return length > 0 && std::abs(Cross(chord, p - a)) <= tolerance * length &&
         glm::dot(chord, p - a) >= 0 && glm::dot(chord, b - p) >= 0;
}

/// Drops corners one by one. Every corner that was dropped stays near the edge that replaced it, so
/// that a shallow arc keeps its shape.
Ring StraightRing(const Ring& ring, double tolerance) {
  const size_t n = ring.size();
  std::vector<size_t> kept;
  const auto all_between = [&](size_t from, size_t to) {
    for (size_t i = from + 1; i < to; ++i) {
      if (!LiesBetween(ring[i % n], ring[from % n], ring[to % n], tolerance)) return false;
    }
    return true;
  };
  // A corner that surely stays: the one furthest from the middle of the ring's bounds.
  const Box2 box = Bounds({ring, {}});
  const Vec2 middle = (box.low + box.high) * 0.5;
  const auto far = std::max_element(ring.begin(), ring.end(), [&](const Vec2& a, const Vec2& b) {
    return glm::distance(a, middle) < glm::distance(b, middle);
  });
  const auto first = static_cast<size_t>(far - ring.begin());
  kept.push_back(first);
  for (size_t i = first + 1; i < first + n; ++i) {
    if (!all_between(kept.back(), i + 1)) kept.push_back(i);
  }
  Ring result;
  for (const size_t i : kept) result.push_back(ring[i % n]);
  std::rotate(
      result.begin(),
      result.begin() +
          (std::find_if(kept.begin(), kept.end(), [&](size_t i) { return i >= n; }) - kept.begin()),
      result.end());
  return result;
}

}  // namespace

double ExtentOf(const Polygon& polygon) {
  const Box2 box = Bounds(polygon);
  return std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

Polygon Straightened(const Polygon& polygon, double extent_m) {
  const double tolerance = kStraight * extent_m;
  Polygon result{StraightRing(polygon.outer, tolerance), {}};
  if (result.outer.size() < 3) result.outer = polygon.outer;
  for (const Ring& hole : polygon.holes) {
    Ring straight = StraightRing(hole, tolerance);
    if (straight.size() >= 3) result.holes.push_back(std::move(straight));
  }
  return result;
}

}  // namespace parti::grammar
