#include "app/session_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "app/edit_nodes.h"
#include "app/lot_from_stroke.h"
#include "app/rule_edits.h"
#include "app/sketch_reading.h"
#include "base/check.h"
#include "grammar/operation.h"

namespace parti::app {
namespace {

using grammar::Trees;

/// Why the node at `path` can't act on anything that it selects; nothing where it acts, or selects
/// nothing.
std::optional<Error> FailureOf(const Model& model, const NodePath& path) {
  std::optional<Error> failure;
  for (const auto& derivation : model.derived) {
    for (size_t i = 0; i < derivation->nodes.size(); ++i) {
      if (derivation->nodes[i].path == path && !derivation->nodes[i].selected.empty()) return {};
    }
    for (const grammar::DerivationProblem& problem : derivation->problems) {
      if (derivation->nodes[problem.result].path == path && !failure) failure = problem.error;
    }
  }
  return failure;
}

/// The state with other rules. A node that was edited has to work; the others may have problems.
Result<SessionState> WithRules(SessionState state, Trees trees, const NodePath& edited = {}) {
  auto model = Derived(state.model.ground, std::make_shared<const Trees>(std::move(trees)),
                       &state.model, grammar::Unfit::kSkip);
  if (!model) return Fail(model);
  if (!edited.empty()) {
    if (auto failure = FailureOf(*model, edited)) return tl::unexpected<Error>(std::move(*failure));
  }
  state.model = std::move(*model);
  state.sketch = {};
  state.selection = {};
  return state;
}

Result<SessionState> Do(const SetLot& command, SessionState state, const SessionOptions&) {
  auto lots = ParseLots(command.lot);
  if (!lots) return Fail(lots);
  auto ground = GroundOf(std::move(*lots), state.model.ground->source);
  if (!ground) return Fail(ground);
  auto model = Derived(std::move(*ground), state.model.rules, nullptr, grammar::Unfit::kSkip);
  if (!model) return Fail(model);
  state.model = std::move(*model);
  state.sketch = {};
  state.selection = {};
  return state;
}

Result<SessionState> Do(const SetView& command, SessionState state, const SessionOptions&) {
  state.camera = command.camera;
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

Step StepOf(const SessionState& state, const grammar::Action& chosen) {
  Step step{{}, IdOf(state.model, *state.sketch.target), {}, grammar::TextOf(chosen)};
  for (const auto& drawn : state.sketch.strokes) step.strokes.push_back(drawn->number);
  for (const auto& s : state.sketch.suggestions) step.ranked.push_back(grammar::TextOf(s.action));
  return step;
}

/// Where a node on everything that `query` selects belongs: below the node that made all of it.
NodePath PlaceFor(const grammar::Query& query, const Model& model, const ShapeRef& target) {
  const Trees& trees = model.trees();
  NodePath place = grammar::InsertionPath(*model.derived[target.lot], trees, target.shape);
  for (const auto& derivation : model.derived) {
    const auto selected = grammar::ProductOf(query, derivation->tree);
    if (!selected) continue;
    for (const grammar::ShapeIndex shape : *selected) {
      const NodePath other = grammar::InsertionPath(*derivation, trees, shape);
      const auto split = std::mismatch(place.begin(), place.end(), other.begin(), other.end());
      place.erase(std::max(split.first, place.begin() + 1), place.end());
      if (place.size() == 1) return place;
    }
  }
  return place;
}

Result<SessionState> Do(const Pick& command, SessionState state, const SessionOptions& options) {
  const Sketch& sketch = state.sketch;
  const size_t chosen = Chosen(command, sketch.suggestions);
  if (chosen >= sketch.suggestions.size()) {
    return Fail(ErrorCode::kUnknownName,
                fmt::format("there is no suggestion {} {}", command.number, command.operation),
                fmt::format("this sketch has {} suggestions", sketch.suggestions.size()));
  }
  const grammar::Action& action = sketch.suggestions[chosen].action;
  const grammar::Derivation& derivation = *state.model.derived[sketch.target->lot];
  Trees trees = state.model.trees();
  const NodePath place = sketch.query
                             ? PlaceFor(*sketch.query, state.model, *sketch.target)
                             : grammar::InsertionPath(derivation, trees, sketch.target->shape);
  const grammar::Query query =
      sketch.query ? *sketch.query : QueryFor(derivation.tree, sketch.target->shape);
  if (options.keep_steps) {
    state.steps.push_back(std::make_shared<const Step>(StepOf(state, action)));
  }
  state.in_hand = InsertNode(&trees, place, {query, action, true, {}});
  state.just_made = true;
  const NodePath made = state.in_hand;
  return WithRules(std::move(state), std::move(trees), made);
}

/// Applies `edit` to a copy of the rules at the node in hand, which has to work afterwards.
template <typename Edit>
Result<SessionState> WithNodeInHand(SessionState state, const Edit& edit) {
  if (state.in_hand.empty()) {
    return Fail(ErrorCode::kNothingMade, "there is no node to change",
                "pick a suggestion, or take a node: take 0/0");
  }
  Trees trees = state.model.trees();
  if (const Result<void> done = edit(&trees, state.in_hand); !done) return Fail(done);
  const NodePath edited = state.in_hand;
  return WithRules(std::move(state), std::move(trees), edited);
}

Result<SessionState> Do(const RenameSymbol& command, SessionState state, const SessionOptions&) {
  return WithNodeInHand(std::move(state), [&](Trees* trees, const NodePath& path) {
    return RenameAt(trees, path, command.from, command.to);
  });
}

Result<SessionState> Do(const SetNumber& command, SessionState state, const SessionOptions&) {
  return WithNodeInHand(std::move(state), [&](Trees* trees, const NodePath& path) {
    return Turn(&NodeAt(trees, path).action, command.dial, command.value);
  });
}

Result<SessionState> Do(const RenameEverywhere& command, SessionState state,
                        const SessionOptions&) {
  Trees trees = state.model.trees();
  const auto done = RenameAll(&trees, command.from, command.to);
  if (!done) return Fail(done);
  return WithRules(std::move(state), std::move(trees));
}

Result<SessionState> WithSketchOn(SessionState state, std::optional<grammar::Query> query,
                                  const SessionOptions& options) {
  if (query && TargetsOf(state.model, query).empty()) {
    return Fail(ErrorCode::kNothingMade,
                fmt::format("nothing visible is selected by {}", grammar::TextOf(*query)),
                "only what is visible can be drawn on");
  }
  state.sketch.query = std::move(query);
  state.sketch.target.reset();
  state.sketch.suggestions.clear();
  state.sketch.lines = {};
  // Strokes that mean nothing there stay, for the lines to come.
  if (auto read = ReadSketch(state, options)) state.sketch = std::move(*read);
  return state;
}

/// A number is that of a candidate; anything else is a query.
Result<grammar::Query> QueryMeant(const std::string& text, const Selection& selection) {
  size_t number = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (end == text.data() || end != text.data() + text.size()) return grammar::ParseQuery(text);
  const auto& candidates = selection.candidates;
  if (code == std::errc() && number >= 1 && number <= candidates.size()) {
    return candidates[number - 1].query;
  }
  return Fail(ErrorCode::kUnknownName, fmt::format("there is no query {}", text),
              candidates.empty() ? "tap shapes first: select 0/2/5"
                                 : fmt::format("{} queries are offered", candidates.size()));
}

Result<SessionState> Do(const SetQuery& command, SessionState state,
                        const SessionOptions& options) {
  if (state.in_hand.empty() && command.query == "none") {
    return WithSketchOn(std::move(state), std::nullopt, options);
  }
  auto query = QueryMeant(command.query, state.selection);
  if (!query) return Fail(query);
  if (state.in_hand.empty()) return WithSketchOn(std::move(state), std::move(*query), options);
  return WithNodeInHand(std::move(state), [&](Trees* trees, const NodePath& path) {
    NodeAt(trees, path).query = std::move(*query);
    return Result<void>();
  });
}

Result<SessionState> Do(const AddNode& command, SessionState state, const SessionOptions&) {
  auto node = ParseNode(command.text);
  if (!node) return Fail(node);
  Trees trees = state.model.trees();
  state.in_hand = InsertNode(&trees, {0}, std::move(*node));
  state.just_made = true;
  const NodePath made = state.in_hand;
  return WithRules(std::move(state), std::move(trees), made);
}

Result<SessionState> Do(const Rewrite& command, SessionState state, const SessionOptions&) {
  auto trees = grammar::ParseTrees(command.text);
  if (!trees) return tl::unexpected<Error>(trees.error().front());
  if (state.in_hand.empty() || !CheckNode(*trees, state.in_hand)) state.in_hand.clear();
  state.just_made = false;
  return WithRules(std::move(state), std::move(*trees));
}

/// The state with a model on other ground; the shapes in hand stay so, where they are still there.
Result<SessionState> WithGround(SessionState state, EditedModel model) {
  if (!model) return tl::unexpected<Error>(AsOne(model.error()));
  state.selection = SelectionOf(*model, KeptShapes(state.model, state.selection.shapes, *model));
  state.model = std::move(*model);
  state.sketch = {};
  if (!state.in_hand.empty() && !CheckNode(state.model.trees(), state.in_hand)) {
    state.in_hand.clear();
    state.just_made = false;
  }
  return state;
}

Result<SessionState> Do(const SetRuleText& command, SessionState state, const SessionOptions&) {
  auto model = WithRuleText(state.model, command);
  return WithGround(std::move(state), std::move(model));
}

Result<SessionState> Do(const EditLayers& command, SessionState state, const SessionOptions&) {
  auto model = WithLayerEdits(state.model, command);
  return WithGround(std::move(state), std::move(model));
}

Result<SessionState> Do(const Take& command, SessionState state, const SessionOptions&) {
  if (!command.path.empty()) {
    const auto there = CheckNode(state.model.trees(), command.path);
    if (!there) return Fail(there);
  }
  state.in_hand = command.path;
  state.just_made = false;
  return state;
}

Result<SessionState> Do(const Switch& command, SessionState state, const SessionOptions&) {
  Trees trees = state.model.trees();
  const auto done = SwitchAt(&trees, command.path, command.on);
  if (!done) return Fail(done);
  return WithRules(std::move(state), std::move(trees));
}

Result<SessionState> Do(const Move& command, SessionState state, const SessionOptions&) {
  Trees trees = state.model.trees();
  const auto done = MoveNode(&trees, command.from, command.to);
  if (!done) return Fail(done);
  if (IsAtOrBelow(state.in_hand, command.from)) {
    NodePath moved = command.to;
    moved.insert(moved.end(), state.in_hand.begin() + static_cast<ptrdiff_t>(command.from.size()),
                 state.in_hand.end());
    state.in_hand = std::move(moved);
  } else if (!state.in_hand.empty()) {
    state.in_hand = PathAfterInsertion(*PathAfterRemoval(state.in_hand, command.from), command.to);
  }
  return WithRules(std::move(state), std::move(trees));
}

Result<SessionState> Do(const Delete& command, SessionState state, const SessionOptions&) {
  Trees trees = state.model.trees();
  const auto done = DeleteAt(&trees, command.path);
  if (!done) return Fail(done);
  if (!state.in_hand.empty()) {
    state.in_hand = PathAfterRemoval(state.in_hand, command.path).value_or(NodePath());
  }
  return WithRules(std::move(state), std::move(trees));
}

Result<SessionState> Do(const AddTree& command, SessionState state, const SessionOptions&) {
  Trees trees = state.model.trees();
  const auto done = AddTreeNamed(&trees, command.name);
  if (!done) return Fail(done);
  return WithRules(std::move(state), std::move(trees));
}

Result<SessionState> Do(const RenameTree& command, SessionState state, const SessionOptions&) {
  Trees trees = state.model.trees();
  const auto done = RenameTreeAt(&trees, command.tree, command.name);
  if (!done) return Fail(done);
  return WithRules(std::move(state), std::move(trees));
}

/// errors  kUnknownName  with the names that there are.
Result<size_t> FindView(const std::vector<NamedView>& views, const std::string& name) {
  std::vector<std::string> names;
  for (size_t i = 0; i < views.size(); ++i) {
    if (views[i].name == name) return i;
    names.push_back(views[i].name);
  }
  const auto meant = DidYouMean(name, names);
  return Fail(ErrorCode::kUnknownName, fmt::format("there is no view '{}'", name),
              meant           ? fmt::format("did you mean '{}'?", *meant)
              : names.empty() ? "keep one first: keep-view street"
                              : fmt::format("views are {}", fmt::join(names, ", ")));
}

Result<SessionState> Do(const KeepView& command, SessionState state, const SessionOptions&) {
  if (const auto fit = CheckName(command.name); !fit) return Fail(fit);
  if (const auto at = FindView(state.views, command.name)) {
    state.views[*at].camera = state.camera;
  } else {
    state.views.push_back({command.name, state.camera});
  }
  return state;
}

Result<SessionState> Do(const GoView& command, SessionState state, const SessionOptions&) {
  const auto at = FindView(state.views, command.name);
  if (!at) return Fail(at);
  const double width_px = state.camera.width_px, height_px = state.camera.height_px;
  state.camera = state.views[*at].camera;
  state.camera.width_px = width_px;
  state.camera.height_px = height_px;
  return state;
}

Result<SessionState> Do(const DropView& command, SessionState state, const SessionOptions&) {
  const auto at = FindView(state.views, command.name);
  if (!at) return Fail(at);
  state.views.erase(state.views.begin() + static_cast<ptrdiff_t>(*at));
  return state;
}

using Strokes = std::vector<std::shared_ptr<const DrawnStroke>>;

bool EraseFrom(Strokes* strokes, uint32_t number) {
  return std::erase_if(*strokes, [&](const auto& drawn) { return drawn->number == number; }) > 0;
}

Result<SessionState> Do(const Erase& command, SessionState state, const SessionOptions& options) {
  std::vector<uint32_t> numbers;
  for (const Strokes* strokes : {&state.sketch.strokes, &state.sketch.unread}) {
    for (const auto& drawn : *strokes) numbers.push_back(drawn->number);
  }
  for (const uint32_t number : command.strokes) {
    if (std::find(numbers.begin(), numbers.end(), number) != numbers.end()) continue;
    return Fail(ErrorCode::kUnknownName, fmt::format("stroke {} is not in the sketch", number),
                numbers.empty() ? "the sketch has no strokes"
                                : fmt::format("it has {}", fmt::join(numbers, ", ")));
  }
  bool changed = false;
  for (const uint32_t number : command.strokes) {
    EraseFrom(&state.sketch.unread, number);
    changed |= EraseFrom(&state.sketch.strokes, number);
  }
  if (!changed) return state;
  state.sketch.suggestions.clear();
  state.sketch.lines = {};
  // What is left may mean nothing alone; it stays, for the lines to come.
  if (auto read = ReadSketch(state, options)) {
    state.sketch = std::move(*read);
  } else {
    state.sketch.target.reset();
  }
  return state;
}

Result<SessionState> Do(const Select& command, SessionState state, const SessionOptions&) {
  if (command.shapes.empty()) {
    state.selection = {};
    return state;
  }
  std::vector<ShapeRef> shapes = state.selection.shapes;
  for (const std::string& id : command.shapes) {
    const auto ref = RefAt(state.model, id);
    if (!ref) return Fail(ref);
    if (std::erase(shapes, *ref) == 0) shapes.push_back(*ref);
  }
  state.selection = SelectionOf(state.model, std::move(shapes));
  if (state.just_made) {
    state.in_hand.clear();
    state.just_made = false;
  }
  return state;
}

Result<SessionState> Do(const ClearSketch&, SessionState state, const SessionOptions&) {
  state.sketch = {};
  return state;
}

template <typename UndoOrRedo>
Result<SessionState> Do(const UndoOrRedo&, const SessionState& state, const SessionOptions&) {
  static_assert(std::is_same_v<UndoOrRedo, Undo> || std::is_same_v<UndoOrRedo, Redo>);
  CHECK(false, "undo and redo are the session's");
  return state;
}

}  // namespace

Result<SessionState> After(const SessionState& state, const Command& command,
                           const SessionOptions& options) {
  return std::visit([&](const auto& c) { return Do(c, state, options); }, command);
}

namespace {

/// All strokes of the sketch as one outline, or the newest alone: earlier ones may have failed.
Result<std::string> LotOutlined(const Strokes& strokes, const LotParameters& parameters) {
  auto lot = LotFromStrokes(strokes, parameters);
  if (lot || strokes.size() == 1) return lot;
  auto alone = LotFromStrokes(std::span(strokes).last(1), parameters);
  return alone ? alone : lot;
}

StrokeOutcome AfterOutline(SessionState state, std::shared_ptr<const DrawnStroke> stroke,
                           const SessionOptions& options) {
  state.sketch.strokes.push_back(stroke);
  const auto lot = LotOutlined(state.sketch.strokes, options.lot);
  if (lot) {
    const SetLot begun{*lot};
    auto next = Do(begun, state, options);
    if (next) return {std::move(*next), {}, begun};
    return {std::move(state), Fail(next), {}};
  }
  if (lot.error().code != ErrorCode::kNoFit) {
    state.sketch.strokes.pop_back();
    state.sketch.unread.push_back(std::move(stroke));
  }
  return {std::move(state), Fail(lot), {}};
}

}  // namespace

StrokeOutcome AfterStroke(SessionState state, std::shared_ptr<const DrawnStroke> stroke,
                          const SessionOptions& options) {
  if (state.model.lots().empty()) {
    return AfterOutline(std::move(state), std::move(stroke), options);
  }
  state.sketch.strokes.push_back(stroke);
  auto read = ReadSketch(state, options);
  if (read) {
    state.sketch = std::move(*read);
    return {std::move(state), {}, {}};
  }
  state.sketch.strokes.pop_back();
  state.sketch.unread.push_back(std::move(stroke));
  return {std::move(state), Fail(read), {}};
}

}  // namespace parti::app
