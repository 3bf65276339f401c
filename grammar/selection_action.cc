// The selection-action driver (Jesus 2018, 5.4.2, Listing 5.7; errata 12, 15): which action is
// applied to which shapes next. What an action does to a shape is selection_action_plan's.
#include "grammar/selection_action.h"

#include <fmt/format.h>

#include "base/check.h"
#include "grammar/selection_action_plan.h"

namespace parti::grammar {
namespace {

std::string Counted(size_t count) {
  return count == 1 ? "1 shape" : fmt::format("{} shapes", count);
}

class Driver {
 public:
  Driver(const ShapeTree& lot, const Limits& limits, const Derivation* previous,
         const std::atomic<bool>* cancelled)
      : derivation_{lot, lot, {}, {}}, limits_(limits), previous_(previous), cancelled_(cancelled) {
    if (previous_ != nullptr && !previous_->lot.SharesAllWith(lot)) previous_ = nullptr;
  }

  Result<void> Run(const Trees& trees) {
    for (size_t i = 0; i < trees.size(); ++i) {
      if (!trees[i].enabled) continue;
      path_ = {static_cast<int>(i)};
      const auto run = RunNodes(trees[i].nodes, -1);
      if (!run) return run;
    }
    StopSharing();
    return {};
  }

  Derivation Take() && { return std::move(derivation_); }

 private:
  Result<void> RunNodes(const std::vector<SelectionActionNode>& nodes, int parent) {
    for (size_t i = 0; i < nodes.size(); ++i) {
      if (!nodes[i].enabled) continue;
      path_.push_back(static_cast<int>(i));
      if (!Share(nodes[i], parent)) {
        const auto run = RunNode(nodes[i], parent);
        if (!run) return run;
      }
      const auto run = RunNodes(nodes[i].children, static_cast<int>(derivation_.nodes.size()) - 1);
      if (!run) return run;
      path_.pop_back();
    }
    return {};
  }

  /// Takes the result of a node that ran before, if all up to it were the same.
  bool Share(const SelectionActionNode& node, int parent) {
    const size_t i = derivation_.nodes.size();
    if (previous_ == nullptr || i >= previous_->nodes.size()) return StopSharing();
    const NodeResult& before = previous_->nodes[i];
    if (before.parent != parent || before.after.size() > limits_.shapes ||
        before.query != node.query || before.action != node.action) {
      return StopSharing();
    }
    derivation_.nodes.push_back(before);
    derivation_.nodes.back().path = path_;
    return true;
  }

  /// From here on nodes are run, on the tree that the last shared one left. Returns false.
  bool StopSharing() {
    if (previous_ == nullptr) return false;
    const size_t shared = derivation_.nodes.size();
    if (shared > 0) derivation_.tree = derivation_.nodes.back().after;
    for (const DerivationHint& hint : previous_->hints) {
      if (hint.result < shared) derivation_.hints.push_back(hint);
    }
    previous_ = nullptr;
    return false;
  }

  Result<void> RunNode(const SelectionActionNode& node, int parent) {
    ShapeTree& tree = derivation_.tree;
    const auto* within = parent < 0 ? nullptr : &derivation_.nodes[parent].selected;
    auto selected = ProductOf(node.query, tree, within);
    if (!selected) return FailIn(node, selected.error());
    NodeResult result{path_,       node.query, node.action, parent, std::move(*selected),
                      tree.size(), tree};
    if (!result.selected.empty()) {
      const size_t covered = CountParents(result.selected);
      const auto acted = ActOn(node, result.selected);
      if (!acted) return acted;
      HintAt(node, covered, tree.size() - result.first_made);
    } else if (within == nullptr || !within->empty()) {
      Hint(node, "selected nothing");
    }
    result.after = tree;
    derivation_.nodes.push_back(std::move(result));
    return {};
  }

  Result<void> ActOn(const SelectionActionNode& node, const std::vector<ShapeIndex>& selected) {
    ShapeTree& tree = derivation_.tree;
    const ActionPlan plan = PlanOf(node.action, &tree);
    for (const ShapeIndex shape : selected) {
      if (cancelled_ != nullptr && cancelled_->load(std::memory_order_relaxed)) {
        return Fail(ErrorCode::kLimitReached, "the derivation was cancelled");
      }
      const auto acted = Act(plan, shape, limits_.shapes, &tree);
      if (!acted) return FailIn(node, acted.error(), shape);
    }
    return {};
  }

  size_t CountParents(const std::vector<ShapeIndex>& shapes) const {
    size_t count = 0;
    for (const ShapeIndex i : shapes) count += derivation_.tree.IsLeaf(i) ? 0 : 1;
    return count;
  }

  void HintAt(const SelectionActionNode& node, size_t covered, size_t made) {
    const Operation& row = *node.action.operation;
    const bool names_only = row.in_place && (row.name == "tag" || row.name == "symbol");
    if (covered > 0 && !names_only) {
      Hint(node, fmt::format("acted on {} that already had children: only leaves are visible",
                             Counted(covered)));
    }
    if (!row.in_place && made == 0) Hint(node, "made nothing");
  }

  void Hint(const SelectionActionNode& node, std::string message) {
    derivation_.hints.push_back({TextOf(node), std::move(message), derivation_.nodes.size()});
  }

  tl::unexpected<Error> FailIn(const SelectionActionNode& node, Error error) const {
    error.message = fmt::format("node '{}': {}", TextOf(node), error.message);
    return tl::unexpected<Error>(std::move(error));
  }

  tl::unexpected<Error> FailIn(const SelectionActionNode& node, Error error,
                               ShapeIndex shape) const {
    const ShapeTree& tree = derivation_.tree;
    error.message = fmt::format("shape {} '{}': {}", tree.IdOf(shape),
                                tree.Name(tree[shape].symbol), error.message);
    return FailIn(node, std::move(error));
  }

  Derivation derivation_;
  Limits limits_;
  const Derivation* previous_;  ///< null once sharing has stopped
  const std::atomic<bool>* cancelled_;
  std::vector<int> path_;
};

}  // namespace

Result<Derivation> Derive(const Trees& trees, const ShapeTree& lot, const Limits& limits,
                          const Derivation* previous, const std::atomic<bool>* cancelled) {
  Driver driver(lot, limits, previous, cancelled);
  const auto run = driver.Run(trees);
  if (!run) return Fail(run);
  return std::move(driver).Take();
}

std::vector<int> InsertionPath(const Derivation& derivation, const Trees& trees,
                               ShapeIndex target) {
  for (const NodeResult& node : derivation.nodes) {
    if (target >= node.first_made && target < node.after.size()) return node.path;
  }
  for (size_t i = 0; i < trees.size(); ++i) {
    if (trees[i].enabled) return {static_cast<int>(i)};
  }
  return {static_cast<int>(trees.size())};
}

}  // namespace parti::grammar
