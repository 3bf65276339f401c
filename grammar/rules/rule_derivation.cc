#include "grammar/rules/rule_derivation.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <optional>
#include <utility>

#include "grammar/rules/rule_parts.h"
#include "grammar/rules/rule_workers.h"

namespace parti::grammar {
namespace {

class LotDerivation {
 public:
  LotDerivation(const RuleProgram& program, const RuleSettings& settings, const Item& lot,
                uint32_t number, const RuleThreads& threads)
      : lot_(lot),
        limits_(settings.limits),
        number_(number),
        run_{program,           lot_,          attributes_,         limits_, settings.seed,
             threads.cancelled, threads.now_s, threads.normalise_s, 0,       {}} {}

  /// By the arena's threads, or in order where there is none. `notes` may be null.
  Result<ShapeTree> Run(const RuleSettings& settings, std::span<const GivenValue> given,
                        NoteBook* notes, RuleArena* arena) {
    auto attributes = AttributesFor(*run_.program.rules, settings, lot_, number_, notes, given);
    if (!attributes) return Fail(attributes);
    attributes_ = std::move(*attributes);
    if (run_.now_s != nullptr) run_.until_s = run_.now_s() + limits_.seconds;
    ShapeTree tree = Root();
    NoteBook before = notes != nullptr ? *notes : NoteBook();
    if (arena != nullptr && DeriveAtOnce(run_, &tree, notes, First(), arena)) return tree;
    // One after the other, failures and limits name the same shape on any number of threads.
    tree = Root();
    if (notes != nullptr) *notes = std::move(before);
    const auto done = DeriveInOrder(run_, &tree, notes, First());
    if (!done) return Fail(done);
    return tree;
  }

 private:
  ShapeTree Root() const {
    return ShapeTree(lot_, run_.program.names[0].symbol, run_.program.names);
  }

  RuleTask First() const {
    RuleTask first;
    first.body = &run_.program.bodies[run_.program.start];
    first.stream = Stream(LotPath(run_.seed, number_));
    return first;
  }

  const Item& lot_;
  RuleLimits limits_;
  uint32_t number_;
  std::vector<Value> attributes_;
  LotRun run_;
};

/// Lots in any order; the first that fails is the one that counts.
class LotsDerivation {
 public:
  LotsDerivation(const RuleProgram& program, const RuleSettings& settings,
                 std::span<const Item> lots, std::span<const std::vector<GivenValue>> given,
                 const RuleThreads& threads)
      : program_(program),
        settings_(settings),
        lots_(lots),
        given_(given),
        threads_(threads),
        wants_all_(threads.failures != nullptr && threads.failures->wants_all),
        results_(lots.size()),
        notes_(threads.notes != nullptr ? lots.size() : 0) {}

  void RunLot(size_t i, RuleArena* arena) {
    if (!wants_all_ && i > first_failed_.load(std::memory_order_relaxed)) return;
    LotDerivation lot(program_, settings_, lots_[i], static_cast<uint32_t>(i), threads_);
    const auto given = given_.empty() ? std::span<const GivenValue>() : given_[i];
    results_[i] = lot.Run(settings_, given, notes_.empty() ? nullptr : &notes_[i], arena);
    if (*results_[i]) return;
    size_t first = first_failed_.load();
    while (i < first && !first_failed_.compare_exchange_weak(first, i)) {
    }
  }

  void RunInOrder() {
    for (size_t i = 0; i < lots_.size(); ++i) RunLot(i, nullptr);
  }

  /// Until there is help, one after the other.
  void RunAtOnce(int threads) {
    BeginRuleWorkers();
    RuleArena arena(threads);
    const bool few = lots_.size() < 4 * static_cast<size_t>(arena.threads());
    const auto run = [&](size_t i) { RunLot(i, few ? &arena : nullptr); };
    size_t next = 0;
    while (next < lots_.size() && !AreRuleWorkersReady()) run(next++);
    if (next == lots_.size()) return;
    arena.Execute([&] { tbb::parallel_for(next, lots_.size(), run); });
  }

  /// Of all lots up to the first that failed.
  std::vector<LotNotes> TakeNotes() {
    std::vector<LotNotes> notes;
    for (size_t i = 0; i < notes_.size() && i <= first_failed_; ++i) {
      notes.push_back(std::move(notes_[i]).Take(*program_.rules));
    }
    return notes;
  }

  std::vector<LotFailures::One> Failures() const {
    std::vector<LotFailures::One> failures;
    for (size_t i = first_failed_; i < results_.size(); ++i) {
      if (results_[i] && !*results_[i]) failures.push_back({i, results_[i]->error()});
      if (!wants_all_) break;
    }
    return failures;
  }

  Result<std::vector<ShapeTree>> Take() {
    std::vector<ShapeTree> trees;
    for (auto& result : results_) {
      if (!*result) {
        Error error = result->error();
        if (lots_.size() > 1)
          error.message = fmt::format("lot-{}: {}", trees.size(), error.message);
        return tl::unexpected<Error>(std::move(error));
      }
      trees.push_back(std::move(**result));
    }
    return trees;
  }

 private:
  const RuleProgram& program_;
  const RuleSettings& settings_;
  std::span<const Item> lots_;
  std::span<const std::vector<GivenValue>> given_;
  const RuleThreads& threads_;
  bool wants_all_;  ///< also after one that fails
  std::vector<std::optional<Result<ShapeTree>>> results_;
  std::vector<NoteBook> notes_;  ///< of each lot; none where nobody wants them
  std::atomic<size_t> first_failed_ = SIZE_MAX;
};

}  // namespace

Result<std::vector<ShapeTree>> DeriveRules(const RuleSet& rules, const RuleSettings& settings,
                                           std::span<const Item> lots, const RuleThreads& threads,
                                           std::span<const std::vector<GivenValue>> given) {
  const auto start = StartSymbol(rules, settings);
  if (!start) return Fail(start);
  const RuleProgram program = ProgramOf(rules, *start, threads.assets);
  LotsDerivation all(program, settings, lots, given, threads);
  if (threads.count == 1) {
    all.RunInOrder();
  } else {
    all.RunAtOnce(threads.count);
  }
  if (threads.notes != nullptr) *threads.notes = all.TakeNotes();
  if (threads.failures != nullptr) threads.failures->found = all.Failures();
  auto trees = all.Take();
  if (!trees) return trees;
  for (const ShapeTree& tree : *trees) {
    if (tree.HasVisibleLeaf()) return trees;
  }
  return Fail(ErrorCode::kNothingMade, fmt::format("the rules make nothing of '{}'", *start),
              "look for NIL, and for selectors that nothing fits");
}

}  // namespace parti::grammar
