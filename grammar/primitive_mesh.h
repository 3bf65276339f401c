// The bodies that come without a file: cylinders, cones, spheres, as unit meshes with texture
// coordinates. Cubes are boxes and disks polygons; they need no mesh.
#pragma once

#include <memory>

#include "grammar/mesh.h"

namespace parti::grammar {

inline constexpr int kMostSides = 1000;

/// A regular polygon of n >= 3 corners whose bounds are [0, 1] in x and y, counter-clockwise, with
/// an edge along the bottom: four sides fill the square.
Ring UnitPolygon(int sides);

/// Closed, outward, y up, bounds [0, 1]. The texture runs once around, from the back (-z) over the
/// right (+x), and up; lids take it from above. 3 <= sides, rings <= kMostSides.
Mesh UnitCylinder(int sides);
Mesh UnitCone(int sides);
/// `sides` around, `rings` >= 2 from pole to pole.
Mesh UnitSphere(int sides, int rings);

}  // namespace parti::grammar
