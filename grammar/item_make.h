// Items from geometry: scopes shrunk to what stands in them, rectangles and boxes recognised.
// Shared by the operations; what callers outside the folder use is in item.h.
#pragma once

#include "grammar/item.h"

namespace parti::grammar {

/// What everything keeps that is made of `parent`: color, paint, street.
void Inherit(const Item& parent, Item* item);

/// A planar item with the axes of `frame` from a polygon in its coordinates, heir to `parent`.
Item PlanarItem(const Scope& frame, Polygon polygon, const Item& parent);
/// A volume with the axes of `frame`, whose y must be its axis nearest to the world's up, from a
/// mesh in its coordinates. Facing from `parent`, heir to it, too.
Item VolumeItem(const Scope& frame, Mesh mesh, const Item& parent);

/// How the axes of a box are named anew so that it stands: axis i was axis source[i], run backwards
/// where flipped[i].
struct Standing {
  int source[3] = {0, 1, 2};
  bool flipped[3] = {false, false, false};
};

/// The naming by which the axis nearest to the world's up is y and x keeps its direction (unless it
/// is the one that is up; then z keeps its own). Of axes as near to up, y is taken before z before
/// x.
Standing StandingOf(const Scope& scope);
/// The same box under that naming.
Scope StandUp(const Scope& scope, const Standing& standing);
/// A point of the box of `size` under that naming.
Vec3 StandUp(const Vec3& local, const Vec3& size, const Standing& standing);

}  // namespace parti::grammar
