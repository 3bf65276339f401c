// Ground, rule files and trees, as a whole and node by node.
#include <fmt/format.h>

#include <algorithm>

#include "app/edit_nodes.h"
#include "app/rule_edits.h"
#include "app/session_changes.h"

namespace parti::app {
namespace {

using grammar::SelectionActionNode;
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

/// Levels of nodes.
int DepthOf(const std::vector<SelectionActionNode>& nodes) {
  int deepest = 0;
  for (const SelectionActionNode& node : nodes) {
    deepest = std::max(deepest, 1 + DepthOf(node.children));
  }
  return deepest;
}

/// What could be written but not read again is no rule.
Result<void> CheckDepth(const Trees& trees) {
  const bool fits = std::all_of(trees.begin(), trees.end(), [](const auto& tree) {
    return DepthOf(tree.nodes) <= grammar::kDeepestNode;
  });
  if (fits) return {};
  return Fail(ErrorCode::kLimitReached,
              fmt::format("nodes would be nested more than {} deep", grammar::kDeepestNode),
              "let the node stand beside the others");
}

}  // namespace

Result<SessionState> WithRules(SessionState state, Trees trees, const NodePath& edited) {
  if (const auto fits = CheckDepth(trees); !fits) return Fail(fits);
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

Result<SessionState> Do(const Rewrite& command, SessionState state, const SessionOptions&) {
  auto trees = grammar::ParseTrees(command.text);
  if (!trees) return tl::unexpected<Error>(trees.error().front());
  if (state.in_hand.empty() || !CheckNode(*trees, state.in_hand)) state.in_hand.clear();
  state.just_made = false;
  return WithRules(std::move(state), std::move(*trees));
}

Result<SessionState> Do(const SetRuleText& command, SessionState state, const SessionOptions&) {
  auto model = WithRuleText(state.model, command);
  return WithGround(std::move(state), std::move(model));
}

Result<SessionState> Do(const EditLayers& command, SessionState state, const SessionOptions&) {
  auto model = WithLayerEdits(state.model, command);
  return WithGround(std::move(state), std::move(model));
}

Result<SessionState> Do(const ChangeLayer& command, SessionState state, const SessionOptions&) {
  auto model = WithLayerChange(state.model, command);
  return WithGround(std::move(state), std::move(model));
}

Result<SessionState> Do(const PlaceElement& command, SessionState state, const SessionOptions&) {
  auto model = WithElementPlaced(state.model, command);
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

}  // namespace parti::app
