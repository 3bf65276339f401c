// Which selector of comp takes a face, an edge or a corner: CGA's classes of directions, and of
// edges on roofs.
#pragma once

#include "grammar/action.h"
#include "grammar/item_edges.h"

namespace parti::grammar {

/// What is known of a component of a shape.
struct Component {
  Vec3 direction{0, 1, 0};  ///< unit, in the world: a face's normal, the mean of an edge's or
                            ///< corner's faces, the outward direction of a planar shape's edge
  int index = 0;            ///< among all components of the kind
  bool on_border = false;   ///< of what is open: border; else: inside
  const ItemEdge* edge = nullptr;  ///< of edges: for eave, hip, valley, ridge
};

/// What directions are compared with.
struct CompFrame {
  Scope scope;                 ///< by CGA's names (NamedScope)
  Vec3 street_front{0, 0, 0};  ///< FrontOf, for street.front …
};

/// Half open quadrants, and CGA's classes of elevation: horizontal beyond 78.75 deg, vertical
/// within 11.25, aslant between them upward, nutant downward; side: all but horizontal.
/// eave: a level edge under a face that slopes, hip and ridge: convex edges between two that do, on
/// the slope or level; valley: a concave one.
bool Matches(const Selector& selector, const Component& component, const CompFrame& frame);

/// The number of the first successor that takes it; -1: none, or NIL.
int SuccessorOf(const Action& action, const Component& component, const CompFrame& frame);

}  // namespace parti::grammar
