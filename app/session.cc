#include "app/session.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/edit_nodes.h"
#include "grammar/operation.h"
#include "sketch/target.h"

namespace parti::app {
namespace {

/// Lines drawn in several views belong to the shape that the first view's were drawn on.
Result<Sketch> ReadOnTarget(const SessionState& state, const sketch::SketchParameters& parameters) {
  Sketch sketch{state.sketch.strokes, state.sketch.target, {}, {}};
  const grammar::Item& item = ShapeAt(state.model, *sketch.target).item;
  for (const auto& drawn : sketch.strokes) {
    auto lines = sketch::LiftStroke(drawn->stroke, item, drawn->camera, parameters);
    if (!lines) return Fail(lines);
    sketch.lines.lines.insert(sketch.lines.lines.end(), lines->begin(), lines->end());
  }
  auto suggestions = sketch::Suggest(sketch.lines, item, parameters);
  if (!suggestions) return Fail(suggestions);
  sketch.suggestions = std::move(*suggestions);
  return sketch;
}

/// The best reading of strokes in one view over all shapes that can be seen.
Result<Sketch> ReadOnVisible(const SessionState& state,
                             const sketch::SketchParameters& parameters) {
  const std::vector<ShapeRef> visible = VisibleShapes(state.model);
  std::vector<grammar::Item> items;
  items.reserve(visible.size());
  for (const ShapeRef& ref : visible) items.push_back(ShapeAt(state.model, ref).item);
  std::vector<Stroke> strokes;
  for (const auto& drawn : state.sketch.strokes) strokes.push_back(drawn->stroke);

  auto ranked = sketch::RankTargets(strokes, state.camera, items, parameters);
  if (!ranked) return Fail(ranked);
  sketch::RankedTarget& best = ranked->front();
  return Sketch{state.sketch.strokes, visible[best.item], std::move(best.reading.configuration),
                std::move(best.reading.suggestions)};
}

Result<Sketch> Read(const SessionState& state, const sketch::SketchParameters& parameters) {
  const auto& strokes = state.sketch.strokes;
  const bool one_view = std::all_of(strokes.begin(), strokes.end(), [&](const auto& drawn) {
    return drawn->camera == state.camera;
  });
  return one_view || !state.sketch.target ? ReadOnVisible(state, parameters)
                                          : ReadOnTarget(state, parameters);
}

Result<SessionState> Rebuilt(SessionState state, grammar::Trees trees) {
  auto model = WithTrees(state.model, std::move(trees));
  if (!model) return Fail(model);
  state.model = std::move(*model);
  state.sketch = {};
  return state;
}

size_t Chosen(const Pick& pick, const std::vector<sketch::Suggestion>& suggestions) {
  const auto is_meant = [&](const sketch::Suggestion& s) {
    return pick.operation.empty() || s.action.operation->name == pick.operation;
  };
  const auto number = static_cast<size_t>(pick.number - 1);
  if (number < suggestions.size() && is_meant(suggestions[number])) return number;
  if (pick.operation.empty()) return suggestions.size();
  return static_cast<size_t>(std::find_if(suggestions.begin(), suggestions.end(), is_meant) -
                             suggestions.begin());
}

std::vector<size_t> StrokeNumbers(const SessionState& state) {
  std::vector<size_t> numbers;
  for (const auto& drawn : state.sketch.strokes) {
    const auto at = std::find(state.strokes.begin(), state.strokes.end(), drawn);
    numbers.push_back(static_cast<size_t>(at - state.strokes.begin()));
  }
  return numbers;
}

Result<SessionState> Picked(SessionState state, const Pick& pick) {
  const Sketch& sketch = state.sketch;
  const size_t chosen = Chosen(pick, sketch.suggestions);
  if (chosen >= sketch.suggestions.size()) {
    return Fail(ErrorCode::kUnknownName,
                fmt::format("there is no suggestion {} {}", pick.number, pick.operation),
                fmt::format("this sketch has {} suggestions", sketch.suggestions.size()));
  }
  const grammar::Action& action = sketch.suggestions[chosen].action;
  Step step{StrokeNumbers(state), IdOf(state.model, *sketch.target), {}, grammar::TextOf(action)};
  for (const auto& s : sketch.suggestions) step.ranked.push_back(grammar::TextOf(s.action));

  const grammar::Derivation& derivation = *state.model.derived[sketch.target->lot];
  grammar::Trees trees = state.model.trees;
  state.last_node =
      InsertNode(&trees, grammar::InsertionPath(derivation, trees, sketch.target->shape),
                 {QueryFor(derivation.tree, sketch.target->shape), action, true, {}});
  state.steps.push_back(std::move(step));
  return Rebuilt(std::move(state), std::move(trees));
}

Result<SessionState> WithLots(SessionState state, const std::string& text) {
  auto lots = ParseLots(text);
  if (!lots) return Fail(lots);
  auto model = BuiltOn(std::move(*lots), state.model.trees);
  if (!model) return Fail(model);
  state.model = std::move(*model);
  state.sketch = {};
  return state;
}

/// Applies an edit to the node just made and derives again.
template <typename Edit>
Result<SessionState> Edited(SessionState state, const Edit& edit) {
  if (state.last_node.empty()) {
    return Fail(ErrorCode::kNothingMade, "there is no node to change yet",
                "pick a suggestion first");
  }
  grammar::Trees trees = state.model.trees;
  if (const auto done = edit(&NodeAt(&trees, state.last_node)); !done) return Fail(done);
  return Rebuilt(std::move(state), std::move(trees));
}

Result<SessionState> WithTypedNode(SessionState state, const std::string& text) {
  auto node = ParseNode(text);
  if (!node) return Fail(node);
  grammar::Trees trees = state.model.trees;
  state.last_node = InsertNode(&trees, {0}, std::move(*node));
  return Rebuilt(std::move(state), std::move(trees));
}

}  // namespace

Session::Session(sketch::SketchParameters parameters) : parameters_(parameters) {}

Session::Session(Model model, const Camera& camera, sketch::SketchParameters parameters)
    : parameters_(parameters) {
  state_.model = std::move(model);
  state_.camera = camera;
}

Result<void> Session::AddStroke(const Stroke& stroke) {
  if (state_.model.lots.empty()) {
    return Fail(ErrorCode::kNothingMade, "there is nothing to draw on yet",
                "begin with a lot: lot rect(20,14)");
  }
  Remember();
  const auto drawn = std::make_shared<const DrawnStroke>(DrawnStroke{stroke, state_.camera});
  history_.push_back({drawn, std::nullopt});
  state_.strokes.push_back(drawn);
  state_.sketch.strokes.push_back(drawn);
  auto reading = Read(state_, parameters_);
  if (!reading) {
    state_.sketch.strokes.pop_back();
    return Fail(reading);
  }
  state_.sketch = std::move(*reading);
  return {};
}

Result<SessionState> Session::After(const Command& command) const {
  return std::visit(
      [&](const auto& c) -> Result<SessionState> {
        using C = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<C, SetLot>) {
          return WithLots(state_, c.lot);
        } else if constexpr (std::is_same_v<C, SetView>) {
          SessionState next = state_;
          next.camera = c.camera;
          return next;
        } else if constexpr (std::is_same_v<C, Pick>) {
          return Picked(state_, c);
        } else if constexpr (std::is_same_v<C, RenameSymbol>) {
          return Edited(state_, [&](auto* node) { return Rename(&node->action, c.from, c.to); });
        } else if constexpr (std::is_same_v<C, SetQuery>) {
          return Edited(state_, [&](auto* node) { return Requery(node, c.query); });
        } else if constexpr (std::is_same_v<C, SetNumber>) {
          return Edited(state_, [&](auto* node) { return Turn(&node->action, c.dial, c.value); });
        } else if constexpr (std::is_same_v<C, AddNode>) {
          return WithTypedNode(state_, c.text);
        } else {
          static_assert(std::is_same_v<C, ClearSketch> || std::is_same_v<C, Undo> ||
                        std::is_same_v<C, Redo>);
          SessionState next = state_;
          next.sketch = {};
          return next;
        }
      },
      command);
}

Result<void> Session::Execute(const Command& command) {
  const bool undo = std::holds_alternative<Undo>(command);
  if (undo || std::holds_alternative<Redo>(command)) {
    auto& from = undo ? undo_ : redo_;
    if (from.empty()) {
      return Fail(ErrorCode::kNothingMade, undo ? "nothing to undo" : "nothing to redo");
    }
    (undo ? redo_ : undo_).push_back(state_);
    const Camera camera = state_.camera;
    state_ = std::move(from.back());
    from.pop_back();
    state_.camera = camera;
  } else {
    auto next = After(command);
    if (!next) return Fail(next);
    if (!std::holds_alternative<SetView>(command)) Remember();
    state_ = std::move(*next);
  }
  history_.push_back({nullptr, command});
  return {};
}

void Session::Remember() {
  undo_.push_back(state_);
  redo_.clear();
}

}  // namespace parti::app
