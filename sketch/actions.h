// Actions as the heuristics make them, from a row of the operation table and estimated numbers.
// Their symbols are left empty; symbols.h gives them names.
#pragma once

#include <vector>

#include "grammar/action.h"
#include "grammar/item.h"

namespace parti::sketch {

/// The row's default action with its first length set (clamped to the row's range).
grammar::Action ActionOfLength(const grammar::Operation& operation, double length_m);

/// offset(distance) { inside: | border: }; CGA's sign, negative is inward.
grammar::Action OffsetAction(const grammar::Operation& offset, double distance_m);

/// comp(f) { selector: | … }.
grammar::Action CompAction(const grammar::Operation& comp,
                           const std::vector<grammar::Selector::Kind>& selectors);

/// split(axis) { size: | … }: sizes in metres, except that the parts of the group that holds the
/// largest float, so that the parts fill an item of another size.
/// groups  one number for each size, the same for sizes that are meant equal.
grammar::Action SplitAction(const grammar::Operation& split, grammar::Axis axis,
                            const std::vector<double>& sizes_m, const std::vector<int>& groups);

/// split(axis) { ~size: }*.
grammar::Action RepeatAction(const grammar::Operation& repeat, grammar::Axis axis, double size_m);

/// roof(byHeight, height).
grammar::Action RoofAction(const grammar::Operation& roof, double height_m);

/// shapeL and its like: { shape: | remainder: }, its widths as by default.
grammar::Action ShapeAction(const grammar::Operation& shape);

/// The axis among the action's arguments; kX where it has none.
grammar::Axis AxisOf(const grammar::Action& action);

}  // namespace parti::sketch
