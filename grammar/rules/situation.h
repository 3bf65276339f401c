// What an expression can see of the shape that it is computed for.
// How expressions are computed is evaluate.h's; where the numbers come from is the rule driver's.
#pragma once

#include <cstdint>
#include <span>

#include "base/random.h"
#include "grammar/item.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// Which of several a shape is: CGA's split.index and split.total, comp.index and comp.total. A
/// shape keeps those of the last such operation above it.
struct Turn {
  uint32_t index = 0;  ///< from 0
  uint32_t total = 0;  ///< 0: there was no such operation
};

/// Everything is borrowed, and lives as long as the expression is being computed.
struct Situation {
  const Item* item = nullptr;  ///< the shape as it now is
  const Item* lot = nullptr;   ///< the shape that the derivation began with
  Turn split, comp;
  std::span<const Value> attributes;  ///< one per RuleSet::attributes
  std::span<const Value> parameters;  ///< of the rule or function that the expression stands in
  Random* random = nullptr;           ///< the shape's stream
  uint64_t seed = 0;                  ///< of the whole derivation: CGA's seedian
};

}  // namespace parti::grammar
