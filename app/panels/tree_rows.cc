#include "app/panels/tree_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/panels/words.h"

namespace parti::app::panels {
namespace {

using grammar::SelectionActionNode;

void AddNodes(const std::vector<SelectionActionNode>& nodes, const NodePath& above, int depth,
              bool runs, std::vector<TreeRow>* rows) {
  for (size_t i = 0; i < nodes.size(); ++i) {
    TreeRow row;
    row.path = above;
    row.path.push_back(static_cast<int>(i));
    row.depth = depth;
    row.node = &nodes[i];
    row.on = nodes[i].enabled;
    row.runs = runs && row.on;
    row.siblings = static_cast<int>(nodes.size());
    row.children = static_cast<int>(nodes[i].children.size());
    const NodePath path = row.path;
    const bool below_run = row.runs;
    rows->push_back(std::move(row));
    AddNodes(nodes[i].children, path, depth + 1, below_run, rows);
  }
}

void Note(std::vector<TreeRow>* rows, const std::vector<int>& path, const std::string& note) {
  const auto row =
      std::find_if(rows->begin(), rows->end(), [&](const TreeRow& r) { return r.path == path; });
  if (row == rows->end()) return;
  const auto& notes = row->notes;
  if (std::find(notes.begin(), notes.end(), note) == notes.end()) row->notes.push_back(note);
}

void AddNotes(const Model& model, std::vector<TreeRow>* rows) {
  for (const NodeProblem& problem : ProblemsOf(model)) {
    Note(rows, problem.path, Capital(problem.error.message));
  }
  for (const auto& derived : model.derived) {
    for (const grammar::DerivationHint& hint : derived->hints) {
      if (hint.result >= derived->nodes.size()) continue;
      Note(rows, derived->nodes[hint.result].path, Capital(hint.message));
    }
  }
}

}  // namespace

std::vector<TreeRow> RowsOf(const SessionState& state) {
  std::vector<TreeRow> rows;
  const grammar::Trees& trees = state.model.trees();
  for (size_t i = 0; i < trees.size(); ++i) {
    const NodePath path{static_cast<int>(i)};
    const bool named = trees.size() > 1;
    if (named) {
      TreeRow row;
      row.path = path;
      row.tree = &trees[i];
      row.on = row.runs = trees[i].enabled;
      row.siblings = static_cast<int>(trees.size());
      row.children = static_cast<int>(trees[i].nodes.size());
      rows.push_back(std::move(row));
    }
    AddNodes(trees[i].nodes, path, named ? 1 : 0, trees[i].enabled, &rows);
  }
  AddNotes(state.model, &rows);
  return rows;
}

std::optional<NodePath> DropPath(const TreeRow& on, Drop drop, const NodePath& from) {
  if (from.empty() || IsAtOrBelow(on.path, from)) return std::nullopt;
  const bool trees = on.path.size() == 1 && drop != Drop::kInto;
  if (trees != (from.size() == 1)) return std::nullopt;  // trees lie among trees, nodes in them
  NodePath to = on.path;
  if (drop == Drop::kAfter) ++to.back();
  if (drop == Drop::kInto) to.push_back(on.children);
  if (to == from) return std::nullopt;
  const auto then = PathAfterRemoval(to, from);
  if (!then || *then == from) return std::nullopt;
  return then;
}

}  // namespace parti::app::panels
