// Runs the rule of one shape: makes its children, and the tasks that they are (Jesus 2018, 4.4;
// CGA). Which task is next, and on which thread, is rule_derivation.h's; what becomes of a scene
// when all in it has run is rule_scene.h's.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "grammar/rules/evaluate.h"
#include "grammar/rules/recipe_actions.h"
#include "grammar/rules/rule_notes.h"
#include "grammar/rules/rule_settings.h"
#include "grammar/rules/rule_task.h"

namespace parti::grammar {

/// What all tasks of one lot have in common; borrowed.
struct LotRun {
  const RuleProgram& program;
  const Item& lot;
  const std::vector<Value>& attributes;
  const RuleLimits& limits;
  uint64_t seed = 0;
  const std::atomic<bool>* cancelled = nullptr;  ///< may be null
  double (*now_s)() = nullptr;                   ///< a clock; may be null
  std::atomic<double>* normalise_s = nullptr;    ///< time for scenes is added to it; may be null
  double until_s = 0;                            ///< by the clock, where limits.seconds says so
  std::string above;                             ///< the id of the tree's root in its lot; "" there
};

/// What a body has in hand, between two of its steps.
struct InHand {
  const Item* whole = nullptr;  ///< the shape's own item, until something changes it
  Item changed;                 ///< else this
  bool is_changed = false;
  bool is_made = false;  ///< by an operation that makes shapes: no longer the shape itself
  bool is_gone = false;  ///< NIL, or an operation that left nothing
  const Operation* made_by = nullptr;
  Inheritance inherited;
  NameId symbol = kNoName;   ///< of what is made and gets no other
  std::vector<NameId> tags;  ///< of what is made

  /// As it now is.
  const Item& item() const { return is_changed ? changed : *whole; }
  /// The item is another one from here on.
  void Become(Item item) {
    changed = std::move(item);
    is_changed = true;
  }
};

/// A body while it runs.
struct BodyRun {
  const BodyPlan* body = nullptr;
  size_t to = 0;                ///< the step before which it ends
  ShapeIndex shape = 0;         ///< that it runs on, and whose children it makes
  ShapeIndex taken = kNoShape;  ///< a child whose place the first that is made takes
  SharedValues parameters;
  Stream* stream = nullptr;
  uint32_t level = 0;
  uint32_t made = 0;          ///< children so far, and places taken
  bool is_successor = false;  ///< in braces: the shape is that of the body around it
  bool has_cut = false;  ///< an operation with braces left nothing of the shape but its products
  InHand hand;
  std::vector<InHand> saved;
};

/// Tasks that a run leaves to be done. Those of 2D shapes and layers belong to the scene of the
/// planar shape that they come of (4.4): `flat` still run before its normalisation, `waiting` want
/// the planar shapes that the normalisation makes of theirs, `deferred` one more (4.3.3).
struct LeftTasks {
  std::vector<RuleTask> next;
  std::vector<RuleTask> flat, waiting, deferred;
  bool has_scene = false;  ///< layers or 2D shapes were made
};

/// One per thread and tree. What comes of a task does not depend on the order in which tasks run,
/// but for the numbers of shapes.
class RuleRunner {
 public:
  /// `notes` gets what is reported and printed; may be null.
  RuleRunner(const LotRun& lot, ShapeTree* tree, NoteBook* notes)
      : lot_(lot),
        tree_(tree),
        notes_(notes),
        evaluator_(*lot.program.rules, lot.limits.steps, notes),
        actions_(lot.program) {}

  /// Runs a task's body; what is left to be done is added to *left.
  /// errors  those of operations, and kWrongItemType, naming rule, shape and place;  kLimitReached
  ///         depth, shapes, reports, steps or time, likewise; cancelled.
  Result<void> Run(RuleTask task, LeftTasks* left);

  ShapeTree& tree() { return *tree_; }                   ///< that is being derived
  const LotRun& lot() const { return lot_; }             ///< what the tasks have in common
  uint64_t steps() const { return evaluator_.steps(); }  ///< of the budget, so far
  /// An error with the rule, the shape's id and the place.
  Error Named(Error error, uint32_t rule, ShapeIndex shape, const TextRange& range) const;

 private:
  Result<void> RunBody(BodyRun* run, size_t from);
  Result<void> RunSteps(BodyRun* run, size_t from, size_t to);
  Result<void> RunStep(const StepPlan& step, BodyRun* run);
  Result<void> RunEach(std::vector<Product> results, size_t from, size_t to, BodyRun* run);
  Result<void> Finish(BodyRun* run);

  Result<std::vector<Product>> Applied(const StepPlan& step, BodyRun* run);
  Result<void> Divide(const StepPlan& step, std::vector<Product> products, BodyRun* run);
  Result<void> Fill(const BodyPlan& body, const Operation& row, Item&& product,
                    Inheritance inherited, BodyRun* run);
  Result<void> Set(const StepPlan& step, BodyRun* run);
  void Name(const Action& action, BodyRun* run);
  Result<void> Note(const Action& action, const Statement& statement, const BodyRun& run);
  Result<void> Emit(const StepPlan& step, BodyRun* run);
  Result<void> GoOnBelow(size_t at, size_t to, BodyRun* run);
  RuleTask Rest(size_t at, size_t to, const BodyRun& run) const;
  Result<void> Wait(size_t at, size_t to, BodyRun* run);
  bool WaitsInside(const BodyRun& run, size_t push) const;

  Result<const BodyPlan*> Choose(const BodyRun& run);
  Result<SharedValues> ArgumentsOf(const StepPlan& step, BodyRun* run);
  Result<ShapeIndex> Place(NameId symbol, const TextRange& range, BodyRun* run);
  void Leave(RuleTask task, bool deferred);
  Result<void> CheckTime(const RuleTask& task);
  Error TooDeep(const StepPlan& step, const BodyRun& run) const;
  Situation SituationOf(const BodyRun& run) const;
  tl::unexpected<Error> Failed(Error error, const BodyRun& run, const TextRange& range) const;

  const LotRun& lot_;
  ShapeTree* tree_;
  NoteBook* notes_;
  Evaluator evaluator_;
  RecipeActions actions_;
  LeftTasks* left_ = nullptr;
  uint32_t until_look_ = 0;  ///< tasks until the clock is looked at again
};

}  // namespace parti::grammar
