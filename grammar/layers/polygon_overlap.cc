#include "grammar/layers/polygon_overlap.h"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>
#include <unordered_map>
#include <utility>

#include "grammar/polygon_nesting.h"

namespace parti::grammar {
namespace {

using ClipperLib::cInt;

/// Clipper computes with integers: this part of the larger polygon's extent is 1. With it, products
/// stay within its range, and rounding far below SceneTolerance.
constexpr double kUnitsInExtent = 4e9;

/// To Clipper's integers and back; corners and edges along the axes come back to the last bit.
class Grid {
 public:
  explicit Grid(const Box2& bounds) : origin_(bounds.low) {
    const Vec2 size = bounds.high - bounds.low;
    unit_ = std::max(size.x, size.y) / kUnitsInExtent;
  }

  ClipperLib::Path PathOf(const Ring& ring) {
    ClipperLib::Path path;
    path.reserve(ring.size());
    for (const Vec2& p : ring) path.emplace_back(Enter(p.x, 0), Enter(p.y, 1));
    return path;
  }

  Ring RingFrom(const ClipperLib::Path& path) const {
    Ring ring;
    ring.reserve(path.size());
    for (const ClipperLib::IntPoint& p : path) ring.emplace_back(Leave(p.X, 0), Leave(p.Y, 1));
    return ring;
  }

 private:
  /// Of values that fall on one integer, the first is what it means.
  cInt Enter(double value, int axis) {
    const cInt integer = std::llround((value - origin_[axis]) / unit_);
    known_[axis].emplace(integer, value);
    return integer;
  }
  double Leave(cInt integer, int axis) const {
    const auto known = known_[axis].find(integer);
    if (known != known_[axis].end()) return known->second;
    return origin_[axis] + static_cast<double>(integer) * unit_;
  }

  Vec2 origin_;
  double unit_;
  std::unordered_map<cInt, double> known_[2];
};

void Add(const Polygon& polygon, ClipperLib::PolyType type, Grid* grid,
         ClipperLib::Clipper* clipper) {
  clipper->AddPath(grid->PathOf(polygon.outer), type, true);
  for (const Ring& hole : polygon.holes) clipper->AddPath(grid->PathOf(hole), type, true);
}

/// Outlines run counter-clockwise, holes clockwise; slivers are neither.
std::vector<Polygon> PolygonsFrom(const ClipperLib::Paths& paths, const Grid& grid) {
  std::vector<Ring> outlines, holes;
  for (const ClipperLib::Path& path : paths) {
    Ring ring = grid.RingFrom(path);
    const double area = SignedArea(ring);
    if (std::abs(area) < kAreaTolerance_m2) continue;
    (area > 0 ? outlines : holes).push_back(std::move(ring));
  }
  return Nest(std::move(outlines), std::move(holes));
}

Box2 BoundsOf(const Polygon& a, const Polygon& b) {
  const Box2 p = Bounds(a), q = Bounds(b);
  return {glm::min(p.low, q.low), glm::max(p.high, q.high)};
}

}  // namespace

Result<std::vector<Polygon>> Overlap(const Polygon& a, const Polygon& b) {
  Grid grid(BoundsOf(a, b));
  // Clipper's own nesting (PolyTree) and ioStrictlySimple each lose areas, or give some twice, of
  // about one in 1,000 pairs that abut along slanted edges.
  ClipperLib::Paths paths;
  try {
    ClipperLib::Clipper clipper;
    Add(a, ClipperLib::ptSubject, &grid, &clipper);
    Add(b, ClipperLib::ptClip, &grid, &clipper);
    if (clipper.Execute(ClipperLib::ctIntersection, paths, ClipperLib::pftNonZero,
                        ClipperLib::pftNonZero)) {
      return PolygonsFrom(paths, grid);
    }
  } catch (const ClipperLib::clipperException&) {
    // Coordinates out of range: told below, as for what it refuses.
  }
  return Fail(ErrorCode::kDegenerateGeometry, "two shapes of a scene can't be cut to one another",
              "move their corners apart");
}

}  // namespace parti::grammar
