// The door to CGAL's straight skeleton; polygon_skeleton.cc is the only source that includes it.
// Exceptions of the library end here, as Results.
#pragma once

#include <vector>

#include "grammar/polygon.h"

namespace parti::grammar {

/// The polygon moved inward by distance_m > 0, as CGAL gives it, winding normalised.
/// errors  kDegenerateGeometry  CGAL refuses the polygon.
Result<std::vector<Polygon>> SkeletonOffset(const Polygon& polygon, double distance_m);

}  // namespace parti::grammar
