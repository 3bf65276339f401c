#include "grammar/rules/rule_parts.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "grammar/rules/rule_scene.h"
#include "grammar/rules/rule_workers.h"

namespace parti::grammar {
namespace {

/// So many shapes a thread derives by itself; then it lets others have what still waits.
constexpr uint32_t kGrain = 512;
/// A part of a part waits so much longer: a chain of shapes is not moved over and over.
constexpr uint32_t kCoarser = 4;

/// What all parts together have used of the lot's limits.
struct Spent {
  std::atomic<uint64_t> shapes = 0, steps = 0, reports = 0;

  /// False: more than there is.
  bool Add(uint64_t more_shapes, uint64_t more_steps, const RuleLimits& limits) {
    const uint64_t all_shapes = shapes.fetch_add(more_shapes) + more_shapes;
    const uint64_t all_steps = steps.fetch_add(more_steps) + more_steps;
    return all_shapes < limits.shapes && (limits.steps == 0 || all_steps <= limits.steps);
  }
  bool AddReports(uint64_t more) {
    return more == 0 || reports.fetch_add(more) + more <= kMostReports;
  }
};

/// What becomes of a part's first shape.
struct DerivedPart {
  ShapeTree tree;
  NoteBook notes;
};

/// Part of a lot's tree, or all of it: from a task to everything that comes of it.
class PartDerivation {
 public:
  /// Without an arena, in order only. `notes` may be null.
  PartDerivation(const LotRun& run, ShapeTree* tree, NoteBook* notes, RuleArena* arena)
      : run_(run), tree_(tree), notes_(notes), arena_(arena), runner_(run, tree, notes) {}

  /// Depth first, in order, on this thread.
  Result<void> InOrder(RuleTask first) { return Derive(std::move(first), UINT32_MAX); }

  /// With others' help; false as DeriveAtOnce.
  bool AtOnce(RuleTask first, uint32_t grain, Spent* spent) {
    if (!Derive(std::move(first), grain)) return false;
    if (!spent->Add(tree_->size() - 1, runner_.steps(), run_.limits)) return false;
    if (notes_ != nullptr && !spent->AddReports(notes_->reports())) return false;
    if (waiting_.empty()) return true;
    bool done = false;
    arena_->Execute([&] { done = DeriveRest(grain * kCoarser, spent); });
    return done;
  }

 private:
  /// Until more than one task waits in a tree of more than `grain` shapes, and there is help.
  Result<void> Derive(RuleTask first, uint32_t grain) {
    std::vector<RuleTask> next;
    waiting_.push_back(std::move(first));
    while (!waiting_.empty() && !IsWorthSharing(grain)) {
      RuleTask one = std::move(waiting_.back());
      waiting_.pop_back();
      next.clear();
      if (const auto done = RunWithScene(std::move(one), &runner_, &next); !done) return done;
      waiting_.insert(waiting_.end(), std::make_move_iterator(next.rbegin()),
                      std::make_move_iterator(next.rend()));
    }
    return {};
  }

  bool IsWorthSharing(uint32_t grain) const {
    return tree_->size() >= grain && waiting_.size() > 1 && AreRuleWorkersReady();
  }

  /// Each task in a tree of its own; then all in order into this one. Their notes come after what
  /// has been noted so far, as their tasks come after those that have run.
  bool DeriveRest(uint32_t grain, Spent* spent) {
    std::reverse(waiting_.begin(), waiting_.end());
    std::vector<std::optional<DerivedPart>> parts(waiting_.size());
    std::atomic<bool> has_failed = false;
    tbb::parallel_for(
        tbb::blocked_range<size_t>(0, waiting_.size()),
        [&](const tbb::blocked_range<size_t>& range) {
          for (size_t i = range.begin(); i < range.end(); ++i) {
            if (has_failed.load(std::memory_order_relaxed)) return;
            parts[i] = DerivePart(waiting_[i], grain, spent);
            if (!parts[i]) has_failed = true;
          }
        },
        tbb::simple_partitioner());
    if (has_failed) return false;
    std::vector<ShapeTree::Part> all;
    all.reserve(parts.size());
    for (size_t i = 0; i < parts.size(); ++i) {
      all.push_back({waiting_[i].shape, std::move(parts[i]->tree)});
      if (notes_ != nullptr) notes_->Append(std::move(parts[i]->notes));
    }
    tree_->Splice(std::move(all));
    return true;
  }

  std::optional<DerivedPart> DerivePart(RuleTask task, uint32_t grain, Spent* spent) const {
    const Shape& shape = (*tree_)[task.shape];
    DerivedPart part{ShapeTree(shape.item, shape.symbol, *tree_), {}};
    part.tree.SetMade(0, shape.symbol, shape.operation);
    for (const NameId tag : shape.tags) part.tree.AddTag(0, tag);
    task.shape = 0;
    NoteBook* notes = notes_ != nullptr ? &part.notes : nullptr;
    PartDerivation derivation(run_, &part.tree, notes, arena_);
    if (!derivation.AtOnce(std::move(task), grain, spent)) return {};
    return part;
  }

  const LotRun& run_;
  ShapeTree* tree_;
  NoteBook* notes_;
  RuleArena* arena_;
  RuleRunner runner_;
  std::vector<RuleTask> waiting_;  ///< the last one is the next
};

}  // namespace

Result<void> DeriveInOrder(const LotRun& run, ShapeTree* tree, NoteBook* notes, RuleTask first) {
  return PartDerivation(run, tree, notes, nullptr).InOrder(std::move(first));
}

bool DeriveAtOnce(const LotRun& run, ShapeTree* tree, NoteBook* notes, RuleTask first,
                  RuleArena* arena) {
  Spent spent;
  return PartDerivation(run, tree, notes, arena).AtOnce(std::move(first), kGrain, &spent);
}

}  // namespace parti::grammar
