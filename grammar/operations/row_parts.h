// What rows of several kinds share: parameters that mean the same, and doing nothing to the item.
// What roofs share is roof_parts.h's.
#pragma once

#include <string_view>
#include <vector>

#include "grammar/operations/rows.h"

namespace parti::grammar {

/// Of up to ten turns either way, in degrees; 0 unless given.
Parameter TurnParameter(std::string_view name, std::string_view doc);
/// CGA's texture layer.
Parameter UvSetParameter();

/// The item itself: what the row is for is its driver's (symbol, report).
Result<std::vector<Product>> Unchanged(const Item& item, const Action& action);

}  // namespace parti::grammar
