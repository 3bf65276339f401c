// Edits of selection-action trees that commands make: insert, move, delete, switch, rename, another
// query, another number. What the edited trees make of a lot is derivation's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/node_path.h"
#include "base/error.h"
#include "grammar/operation.h"
#include "grammar/selection_action.h"

namespace parti::app {

/// Appends a node under the node (or tree) at `path` (grammar::NodeResult::path); returns the path
/// of the new node. {trees->size()} makes a new tree named "structure" first.
NodePath InsertNode(grammar::Trees* trees, NodePath path, grammar::SelectionActionNode node);

/// The node at a path of two numbers or more, which must exist.
grammar::SelectionActionNode& NodeAt(grammar::Trees* trees, const NodePath& path);

/// errors  kUnknownName  there is nothing at the path, or a tree where a node is wanted; the hint
///         says how far the paths go.
Result<void> CheckNode(const grammar::Trees& trees, const NodePath& path);
Result<void> CheckNodeOrTree(const grammar::Trees& trees, const NodePath& path);

/// errors  those of CheckNodeOrTree.
Result<void> SwitchAt(grammar::Trees* trees, const NodePath& path, bool on);
Result<void> DeleteAt(grammar::Trees* trees, const NodePath& path);

/// Takes out what is at `from` with all below it, then puts it where `to` names it.
/// errors  those of CheckNodeOrTree;  kUnknownName  nothing can stand at `to` then;
///         kBadArguments  a tree can't become a node, nor a node a tree.
Result<void> MoveNode(grammar::Trees* trees, const NodePath& from, const NodePath& to);

/// errors  kBadText  the name is empty or has control characters;  kUnknownName  there is no such
/// tree.
Result<void> AddTreeNamed(grammar::Trees* trees, const std::string& name);
Result<void> RenameTreeAt(grammar::Trees* trees, int tree, const std::string& name);
/// Names of trees and views. errors  kBadText as above, or longer than 200 bytes.
Result<void> CheckName(const std::string& name);

/// The query by which a shape drawn on is meant without inference (errata 23): its symbol; where it
/// has none, the operation that made it, leaves only.
grammar::Query QueryFor(const grammar::ShapeTree& tree, grammar::ShapeIndex shape);

/// "query --> action", as in a tree's text.
/// errors  those of grammar::ParseTrees (the first);  kBadText  none or several nodes.
Result<grammar::SelectionActionNode> ParseNode(std::string_view text);

/// Renames a symbol that the node at `path` gives, wherever it gives it. Queries of the nodes below
/// follow; all others too where no other node gives the symbol.
/// errors  kUnknownName  it gives no such symbol (the hint names those it gives);  kBadText  the
/// new
///         name is not an identifier, or NIL.
Result<void> RenameAt(grammar::Trees* trees, const NodePath& path, const std::string& from,
                      const std::string& to);

/// Renames a symbol wherever it is given or asked for.
/// errors  kUnknownName  no node gives it (the hint names one that is meant);  kBadText  as above,
///         or the lot's own symbol, which stays.
Result<void> RenameAll(grammar::Trees* trees, const std::string& from, const std::string& to);

/// Sets a number of an action by its dial's name.
/// errors  kUnknownName  no such dial (the hint names them);  kBadNumber  outside its range.
Result<void> Turn(grammar::Action* action, const std::string& dial, double value);

}  // namespace parti::app
