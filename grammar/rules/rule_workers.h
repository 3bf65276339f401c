// The process's threads for derivation: when they are there, and how many of them one uses.
// What they do is rule_parts.h's and rule_derivation.h's.
#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <optional>

namespace parti::grammar {

/// Begins oneTBB's threads, once in a process, on a thread of its own, and returns at once. oneTBB
/// looks for libraries that may be there, which takes it a millisecond: long enough to read a rule
/// file, or to derive 3,000 shapes without help. They stay until the process ends. A process that
/// has one processor gets none, and they are never ready.
void BeginRuleWorkers();
bool AreRuleWorkersReady();
/// Begins them, and returns when they are ready, or never will be: for what wants them from its
/// first shape, as tests and benchmarks do.
void AwaitRuleWorkers();

/// The threads of one derivation. Until something is executed it costs nothing.
class RuleArena {
 public:
  explicit RuleArena(int threads) : threads_(threads) {}  ///< 0: as many as the machine has

  int threads() const;  ///< that there may be
  /// Runs `work` where oneTBB's algorithms use these threads; at once where it already runs there.
  /// The first call comes from one thread alone.
  template <typename Work>
  void Execute(const Work& work) {
    if (!arena_) Open();
    arena_->execute(work);
  }

 private:
  void Open();

  int threads_;
  std::optional<tbb::global_control> allowed_;
  std::optional<tbb::task_arena> arena_;
};

}  // namespace parti::grammar
