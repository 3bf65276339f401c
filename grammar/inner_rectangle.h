// The largest rectangle in a polygon with holes.
// Finding where it lies is all; cutting it out is polygon_cut.h's business.
#pragma once

#include <optional>

#include "grammar/polygon.h"

namespace parti::grammar {

/// The largest rectangle in the polygon whose sides run along `along` (unit length) and square to
/// it: its corners counter-clockwise, the first two along it. Exact where the polygon's edges run
/// so, too; elsewhere its area is within about 1 % of the largest. Nothing where none is larger
/// than kAreaTolerance_m2. cost  O(m^2 n): m up to 96 places along the polygon, n corners; 10 ms
/// for 100 corners.
std::optional<Ring> InnerRectangle(const Polygon& polygon, const Vec2& along);

/// The largest along any edge that is longer than a quarter of the longest of its ring (CGA), up to
/// 12 directions that differ by 0.6 degrees, longest edges first.
std::optional<Ring> InnerRectangleAlongEdges(const Polygon& polygon);

}  // namespace parti::grammar
