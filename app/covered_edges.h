// Edges that lie on the back of a face: a wall's top where a roof runs on beyond it. Lines are
// drawn a little nearer than they are, and so such a line would come through the roof. Which edges
// there are is the items' (grammar::EdgesOf), drawing them render's.
#pragma once

#include <span>
#include <vector>

#include "grammar/shape_tree.h"

namespace parti::app {

/// Edges on the backs of faces that look one way.
struct CoveredEdges {
  Vec3 normal;  ///< unit; an eye in front of these faces does not see the edges
  std::vector<Segment3> edges;
};

/// All edges of some shapes, cut where they begin or cease to be covered.
struct SortedEdges {
  std::vector<Segment3> open;
  std::vector<CoveredEdges> covered;                ///< in the order in which their faces come
  std::vector<grammar::ShapeIndex> covered_shapes;  ///< that have such edges, in the order given
};

/// Which parts faces cover, edge_cover.h says; the first face that covers a part of an edge takes
/// it. Properties: (1) every point of an edge lies on the result, and no other; (2) without faces
/// that cover all edges are open, in their order. cost  about linear, by a grid over the plan.
SortedEdges SortEdges(const grammar::ShapeTree& tree, std::span<const grammar::ShapeIndex> shapes);

}  // namespace parti::app
