// Rules made ready to run: names interned, constant operations built once, bodies sorted into those
// that only change a shape and those that make several. Made once, then shared by threads.
// Running is rule_runner.h's.
#pragma once

#include <array>
#include <bit>
#include <optional>
#include <vector>

#include "grammar/operation.h"
#include "grammar/rules/rule_set.h"
#include "grammar/shape_tree.h"

namespace parti::grammar {

/// An operation as it stands in a rule, and what in it is computed for each shape anew.
struct ActionRecipe {
  struct Computed {
    uint32_t index;  ///< of Action::arguments, or of a size counted as Product::successor counts
    const Expression* expression;
  };
  Action action;  ///< with all that is constant in its place
  std::vector<Computed> arguments;
  std::vector<Computed> sizes;
  std::optional<Error> unfit;  ///< of Check or its file, where nothing is computed
  std::string folder;          ///< of the rules it stands in, where it names a file

  bool constant() const { return arguments.empty() && sizes.empty(); }  ///< nothing is computed
};

struct BodyPlan;
class AssetLibrary;

/// A statement, ready to run.
struct StepPlan {
  const Statement* statement = nullptr;
  uint32_t recipe = 0;               ///< kOperation: of RuleProgram::recipes
  NameId symbol = kNoName;           ///< kSymbol
  bool is_nil = false;               ///< kSymbol: the end of the shape at hand
  std::vector<BodyPlan> successors;  ///< by Product::successor
  uint32_t closing = 0;              ///< kPush: the step that pops
};

/// What happens to a shape.
struct BodyPlan {
  const Body* body = nullptr;
  uint32_t rule = kNoRule;             ///< that it stands in
  std::vector<StepPlan> steps;         ///< kSequence
  std::vector<BodyPlan> alternatives;  ///< kCase, kChance
  /// Nothing but operations without braces, and at most one symbol, at the end: in braces the child
  /// itself becomes what the body makes.
  bool is_simple = false;
  bool is_nil = false;  ///< simple, and makes nothing whatever the shape
  /// By type of shape (TypeNumber): the first step that can't take what comes to it, nor what the
  /// normalisation makes of that (out_type of Listing 4.1; errata 1). Null: all can.
  std::array<const StepPlan*, 6> unfit{};
};

/// Of BodyPlan::unfit.
constexpr size_t TypeNumber(ItemType type) {
  return static_cast<size_t>(std::countr_zero(static_cast<unsigned>(type)));
}
/// Whether a shape must first become planar before the row can take it (errata 1).
bool MustWait(const Operation& row, ItemType type);
/// Whether the row makes layers or 2D shapes of a shape of this type.
bool MakesScene(const Operation& row, ItemType type);

/// Whether the row has one result that takes the place of what it was made from: no braces, and
/// never a 2D shape, which needs the shape that it lies in.
bool OnlyChanges(const Operation& row);

/// Immutable once made. The rule set must outlive it.
struct RuleProgram {
  const RuleSet* rules = nullptr;
  std::vector<BodyPlan> bodies;  ///< one per rule
  std::vector<ActionRecipe> recipes;
  uint32_t start = kNoRule;
  ShapeTree names;  ///< a tree that knows every symbol of the rules: trees begin as its copies
  AssetLibrary* assets = nullptr;  ///< outlives it; null: files are not read
};

/// errors  none: names and types were checked when the rules were read.
RuleProgram ProgramOf(const RuleSet& rules, const std::string& start,
                      AssetLibrary* assets = nullptr);

}  // namespace parti::grammar
