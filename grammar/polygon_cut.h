// Parts of polygons: what is shared, what is left, what parts make together.
// Corners are rounded to a fine grid, so that slivers between parts that should touch are none;
// scenes, which must keep every bit, have layers/polygon_overlap.h.
#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "grammar/polygon.h"

namespace parti::grammar {

/// The grid of a polygon's cuts: 2^-31 of the longer side of its bounds (14 nm of 30 m).
double CutGrid(const Polygon& polygon);

/// The pieces that lie in both, in a fixed order.
/// errors  kDegenerateGeometry  a polygon that the library refuses: not simple.
/// cost    O(n log n) in the corners and crossings.
Result<std::vector<Polygon>> Intersection(const Polygon& a, const Polygon& b, double grid_m);

/// The pieces of the polygon that no part covers. errors, cost  as Intersection.
Result<std::vector<Polygon>> Without(const Polygon& polygon, std::span<const Polygon> parts,
                                     double grid_m);

/// What the parts cover together. errors, cost  as Intersection.
Result<std::vector<Polygon>> Union(std::span<const Polygon> parts, double grid_m);

}  // namespace parti::grammar
