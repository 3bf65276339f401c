// What a file says of a lot besides its outline: "floors": 3.
// What rules take of it is lot_values.h's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grammar/rules/rule_set.h"

namespace parti::app {

/// A name and its value.
struct LotProperty {
  std::string name;
  std::optional<grammar::Value> value;  ///< nothing: a list or an object, which no attribute takes
  bool operator==(const LotProperty&) const = default;
};

using LotProperties = std::vector<LotProperty>;

}  // namespace parti::app
