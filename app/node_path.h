// Paths of nodes in selection-action trees, as commands and panels name them: "0/2/1".
// What is done to a node is edit_nodes.h's.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace parti::app {

/// {tree, node, child …}, each from 0, as grammar::NodeResult::path; one number names a tree.
using NodePath = std::vector<int>;

/// errors  kBadText  not numbers with / between them.
Result<NodePath> ParseNodePath(std::string_view text);
std::string PathText(const NodePath& path);

/// Whether `path` names `above`, or something below it.
bool IsAtOrBelow(const NodePath& path, const NodePath& above);

/// Where `path` is once `removed` and what is below it have gone; nothing for those.
std::optional<NodePath> PathAfterRemoval(NodePath path, const NodePath& removed);

/// Where `path` is once something has been put at `inserted`.
NodePath PathAfterInsertion(NodePath path, const NodePath& inserted);

}  // namespace parti::app
