// The selection-action trees as rows of a list, with what is to be said of each.
// Pure: what rows look like is rules_sheet.h's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/node_path.h"
#include "app/session_state.h"

namespace parti::app::panels {

/// A node, or a tree where there are several. Points into the state's rules.
struct TreeRow {
  NodePath path;
  int depth = 0;
  const grammar::SelectionActionTree* tree = nullptr;  ///< one of these two is set
  const grammar::SelectionActionNode* node = nullptr;
  bool on = true;    ///< its own switch
  bool runs = true;  ///< and all above it are on
  int siblings = 1;  ///< itself included
  int children = 0;
  std::vector<std::string> notes;  ///< problems and hints of its last run
};

/// In the order of the rules. The state must outlive the rows.
std::vector<TreeRow> RowsOf(const SessionState& state);

/// Where a row may be dropped on another.
enum class Drop : uint8_t { kBefore, kInto, kAfter };

/// `to` of the Move that drops `from` on `on`; nothing where that is itself, below it, or where it
/// already is.
std::optional<NodePath> DropPath(const TreeRow& on, Drop drop, const NodePath& from);

}  // namespace parti::app::panels
