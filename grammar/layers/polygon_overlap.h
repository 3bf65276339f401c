// What two polygons share: the only general boolean that scenes need.
// Behind this header stands the library that docs/layers.md chooses by measurement.
#pragma once

#include <vector>

#include "base/error.h"
#include "grammar/polygon.h"

namespace parti::grammar {

/// The pieces of area that lie in both polygons, in a fixed order. Corners of the polygons are kept
/// to the last bit; where edges cross, corners are made. A piece may touch itself, its holes or
/// another piece in a corner.
/// errors  kDegenerateGeometry  a polygon that is not simple, or that the library refuses.
/// cost    O(n log n) in the corners, and the crossings.
Result<std::vector<Polygon>> Overlap(const Polygon& a, const Polygon& b);

}  // namespace parti::grammar
