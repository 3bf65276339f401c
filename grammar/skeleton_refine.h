// Skeletons after CGAL: nodes put where the given edges say, and nodes that fall together joined.
// What roofs and offsets are made of it is polygon_skeleton.h's and roof.h's.
#pragma once

#include "grammar/polygon_skeleton.h"

namespace parti::grammar {

/// Moves corners to those of `polygon`, whose edges the faces belong to, and each node inside to
/// the point that fits the planes of its faces best (least squares, held where they are nearly
/// parallel); then joins nodes that fall together along an edge.
/// Faces keep their numbers. Nodes that nothing refers to any more stay.
void Refine(const Polygon& polygon, double grid_m, Skeleton* skeleton);

}  // namespace parti::grammar
