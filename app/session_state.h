// What a session knows, as one value: undo is a list of these. Large parts are shared, never
// changed.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/lot.h"
#include "app/rule_source.h"
#include "base/camera.h"
#include "base/stroke.h"
#include "grammar/generalise.h"
#include "grammar/rules/rule_derivation.h"
#include "grammar/selection_action.h"
#include "sketch/suggestion.h"

namespace parti::app {

/// A stroke in the pixels of the view that it was drawn in.
struct DrawnStroke {
  Stroke stroke;
  Camera camera;
  uint32_t number = 0;  ///< in the order drawn, from 0; never used again, undone or not
};

/// What the rules run on; shared by all models on the same lots.
struct Ground {
  std::vector<Lot> lots;
  /// One per lot: its tree before any selection-action tree has run; what the source's rules made.
  std::vector<std::shared_ptr<const grammar::ShapeTree>> roots;
  std::shared_ptr<const RuleSource> source;  ///< null: no rules, each root is its lot alone
  /// The same without roots, where rules made them: what undo keeps of distant steps. Else null.
  std::shared_ptr<const Ground> underived;
};

/// A node that some shapes of a lot could not take: it stays, and acts on the others.
struct NodeProblem {
  std::vector<int> path;
  size_t lot = 0;
  size_t shapes = 0;  ///< how many; 0: its query can't be answered
  Error error;        ///< names the node and the first shape
};

/// What was built: the lots, the rules, and what the rules make of each lot. Cheap to copy; the
/// parts are shared and never change. `ground` and `rules` are never null.
struct Model {
  std::shared_ptr<const Ground> ground = std::make_shared<const Ground>();
  std::shared_ptr<const grammar::Trees> rules = std::make_shared<const grammar::Trees>();
  /// One per lot: its shape tree and every node's selection.
  std::vector<std::shared_ptr<const grammar::Derivation>> derived;

  const std::vector<Lot>& lots() const { return ground->lots; }
  const grammar::Trees& trees() const { return *rules; }
};

/// Lots with their roots, and no rules.
std::shared_ptr<const Ground> GroundOf(std::vector<Lot> lots);

/// Lots with what the rules of a source (may be null) make of them.
/// errors  those of ValuesOf (lot_values.h) and grammar::DeriveRules, and of RulesOf the first.
Result<std::shared_ptr<const Ground>> GroundOf(std::vector<Lot> lots,
                                               std::shared_ptr<const RuleSource> source);
/// The same with rules that were read before.
Result<std::shared_ptr<const Ground>> GroundOf(std::vector<Lot> lots,
                                               std::shared_ptr<const RuleSource> source,
                                               const grammar::RuleSet& rules,
                                               const grammar::RuleThreads& threads = {});

/// The ground with its roots: itself where it has them; that of `nearby` (may be null) where that
/// is the same ground; else derived anew. errors  as GroundOf's.
Result<std::shared_ptr<const Ground>> WithRoots(std::shared_ptr<const Ground> ground,
                                                const Model* nearby = nullptr,
                                                const grammar::RuleThreads& threads = {});

/// A model on these lots.
/// errors  those of grammar::Derive; the message names the lot where there are several.
Result<Model> BuiltOn(std::vector<Lot> lots, grammar::Trees trees,
                      grammar::Unfit unfit = grammar::Unfit::kFail);

/// These rules on this ground. Nodes that are as in `previous` (may be null) are not run again.
/// errors as BuiltOn.
Result<Model> Derived(std::shared_ptr<const Ground> ground,
                      std::shared_ptr<const grammar::Trees> rules, const Model* previous,
                      grammar::Unfit unfit = grammar::Unfit::kFail);

/// What the model's nodes could not act on, in the order in which they run, lot by lot.
std::vector<NodeProblem> ProblemsOf(const Model& model);

/// One shape of one lot.
struct ShapeRef {
  size_t lot = 0;
  grammar::ShapeIndex shape = 0;
  bool operator==(const ShapeRef&) const = default;
};

/// "0/2/5", with "lot-3:" before it where there are several lots (docs/interfaces.md).
std::string IdOf(const Model& model, const ShapeRef& ref);

/// Leaves of all lots: what is visible, in a fixed order.
std::vector<ShapeRef> VisibleShapes(const Model& model);

/// ref is one of the model's.
const grammar::Shape& ShapeAt(const Model& model, const ShapeRef& ref);

/// The shape of an id as IdOf writes it. errors  kBadText  not such an id;  kUnknownName  no shape
/// there.
Result<ShapeRef> RefAt(const Model& model, std::string_view id);

/// The strokes that no suggestion has been picked for yet, and what they may mean.
struct Sketch {
  std::vector<std::shared_ptr<const DrawnStroke>> strokes;
  /// Drawn since the last pick and meaning nothing: ink that waits to be erased or cleared.
  std::vector<std::shared_ptr<const DrawnStroke>> unread;
  /// What it is to act on, as chosen with `query`; nothing: what it is drawn on.
  std::optional<grammar::Query> query;
  std::optional<ShapeRef> target;  ///< the shape drawn on
  sketch::Configuration lines;
  std::vector<sketch::Suggestion> suggestions;  ///< best first
};

/// Shapes that were tapped, and the queries that may be meant by them.
struct Selection {
  std::vector<ShapeRef> shapes;  ///< in the order tapped
  /// What `query 1` … take; best first.
  std::vector<grammar::QueryCandidate> candidates;
};

/// The shapes with their candidates.
Selection SelectionOf(const Model& model, std::vector<ShapeRef> shapes);

/// A view that was kept under a name.
struct NamedView {
  std::string name;
  Camera camera;
  bool operator==(const NamedView&) const = default;
};

/// One entry of the history: a stroke, or a command.
struct HistoryEntry {
  std::shared_ptr<const DrawnStroke> stroke;  ///< null for a command
  std::optional<Command> command;
};

/// A stroke group and what became of it, for `replay --json` and bug reports.
struct Step {
  std::vector<uint32_t> strokes;    ///< their numbers in the session
  std::string target;               ///< its id
  std::vector<std::string> ranked;  ///< the suggested actions as text
  std::string chosen;               ///< as it was when picked
};

/// Everything that undo brings back.
struct SessionState {
  Camera camera;
  Model model;
  Sketch sketch;
  Selection selection;
  std::vector<NamedView> views;  ///< in the order first kept
  /// Path of the node in hand, the one just made or taken; empty: none.
  std::vector<int> in_hand;
  bool just_made = false;  ///< the node in hand was made, not taken: a tap lets it go
  /// Where SessionOptions::keep_steps asks for them.
  std::vector<std::shared_ptr<const Step>> steps;
};

}  // namespace parti::app
