// Selection-action trees: queries and the actions on what they select (Jesus 2018, 5.4; errata
// 12-15).
#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "grammar/action.h"
#include "grammar/query.h"
#include "grammar/shape_tree.h"

namespace parti::grammar {

/// ".Lot --> extrude(12) Mass { children }"
struct SelectionActionNode {
  Query query;
  Action action;
  bool enabled = true;
  std::vector<SelectionActionNode> children;
  bool operator==(const SelectionActionNode&) const = default;
};

/// "tree structure { nodes }"; trees run in the order written.
struct SelectionActionTree {
  std::string name;
  bool enabled = true;
  std::vector<SelectionActionNode> nodes;
  bool operator==(const SelectionActionTree&) const = default;
};
using Trees = std::vector<SelectionActionTree>;

/// Nodes may be nested this deep in a text.
inline constexpr int kDeepestNode = 200;

/// errors  kBadText, kUnknownName, kBadArguments, kLimitReached, each with its place; all of a text
///         in one go (the first 50).
tl::expected<Trees, std::vector<Error>> ParseTrees(std::string_view text,
                                                   std::string_view file = {});
/// Reads back as the same value (symbols, tags and names in UTF-8, numbers finite).
std::string TextOf(const Trees& trees);
/// "off .Floor:even --> tag("x")": the node alone, on one line.
std::string TextOf(const SelectionActionNode& node);

/// Where derivation gives up with an error instead of filling the memory.
struct Limits {
  uint32_t shapes = 2'000'000;
};

/// Something that worked but was perhaps not meant.
struct DerivationHint {
  std::string node;     ///< the node's text, one line
  std::string message;  ///< "selected nothing", "acted on 3 shapes that already had children" …
  size_t result = 0;    ///< index in Derivation::nodes
};

/// What one node selected and made; kept, so that a later derivation can go on from here.
struct NodeResult {
  std::vector<int> path;  ///< tree, node, child …
  Query query;            ///< as they were when the node ran
  Action action;
  int parent = -1;                   ///< index in Derivation::nodes; -1 at a tree's top level
  std::vector<ShapeIndex> selected;  ///< the product of its query, taken once (errata 12)
  ShapeIndex first_made = 0;         ///< the node made the shapes [first_made, after.size())
  ShapeTree after;                   ///< the tree when the node's own action had run
};

/// What trees made of one lot.
struct Derivation {
  ShapeTree lot;                  ///< what it started from
  ShapeTree tree;                 ///< what it came to
  std::vector<NodeResult> nodes;  ///< in the order they ran
  std::vector<DerivationHint> hints;
};

/// Runs all enabled trees depth first on one lot (5.4.2). A node that is off does not run, nor do
/// those below it. With `previous`, nodes that are equal to the ones that ran before, up to the
/// first that is not, are not run again: their results are shared (`lot` must be a copy of the one
/// that `previous` started from, else everything runs). `cancelled` may be null.
///
/// An operation in place changes the shape that it is applied to; every other makes children.
/// Operations in place before a successor's symbol change the child. NIL makes nothing.
///
/// errors  kWrongItemType, kDegenerateGeometry, kBadArguments  naming node and shape;
///         kLimitReached  too many shapes, naming the node; cancelled.
/// cost  linear in the shapes that nodes look at and make.
Result<Derivation> Derive(const Trees& trees, const ShapeTree& lot, const Limits& limits = {},
                          const Derivation* previous = nullptr,
                          const std::atomic<bool>* cancelled = nullptr);

/// The node to append a new node to as its last child, so that it acts on `target`: the one that
/// made target (none below it can have), else {tree}, the top level of the first tree that is on
/// (errata 23); {trees.size()} where all are off or there is none. path as in NodeResult.
std::vector<int> InsertionPath(const Derivation& derivation, const Trees& trees, ShapeIndex target);

}  // namespace parti::grammar
