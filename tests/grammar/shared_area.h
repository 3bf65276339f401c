// The area that two polygons share, by a way of its own: for tests of what cuts polygons.
#pragma once

#include "grammar/polygon.h"

namespace parti::grammar::tests {

/// The plane is cut into horizontal strips at every corner and crossing; within one, all edges are
/// straight and none cross, so that what is shared at mid height times the height is exact. n^2.
double SharedArea(const Polygon& a, const Polygon& b);

}  // namespace parti::grammar::tests
