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

/// errors  kBadText, kUnknownName, kBadArguments, each with its place; all of a text in one go.
tl::expected<Trees, std::vector<Error>> ParseTrees(std::string_view text,
                                                   std::string_view file = {});
/// Reads back as the same value.
std::string TextOf(const Trees& trees);

struct Limits {
  uint32_t shapes = 2'000'000;
};

struct DerivationHint {
  std::string node;     ///< the node's text, one line
  std::string message;  ///< "selected nothing", "acted on 3 shapes that already had children" …
};

struct NodeResult {
  std::vector<int> path;             ///< tree, node, child …
  std::vector<ShapeIndex> selected;  ///< the product of its query, taken once (errata 12)
  ShapeTree after;                   ///< the tree when the node's own action had run
};

struct Derivation {
  ShapeTree tree;
  std::vector<NodeResult> nodes;  ///< in the order they ran
  std::vector<DerivationHint> hints;
};

/// Runs all enabled trees depth first on one lot (5.4.2). With `previous`, nodes that are equal to
/// the ones that ran before, up to the first that is not, are not run again: their results are
/// shared. `cancelled` may be null.
/// errors  kWrongItemType, kDegenerateGeometry, kBadArguments  naming node and shape;
/// kLimitReached.
Result<Derivation> Derive(const Trees& trees, const ShapeTree& lot, const Limits& limits = {},
                          const Derivation* previous = nullptr,
                          const std::atomic<bool>* cancelled = nullptr);

/// Where a new node for a shape belongs: under the deepest node whose products contain it, or at
/// the end of the first tree (errata 23). path as in NodeResult; {tree} for a tree's top level.
std::vector<int> InsertionPath(const Derivation& derivation, const Trees& trees, ShapeIndex target);

}  // namespace parti::grammar
