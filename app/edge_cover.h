// What a face hides of edges that lie in its plane, behind it: lines are drawn a little nearer than
// they are, and so would come through.
// Which faces and edges there are is covered_edges.h's.
#pragma once

#include <vector>

#include "grammar/shape_tree.h"

namespace parti::app {

/// A face that may cover edges of other shapes.
struct EdgeCover {
  grammar::Item face;
  grammar::ShapeIndex owner;  ///< the shape that it is of
  grammar::Polygon outline;   ///< in the face's scope
};

/// Adds those faces of a shape that look up (kLeastUp): a planar shape, or those of a body other
/// than a box, an asset or a primitive.
void AddCovers(const grammar::Item& item, grammar::ShapeIndex owner,
               std::vector<EdgeCover>* covers);

inline constexpr double kLeastUp = 0.02;  ///< of a unit normal's y

/// False where the item's box doesn't reach from behind the face's plane to it: none of its edges
/// is covered then.
bool MayCover(const EdgeCover& cover, const grammar::Item& item);

/// A part of an edge.
struct EdgeSpan {
  double from, to;  ///< in [0, 1], from < to
};

/// The parts of an item's edge that an eye in front of the face does not see: those that lie in its
/// plane, at least kCoverInset_m from its border, where the item goes away to its back on all sides
/// of the edge; and the last kCoveredEnd_m of an edge that comes from behind and ends so. In order,
/// apart from each other.
std::vector<EdgeSpan> CoveredSpans(const EdgeCover& cover, const grammar::Item& item,
                                   const Segment3& edge);

inline constexpr double kCoverInset_m = 2e-3;
inline constexpr double kCoveredEnd_m = 0.05;

}  // namespace parti::app
