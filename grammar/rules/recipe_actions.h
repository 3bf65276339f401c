// The actions of a program with their numbers computed for a shape. Each is kept and filled again
// for the next shape, so that nothing is allocated where only numbers change.
#pragma once

#include <vector>

#include "grammar/rules/evaluate.h"
#include "grammar/rules/rule_program.h"

namespace parti::grammar {

/// One per thread.
class RecipeActions {
 public:
  explicit RecipeActions(const RuleProgram& program)
      : program_(program), kept_(program.recipes.size()) {}

  /// A recipe's action in a situation; valid until the same one is asked for again.
  /// errors  those of Check, and of the evaluator.
  Result<const Action*> Computed(const StepPlan& step, const Situation& situation,
                                 Evaluator* evaluator);

 private:
  struct Kept {
    bool is_ready = false;
    Action action;
    std::vector<double*> sizes;  ///< of its successors, counted as Product::successor counts
  };

  const RuleProgram& program_;
  std::vector<Kept> kept_;
};

}  // namespace parti::grammar
