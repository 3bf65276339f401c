// The same geometry in a scope with other axes: what CGA's scope operations do.
// Moving geometry together with its scope is item_place.h's.
#pragma once

#include "base/math.h"
#include "grammar/item.h"

namespace parti::grammar {

/// `v` turned about axis 0, 1 or 2, right-handed.
Vec3 TurnedAbout(int axis, const Angle& angle, const Vec3& v);
/// The scope's axes turned about x, then y, then z as they were; origin and size stay.
Scope TurnedAxes(const Scope& scope, const Vec3& angles_deg);

/// The item in a scope with the axes of `axes` that is shrunk to it; nothing moves. Of a planar
/// shape only the direction of x counts, projected into its plane: its z stays the normal, and
/// where x runs along the normal the scope stays as it was. The item is planar or a volume. cost
/// linear in its corners; boxes turned out of their axes become meshes.
Item Reframed(const Item& item, const Scope& axes);

}  // namespace parti::grammar
