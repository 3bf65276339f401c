// Edits of selection-action trees that commands make: insert, rename, another query, another
// number.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "grammar/operation.h"
#include "grammar/selection_action.h"

namespace parti::app {

/// Appends a node under the node (or tree) at `path` (grammar::NodeResult::path); returns the path
/// of the new node. {trees->size()} makes a new tree named "structure" first.
std::vector<int> InsertNode(grammar::Trees* trees, std::vector<int> path,
                            grammar::SelectionActionNode node);

/// The node at a path of two numbers or more, which must exist.
grammar::SelectionActionNode& NodeAt(grammar::Trees* trees, const std::vector<int>& path);

/// The query by which a shape drawn on is meant without inference (errata 23): its symbol; where it
/// has none, the operation that made it, leaves only.
grammar::Query QueryFor(const grammar::ShapeTree& tree, grammar::ShapeIndex shape);

/// "query --> action", as in a tree's text.
/// errors  those of grammar::ParseTrees (the first);  kBadText  none or several nodes.
Result<grammar::SelectionActionNode> ParseNode(std::string_view text);

/// Renames a symbol that an action gives, wherever it gives it.
/// errors  kUnknownName  it gives no such symbol (the hint names those it gives);  kBadText  the
/// new
///         name is not an identifier.
Result<void> Rename(grammar::Action* action, const std::string& from, const std::string& to);

/// errors  those of grammar::ParseQuery.
Result<void> Requery(grammar::SelectionActionNode* node, const std::string& query);

/// Sets a number of an action by its dial's name.
/// errors  kUnknownName  no such dial (the hint names them);  kBadNumber  outside its range.
Result<void> Turn(grammar::Action* action, const std::string& dial, double value);

}  // namespace parti::app
