// Loops to polygons: which hole lies in which outline.
// The loops cross nothing: polygon_crossing.h has seen to that.
#pragma once

#include <vector>

#include "grammar/polygon.h"

namespace parti::grammar {

/// The number of the smallest outline around the hole; outlines.size() when there is none. Only the
/// outer rings count.
size_t OutlineAround(const Ring& hole, const std::vector<Polygon>& outlines);

/// One polygon per outline (counter-clockwise), with those of `holes` (clockwise) that lie in it;
/// a hole goes to the smallest outline around it, and one around which there is none is dropped.
/// Loops may touch but not cross. Order of the outlines is kept. O(outlines x corners of holes).
std::vector<Polygon> Nest(std::vector<Ring> outlines, std::vector<Ring> holes);

/// Leaves out corners within kLengthTolerance_m of their predecessor.
void DropRepeatedCorners(Ring* ring);

}  // namespace parti::grammar
