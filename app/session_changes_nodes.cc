// Nodes that are made from what is drawn, or edited in hand; what they select.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "app/edit_nodes.h"
#include "app/session_changes.h"
#include "app/sketch_reading.h"
#include "grammar/operation.h"

namespace parti::app {
namespace {

using grammar::Trees;

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

Result<SessionState> WithSketchOn(SessionState state, std::optional<grammar::Query> query,
                                  const SessionOptions& options) {
  if (query && TargetsOf(state.model, query).empty()) {
    return Fail(ErrorCode::kNothingMade,
                fmt::format("nothing visible is selected by {}", grammar::TextOf(*query)),
                "only what is visible can be drawn on");
  }
  return WithSketchAbout(std::move(state), std::move(query), options);
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

}  // namespace

Result<SessionState> Do(const Pick& command, SessionState state, const SessionOptions& options) {
  const Sketch& sketch = state.sketch;
  const size_t chosen = Chosen(command, sketch.suggestions);
  if (chosen >= sketch.suggestions.size()) {
    return Fail(ErrorCode::kUnknownName,
                command.operation.empty() ? fmt::format("there is no suggestion {}", command.number)
                                          : fmt::format("there is no suggestion {} {}",
                                                        command.number, command.operation),
                fmt::format("this sketch has {} suggestion{}", sketch.suggestions.size(),
                            sketch.suggestions.size() == 1 ? "" : "s"));
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

Result<SessionState> Do(const SetQuery& command, SessionState state,
                        const SessionOptions& options) {
  if (command.query == SetQuery::kNone) {
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

}  // namespace parti::app
