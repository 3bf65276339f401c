// Items moved, turned and resized as a whole, geometry and scope together (CGA's t, r, s, center).
// Which way the axes of an item are called there is decided here, too.
#pragma once

#include "grammar/action.h"
#include "grammar/item.h"

namespace parti::grammar {

/// The scope with its axes by CGA's names: of a planar shape that faces up within 45 deg, y is its
/// normal and z = -y, as lots have it, so that the height of what stands on it is its size along
/// y; of all else the scope itself.
Scope NamedScope(const Item& item);

/// The item in another box, given by the same names: its geometry and texture are moved, turned and
/// stretched with its scope, its facing turned. Sizes are not negative; along those of 0 geometry
/// collapses, and what had none stays so. Remembers where it was for center.
Item Placed(const Item& item, const Scope& named);

/// Metres along an axis of this length.
double Metres(const Size& size, double length_m);

}  // namespace parti::grammar
