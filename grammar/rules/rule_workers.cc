#include "grammar/rules/rule_workers.h"

#include <tbb/info.h>

#include <atomic>
#include <thread>

namespace parti::grammar {
namespace {

/// Keeps an arena, as oneTBB ends its threads with the last one.
class Workers {
 public:
  Workers() {
    starter_ = std::thread([this] { arena_.enqueue([this] { Report(); }); });
  }
  ~Workers() {
    starter_.join();
    Await();
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  bool are_ready() const { return are_ready_.load(std::memory_order_acquire); }
  void Await() const { are_ready_.wait(false, std::memory_order_acquire); }

 private:
  void Report() {
    are_ready_.store(true, std::memory_order_release);
    are_ready_.notify_all();
  }

  std::atomic<bool> are_ready_ = false;
  tbb::task_arena arena_;
  std::thread starter_;
};

/// Null where one processor is all there is.
Workers* TheWorkers() {
  static std::optional<Workers> workers;
  static const bool is_begun = tbb::info::default_concurrency() > 1 && (workers.emplace(), true);
  return is_begun ? &*workers : nullptr;
}

}  // namespace

void BeginRuleWorkers() { TheWorkers(); }
bool AreRuleWorkersReady() { return TheWorkers() != nullptr && TheWorkers()->are_ready(); }
void AwaitRuleWorkers() {
  if (const Workers* workers = TheWorkers()) workers->Await();
}

int RuleArena::threads() const {
  return threads_ > 0 ? threads_ : tbb::info::default_concurrency();
}

void RuleArena::Open() {
  if (threads_ > 0) {
    allowed_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<size_t>(threads_));
  }
  arena_.emplace(threads());
}

}  // namespace parti::grammar
