// The selection-action driver (Jesus 2018, 5.4.2, Listing 5.7; errata 12, 15): which action is
// applied to which shapes next. What an action does to a shape is selection_action_plan's.
#include "grammar/selection_action.h"

#include <fmt/format.h>

#include <optional>

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
         const std::atomic<bool>* cancelled, Unfit unfit)
      : derivation_{lot, lot, {}, {}, {}},
        limits_(limits),
        previous_(previous),
        cancelled_(cancelled),
        unfit_(unfit) {
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
    for (const DerivationProblem& problem : previous_->problems) {
      if (problem.result < shared) derivation_.problems.push_back(problem);
    }
    previous_ = nullptr;
    return false;
  }

  Result<void> RunNode(const SelectionActionNode& node, int parent) {
    ShapeTree& tree = derivation_.tree;
    const auto* within = parent < 0 ? nullptr : &derivation_.nodes[parent].selected;
    auto selected = ProductOf(node.query, tree, within);
    const bool hopeless = !selected;
    if (hopeless) {
      if (const auto kept = Keep(Named(node, selected.error()), 0); !kept) return kept;
      selected.emplace();
    }
    NodeResult result{path_,       node.query, node.action, parent, std::move(*selected),
                      tree.size(), tree};
    if (!result.selected.empty()) {
      const size_t covered = CountParents(result.selected);
      const auto acted = ActOn(node, &result.selected);
      if (!acted) return acted;
      if (!result.selected.empty()) HintAt(node, covered, tree.size() - result.first_made);
    } else if (!hopeless && (within == nullptr || !within->empty())) {
      Hint(node, "selected nothing");
    }
    result.after = tree;
    derivation_.nodes.push_back(std::move(result));
    return {};
  }

  /// Acts on what is selected, less the shapes that it can't act on.
  Result<void> ActOn(const SelectionActionNode& node, std::vector<ShapeIndex>* selected) {
    const ShapeTree before = derivation_.tree;
    auto acted = ActOnEach(node, *selected);
    if (!acted) return Fail(acted);
    if (!acted->failure) return {};
    const size_t unfit = selected->size() - acted->fit.size();
    if (const auto kept = Keep(std::move(*acted->failure), unfit); !kept) return kept;
    // Once more without those that failed: they may have got some of their children.
    derivation_.tree = before;
    *selected = std::move(acted->fit);
    const auto again = ActOnEach(node, *selected);
    if (!again) return Fail(again);
    CHECK(!again->failure, "what a shape can take does not depend on others of its selection");
    return {};
  }

  /// Which shapes an action could be applied to, and why not to the first of the others.
  struct Acted {
    std::vector<ShapeIndex> fit;
    std::optional<Error> failure;
  };

  /// errors  cancelled.
  Result<Acted> ActOnEach(const SelectionActionNode& node, const std::vector<ShapeIndex>& shapes) {
    ShapeTree& tree = derivation_.tree;
    const ActionPlan plan = PlanOf(node.action, &tree);
    Acted acted;
    for (const ShapeIndex shape : shapes) {
      if (cancelled_ != nullptr && cancelled_->load(std::memory_order_relaxed)) {
        return Fail(ErrorCode::kLimitReached, "the derivation was cancelled");
      }
      const auto one = Act(plan, shape, limits_.shapes, &tree);
      if (one) {
        acted.fit.push_back(shape);
        continue;
      }
      if (!acted.failure) acted.failure = Named(node, one.error(), shape);
      if (unfit_ == Unfit::kFail) return acted;
      if (one.error().code == ErrorCode::kLimitReached) return Acted{{}, std::move(acted.failure)};
    }
    return acted;
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

  /// The end of the derivation, or a problem of the node that is about to have a result.
  Result<void> Keep(Error error, size_t shapes) {
    if (unfit_ == Unfit::kFail) return tl::unexpected<Error>(std::move(error));
    derivation_.problems.push_back({std::move(error), shapes, derivation_.nodes.size()});
    return {};
  }

  static Error Named(const SelectionActionNode& node, Error error) {
    error.message = fmt::format("node '{}': {}", TextOf(node), error.message);
    return error;
  }

  Error Named(const SelectionActionNode& node, Error error, ShapeIndex shape) const {
    const ShapeTree& tree = derivation_.tree;
    error.message = fmt::format("shape {} '{}': {}", tree.IdOf(shape),
                                tree.Name(tree[shape].symbol), error.message);
    return Named(node, std::move(error));
  }

  Derivation derivation_;
  Limits limits_;
  const Derivation* previous_;  ///< null once sharing has stopped
  const std::atomic<bool>* cancelled_;
  Unfit unfit_;
  std::vector<int> path_;
};

}  // namespace

Result<Derivation> Derive(const Trees& trees, const ShapeTree& lot, const Limits& limits,
                          const Derivation* previous, const std::atomic<bool>* cancelled,
                          Unfit unfit) {
  Driver driver(lot, limits, previous, cancelled, unfit);
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
