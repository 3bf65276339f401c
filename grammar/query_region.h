// Filters that ask where a shape stands and how large it is: inside, intersects, facing, within,
// larger, smaller (language.md, Queries). Exact up to kRegionTolerance_m: on triangles, not on
// bounding boxes, except where said.
#pragma once

#include "grammar/query_filter.h"

namespace parti::grammar {

/// Touching is intersecting, and lying on the border is inside, up to this.
inline constexpr double kRegionTolerance_m = 1e-6;
/// facing(query) holds up to this angle between a shape's normal and the way to the other shape.
inline constexpr Angle kFacing = Angle::Degrees(45);

/// inside      all corners in the volume; with a query, all in one of its shapes.
/// intersects  some point in both; a solid that encloses the other counts.
/// facing      the way from the middle of the shape to the nearest point of the other's scope is
///             within kFacing of the normal; seen from above where the normal is horizontal within
///             45 degrees, so that a high window still faces the road. Nothing hides anything.
/// within      the smallest distance between both surfaces; 0 where they meet.
/// larger, smaller  AreaOf the item.
/// A shape is never compared with itself. A filter that passed CheckFilter; the tree must outlive
/// the test.
/// cost  a query's shapes are sorted once; a test looks at those whose boxes are near.
/// errors  those of the inner query's ProductOf.
Result<ShapeTest> RegionTestOf(const Filter& filter, const ShapeTree& tree);

}  // namespace parti::grammar
