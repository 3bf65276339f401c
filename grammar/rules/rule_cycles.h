// Attributes whose value can't be computed, because it depends on itself.
// Functions and rules without end are the evaluator's limits' to stop.
#pragma once

#include <cstdint>
#include <vector>

#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// Indices of attributes whose value, directly or through attributes and functions, depends on
/// itself; ascending. Functions that call themselves are none of them: a case may end them.
/// cost  linear in the expressions; needs no stack.
std::vector<uint32_t> AttributesThatNeedThemselves(const RuleSet& rules);

}  // namespace parti::grammar
