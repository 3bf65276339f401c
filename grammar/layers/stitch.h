// Sums and differences of polygons that don't overlap: edges that two of them share cancel, and
// what is left is traced. No general boolean, so that thousands of rectangles stay exact and cheap.
// Parts that do overlap are first cut to what is shared (region.h).
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "grammar/polygon.h"

namespace parti::grammar {

/// In a scene of this extent, corners nearer to each other are one, and narrower pieces none.
constexpr double SceneTolerance(double extent_m) { return 1e-7 * std::max(1.0, extent_m * 0.01); }

/// What is no piece.
struct Negligible {
  double length_m = 0;  ///< SceneTolerance
  double area_m2 = 0;
};

/// All of `plus` without `minus`, as simple polygons in a fixed order. Neighbours that share an
/// edge become one; where corners meet only, pieces and holes stay apart and share the corner.
///
/// plus, minus  simple; overlapping neither within each list nor, `minus`, what lies outside of
///              `plus`, by more than negligible lengths. Their order does not matter.
/// corners      along the axes that are as near as negligible.length_m get equal coordinates, those
///              of `plus` first; corners on an edge along an axis that neither turns are dropped.
/// cost         O(n log n) in the corners, and those that lie near slanted edges.
std::vector<Polygon> Stitch(std::span<const Polygon> plus, std::span<const Polygon> minus,
                            const Negligible& negligible);

}  // namespace parti::grammar
