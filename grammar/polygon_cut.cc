#include "grammar/polygon_cut.h"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>
#include <utility>

#include "grammar/polygon_nesting.h"

namespace parti::grammar {
namespace {

/// One cut: polygons go in as integers on the grid, and come out again. Clipper's own nesting
/// (PolyTree) and ioStrictlySimple each lose or double areas in about 1 % of random setbacks.
class Cut {
 public:
  explicit Cut(double grid_m) : grid_(grid_m) {}

  void Add(const Polygon& polygon, ClipperLib::PolyType type) {
    clipper_.AddPath(PathOf(polygon.outer), type, true);
    for (const Ring& hole : polygon.holes) clipper_.AddPath(PathOf(hole), type, true);
  }

  Result<std::vector<Polygon>> Run(ClipperLib::ClipType type) {
    try {
      ClipperLib::Paths paths;
      if (clipper_.Execute(type, paths, ClipperLib::pftNonZero, ClipperLib::pftNonZero)) {
        return PolygonsFrom(paths);
      }
    } catch (const ClipperLib::clipperException&) {
      // Out of its range: told below, as for what it refuses.
    }
    return Fail(ErrorCode::kDegenerateGeometry, "a polygon can't be cut", "move its corners apart");
  }

 private:
  ClipperLib::Path PathOf(const Ring& ring) const {
    ClipperLib::Path path;
    path.reserve(ring.size());
    for (const Vec2& p : ring) {
      path.emplace_back(std::llround(p.x / grid_), std::llround(p.y / grid_));
    }
    return path;
  }

  Ring RingFrom(const ClipperLib::Path& path) const {
    Ring ring;
    ring.reserve(path.size());
    for (const ClipperLib::IntPoint& p : path) {
      ring.push_back(Vec2(static_cast<double>(p.X), static_cast<double>(p.Y)) * grid_);
    }
    DropRepeatedCorners(&ring);
    return ring;
  }

  /// Outlines run counter-clockwise, holes clockwise; slivers are neither.
  std::vector<Polygon> PolygonsFrom(const ClipperLib::Paths& paths) const {
    std::vector<Ring> outlines, holes;
    for (const ClipperLib::Path& path : paths) {
      Ring ring = RingFrom(path);
      if (ring.size() < 3 || std::abs(SignedArea(ring)) < kAreaTolerance_m2) continue;
      (SignedArea(ring) > 0 ? outlines : holes).push_back(std::move(ring));
    }
    return Nest(std::move(outlines), std::move(holes));
  }

  double grid_;
  ClipperLib::Clipper clipper_;
};

}  // namespace

double CutGrid(const Polygon& polygon) {
  const Box2 box = Bounds(polygon);
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  return std::exp2(std::ceil(std::log2(extent)) - 31);
}

Result<std::vector<Polygon>> Intersection(const Polygon& a, const Polygon& b, double grid_m) {
  Cut cut(grid_m);
  cut.Add(a, ClipperLib::ptSubject);
  cut.Add(b, ClipperLib::ptClip);
  return cut.Run(ClipperLib::ctIntersection);
}

Result<std::vector<Polygon>> Without(const Polygon& polygon, std::span<const Polygon> parts,
                                     double grid_m) {
  Cut cut(grid_m);
  cut.Add(polygon, ClipperLib::ptSubject);
  for (const Polygon& part : parts) cut.Add(part, ClipperLib::ptClip);
  return cut.Run(ClipperLib::ctDifference);
}

Result<std::vector<Polygon>> Union(std::span<const Polygon> parts, double grid_m) {
  if (parts.empty()) return std::vector<Polygon>();  // which Clipper would refuse
  Cut cut(grid_m);
  for (const Polygon& part : parts) cut.Add(part, ClipperLib::ptSubject);
  return cut.Run(ClipperLib::ctUnion);
}

}  // namespace parti::grammar
