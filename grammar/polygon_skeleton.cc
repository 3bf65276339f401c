#include "grammar/polygon_skeleton.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/create_offset_polygons_from_polygon_with_holes_2.h>
#include <fmt/format.h>

#include <exception>

namespace parti::grammar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalRing = CGAL::Polygon_2<Kernel>;
using CgalPolygon = CGAL::Polygon_with_holes_2<Kernel>;

CgalRing ToCgal(const Ring& ring) {
  CgalRing result;
  for (const Vec2& p : ring) result.push_back({p.x, p.y});
  return result;
}

Ring FromCgal(const CgalRing& ring, bool counter_clockwise) {
  Ring result;
  for (const auto& p : ring.container()) result.emplace_back(p.x(), p.y());
  if ((SignedArea(result) > 0) != counter_clockwise) std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace

Result<std::vector<Polygon>> SkeletonOffset(const Polygon& polygon, double distance_m) {
  try {
    CgalPolygon input(ToCgal(polygon.outer));
    for (const Ring& hole : polygon.holes) input.add_hole(ToCgal(hole));
    std::vector<Polygon> pieces;
    for (const auto& piece :
         CGAL::create_interior_skeleton_and_offset_polygons_with_holes_2(distance_m, input)) {
      pieces.push_back({FromCgal(piece->outer_boundary(), true), {}});
      for (const CgalRing& hole : piece->holes()) {
        pieces.back().holes.push_back(FromCgal(hole, false));
      }
    }
    return pieces;
  } catch (const std::exception&) {
    return Fail(ErrorCode::kDegenerateGeometry,
                fmt::format("a polygon of {} corners can't be offset by {:.4g} m",
                            polygon.outer.size(), distance_m),
                "move corners apart that nearly touch, or try another distance");
  }
}

}  // namespace parti::grammar
