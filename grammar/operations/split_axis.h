// Which axis of an item's scope a split or segment goes along (language.md, Scopes).
// Where along it the cuts lie is the business of split_sizes.h.
#pragma once

#include "base/error.h"
#include "grammar/action.h"
#include "grammar/item.h"

namespace parti::grammar {

/// The axis (0: x, 1: y, 2: z) of the item that the action's first argument names. On flat items
/// that lie level, where CGA says z for depth, y and z are both the second in-plane axis.
/// errors  kBadArguments  z of an upright flat item, which has no extent there.
Result<int> AxisIn(const Item& item, const Action& action);

}  // namespace parti::grammar
