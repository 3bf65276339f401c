// Moving polygons inward and outward with mitred corners (Offset), and the ring between (Border).
//
// Convex outlines without holes are done here: no edge can meet any but its neighbours' successors,
// so that cutting by every moved edge in turn is all. All else are levels of straight skeletons.
#include <algorithm>
#include <utility>

#include "grammar/polygon.h"
#include "grammar/polygon_nesting.h"
#include "grammar/polygon_skeleton.h"

namespace parti::grammar {
namespace {

/// Larger convex outlines than this are left to skeletons, which are as slow then, but no slower.
constexpr size_t kMostConvexCorners = 64;

bool IsConvex(const Ring& ring) {
  const size_t n = ring.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2 in = ring[(i + 1) % n] - ring[i];
    const Vec2 out = ring[(i + 2) % n] - ring[(i + 1) % n];
    if (Cross(in, out) < -1e-12 * glm::length(in) * glm::length(out)) return false;
  }
  return true;
}

/// The part of a convex ring with dot(normal, p) >= offset.
Ring CutConvex(const Ring& ring, const Vec2& normal, double offset) {
  Ring kept;
  kept.reserve(ring.size() + 1);
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double da = glm::dot(normal, a) - offset, db = glm::dot(normal, b) - offset;
    if (da >= 0) kept.push_back(a);
    if ((da >= 0) != (db >= 0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

Ring ShrinkConvex(const Ring& ring, double distance) {
  Ring shrunk = ring;
  for (size_t i = 0; i < ring.size() && shrunk.size() >= 3; ++i) {
    const Vec2 along = glm::normalize(ring[(i + 1) % ring.size()] - ring[i]);
    const Vec2 inward(-along.y, along.x);
    shrunk = CutConvex(shrunk, inward, glm::dot(inward, ring[i]) + distance);
  }
  return shrunk;
}

/// Each corner moved along its mitre.
Ring GrowConvex(const Ring& ring, double distance) {
  const size_t n = ring.size();
  Ring grown;
  grown.reserve(n);
  for (size_t i = 0; i < n; ++i) {
    const Vec2 in = glm::normalize(ring[i] - ring[(i + n - 1) % n]);
    const Vec2 out = glm::normalize(ring[(i + 1) % n] - ring[i]);
    const Vec2 sum(in.y + out.y, -in.x - out.x);  // of both outward normals
    grown.push_back(ring[i] + sum * (distance / (1 + glm::dot(in, out))));
  }
  return grown;
}

bool UseConvex(const Polygon& polygon) {
  return polygon.holes.empty() && polygon.outer.size() <= kMostConvexCorners &&
         IsConvex(polygon.outer);
}

Ring Reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

void DropSlivers(std::vector<Polygon>* pieces) {
  for (Polygon& piece : *pieces) {
    DropRepeatedCorners(&piece.outer);
    for (Ring& hole : piece.holes) DropRepeatedCorners(&hole);
    std::erase_if(piece.holes, [](const Ring& h) { return -SignedArea(h) < kAreaTolerance_m2; });
  }
  std::erase_if(*pieces, [](const Polygon& piece) {
    return piece.outer.size() < 3 || Area(piece) < kAreaTolerance_m2;
  });
}

Result<std::vector<Polygon>> SkeletonOffset(const Polygon& polygon, double extent,
                                            double distance) {
  const auto skeleton = StraightSkeleton(polygon, extent);
  if (!skeleton) return Fail(skeleton);
  return LevelOf(*skeleton, distance);
}

Result<std::vector<Polygon>> Shrink(const Polygon& polygon, double distance) {
  if (UseConvex(polygon)) return std::vector<Polygon>{{ShrinkConvex(polygon.outer, distance), {}}};
  return SkeletonOffset(polygon, ExtentOf(polygon), distance);
}

/// How far the outline's corners can move: the longest mitre.
double Reach(const Ring& ring, double distance) {
  const size_t n = ring.size();
  double longest = 1;
  for (size_t i = 0; i < n; ++i) {
    const Vec2 in = glm::normalize(ring[i] - ring[(i + n - 1) % n]);
    const Vec2 out = glm::normalize(ring[(i + 1) % n] - ring[i]);
    if (Cross(in, out) <= 0) continue;
    longest = std::max(longest, std::sqrt(2 / std::max(1e-12, 1 + glm::dot(in, out))));
  }
  return longest * distance;
}

/// Grows an outline: the region between it and a wide frame shrinks. What is left of that region is
/// the piece with the frame, around the grown outline, and the pockets that closed behind it.
Result<Polygon> GrowOutline(const Ring& outline, double distance) {
  if (UseConvex({outline, {}})) return Polygon{GrowConvex(outline, distance), {}};
  const Box2 box = Bounds({outline, {}});
  const double margin = 2 * (Reach(outline, distance) + distance) + 1;
  const Vec2 low = box.low - Vec2(margin), high = box.high + Vec2(margin);
  const Polygon around{{low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)}, {Reversed(outline)}};
  // As fine as the outline asks for, however wide the frame is.
  auto pieces = SkeletonOffset(around, ExtentOf({outline, {}}), distance);
  if (!pieces) return Fail(pieces);
  const auto framed = std::max_element(
      pieces->begin(), pieces->end(),
      [](const Polygon& a, const Polygon& b) { return SignedArea(a.outer) < SignedArea(b.outer); });
  if (framed == pieces->end() || framed->holes.size() != 1) {
    return Fail(ErrorCode::kDegenerateGeometry, "a polygon can't be moved outward that far",
                "try a smaller distance");
  }
  Polygon grown{Reversed(std::move(framed->holes[0])), {}};
  for (auto piece = pieces->begin(); piece != pieces->end(); ++piece) {
    if (piece != framed) grown.holes.push_back(Reversed(std::move(piece->outer)));
  }
  return grown;
}

/// The outline grows and each hole shrinks, and neither meets the other.
Result<std::vector<Polygon>> Grow(const Polygon& polygon, double distance) {
  auto grown = GrowOutline(polygon.outer, distance);
  if (!grown) return Fail(grown);
  for (const Ring& hole : polygon.holes) {
    auto left = Shrink({Reversed(hole), {}}, distance);
    if (!left) return Fail(left);
    for (Polygon& piece : *left) grown->holes.push_back(Reversed(std::move(piece.outer)));
  }
  return std::vector<Polygon>{std::move(*grown)};
}

}  // namespace

Result<std::vector<Polygon>> Offset(const Polygon& polygon, double distance_m) {
  if (distance_m == 0) return std::vector<Polygon>{polygon};
  auto pieces = distance_m > 0 ? Shrink(polygon, distance_m) : Grow(polygon, -distance_m);
  if (!pieces) return Fail(pieces);
  DropSlivers(&*pieces);
  return pieces;
}

std::vector<Polygon> Border(const Polygon& whole, const std::vector<Polygon>& parts) {
  // The boundary of the difference: the whole's rings as they are, the parts' turned round.
  std::vector<Ring> outlines = {whole.outer}, holes = whole.holes;
  for (const Polygon& part : parts) {
    holes.push_back(Reversed(part.outer));
    for (const Ring& hole : part.holes) outlines.push_back(Reversed(hole));
  }
  auto border = Nest(std::move(outlines), std::move(holes));
  std::erase_if(border, [](const Polygon& piece) { return Area(piece) < kAreaTolerance_m2; });
  return border;
}

}  // namespace parti::grammar
