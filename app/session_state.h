// What a session knows, as one value: undo is a list of these. Large parts are shared, never
// changed.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/lot.h"
#include "base/camera.h"
#include "base/stroke.h"
#include "grammar/selection_action.h"
#include "sketch/suggestion.h"

namespace parti::app {

/// A stroke in the pixels of the view that it was drawn in.
struct DrawnStroke {
  Stroke stroke;
  Camera camera;
};

/// What was built: the lots, the rules, and what the rules make of each lot.
struct Model {
  std::vector<Lot> lots;
  /// One per lot: its tree before any rule has run. Shared by all models on the same lots.
  std::vector<std::shared_ptr<const grammar::ShapeTree>> roots;
  grammar::Trees trees;
  /// One per lot: its shape tree and every node's selection.
  std::vector<std::shared_ptr<const grammar::Derivation>> derived;
};

/// A model on these lots.
/// errors  those of grammar::Derive; the message names the lot where there are several.
Result<Model> BuiltOn(std::vector<Lot> lots, grammar::Trees trees);

/// The same lots under other rules; nodes that did not change are not run again. errors as BuiltOn.
Result<Model> WithTrees(const Model& model, grammar::Trees trees);

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

/// The strokes that no suggestion has been picked for yet, and what they may mean.
struct Sketch {
  std::vector<std::shared_ptr<const DrawnStroke>> strokes;
  std::optional<ShapeRef> target;  ///< the shape drawn on
  sketch::Configuration lines;
  std::vector<sketch::Suggestion> suggestions;  ///< best first
};

/// One entry of the history: a stroke, or a command.
struct HistoryEntry {
  std::shared_ptr<const DrawnStroke> stroke;  ///< null for a command
  std::optional<Command> command;
};

/// A stroke group and what became of it, for `replay --json` and bug reports.
struct Step {
  std::vector<size_t> strokes;      ///< their numbers in the session, from 0
  std::string target;               ///< its id
  std::vector<std::string> ranked;  ///< the suggested actions as text
  std::string chosen;               ///< as it was when picked
};

/// Everything that undo brings back.
struct SessionState {
  Camera camera;
  Model model;
  Sketch sketch;
  std::vector<std::shared_ptr<const DrawnStroke>> strokes;  ///< all, in the order drawn
  std::vector<int> last_node;  ///< path of the node just made; empty: none
  std::vector<Step> steps;
};

}  // namespace parti::app
