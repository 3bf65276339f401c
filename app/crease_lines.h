// Edges of neighbouring shapes lie on each other: a picture draws such a line once.
// Which edges there are is the items' (grammar::EdgesOf).
#pragma once

#include <vector>

#include "base/math.h"

namespace parti::app {

/// The union of the segments, line by line: those on one line that touch or overlap become one. In
/// order of the first segment of each line, and along it. Lines that agree within about 1 mm over
/// their length are one; some that do are missed, which costs nothing but a line drawn twice.
/// Left out: segments without length, or not finite. n log n.
/// Properties: (1) every point of a given segment lies on the result, and no other;
/// (2) the order and direction of segments change at most the order of the result.
std::vector<Segment3> WithoutOverlaps(const std::vector<Segment3>& segments);

}  // namespace parti::app
