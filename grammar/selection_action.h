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

/// What becomes of shapes that a node's action can't be applied to.
enum class Unfit : uint8_t {
  kFail,  ///< the derivation fails: what pipelines want
  kSkip,  ///< they stay as they were, and a problem is kept: an edit never costs what it breaks
};

/// Something that worked but was perhaps not meant.
struct DerivationHint {
  std::string node;     ///< the node's text, one line
  std::string message;  ///< "selected nothing", "acted on 3 shapes that already had children" …
  size_t result = 0;    ///< index in Derivation::nodes
};

/// Shapes that a node selected and could not act on (Unfit::kSkip).
struct DerivationProblem {
  Error error;        ///< names the node and the first of the shapes
  size_t shapes = 0;  ///< how many; the rest of the node's selection was acted on
  size_t result = 0;  ///< index in Derivation::nodes
};

/// What one node selected and made; kept, so that a later derivation can go on from here.
struct NodeResult {
  std::vector<int> path;  ///< tree, node, child …
  Query query;            ///< as they were when the node ran
  Action action;
  int parent = -1;  ///< index in Derivation::nodes; -1 at a tree's top level
  /// The product of its query, taken once (errata 12), without those that it can't act on.
  std::vector<ShapeIndex> selected;
  ShapeIndex first_made = 0;  ///< the node made the shapes [first_made, after.size())
  ShapeTree after;            ///< the tree when the node's own action had run
};

/// What trees made of one lot.
struct Derivation {
  ShapeTree lot;                  ///< what it started from
  ShapeTree tree;                 ///< what it came to
  std::vector<NodeResult> nodes;  ///< in the order they ran
  std::vector<DerivationHint> hints;
  std::vector<DerivationProblem> problems;  ///< empty where a problem fails the derivation
};

/// Runs all enabled trees depth first on one lot (5.4.2). A node that is off does not run, nor do
/// those below it. With `previous`, nodes that are equal to the ones that ran before, up to the
/// first that is not, are not run again: their results are shared (`lot` must be a copy of the one
/// that `previous` started from, else everything runs). `cancelled` may be null.
///
/// An operation in place changes the shape that it is applied to; every other makes children.
/// Operations in place before a successor's symbol change the child. NIL makes nothing.
///
/// With Unfit::kSkip, shapes that an action fails on stay as they were; a node that would make too
/// many shapes, or whose query fails, does nothing. Each is a problem of the derivation.
///
/// errors  cancelled (kLimitReached); without kSkip also: kWrongItemType, kDegenerateGeometry,
///         kBadArguments  naming node and shape;  kLimitReached  too many shapes, naming the node.
/// cost  linear in the shapes that nodes look at and make.
Result<Derivation> Derive(const Trees& trees, const ShapeTree& lot, const Limits& limits = {},
                          const Derivation* previous = nullptr,
                          const std::atomic<bool>* cancelled = nullptr, Unfit unfit = Unfit::kFail);

/// The node to append a new node to as its last child, so that it acts on `target`: the one that
/// made target (none below it can have), else {tree}, the top level of the first tree that is on
/// (errata 23); {trees.size()} where all are off or there is none. path as in NodeResult.
std::vector<int> InsertionPath(const Derivation& derivation, const Trees& trees, ShapeIndex target);

}  // namespace parti::grammar
