// An action made ready for one shape tree: names interned and successors numbered once, so that
// acting on a shape is only geometry and appending.
#pragma once

#include <vector>

#include "base/error.h"
#include "grammar/operation.h"
#include "grammar/shape_tree.h"

namespace parti::grammar {

struct ActionPlan;

/// What becomes of a product: its operations in order, then its symbol.
struct AlternativePlan {
  std::vector<ActionPlan> steps;
  NameId symbol = kNoName;
  bool nil = false;
};

/// One operation, ready to act.
struct ActionPlan {
  enum class Kind : uint8_t { kTag, kSymbol, kChange, kMake };
  Kind kind = Kind::kMake;
  const Action* action = nullptr;
  NameId name = kNoName;  ///< kTag, kSymbol: what is set
  /// By Product::successor; for operations without braces one, for what follows the operation.
  std::vector<AlternativePlan> alternatives;

  /// What follows for one product of the operation.
  const AlternativePlan& AlternativeOf(const Product& product) const;
};

/// Interns the action's names into *tree. The action must outlive the plan.
ActionPlan PlanOf(const Action& action, ShapeTree* tree);

/// Acts on one shape: changes it in place, or makes its children. The first `most` shapes of a tree
/// are allowed.
/// errors  those of Apply;  kLimitReached.
Result<void> Act(const ActionPlan& plan, ShapeIndex shape, uint32_t most, ShapeTree* tree);

}  // namespace parti::grammar
