// Work that the thread that draws must not do, done beside it: the newest request wins, and one
// that nobody waits for any more is never begun. What the work is, its owner says.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "app/wake_fd.h"

namespace parti::app {

/// Owns one thread, which ends with it (when the request that it is at is done). All functions may
/// be called from any thread and wait for no work. Answer is copied under the lock: make it cheap.
template <typename Request, typename Answer>
class LatestWorker {
 public:
  /// `work` is called on the thread, one request at a time.
  explicit LatestWorker(std::function<Answer(Request)> work)
      : work_(std::move(work)), thread_([this] { Run(); }) {}

  ~LatestWorker() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    asked_.notify_one();
    thread_.join();
  }
  LatestWorker(const LatestWorker&) = delete;
  LatestWorker& operator=(const LatestWorker&) = delete;

  /// Takes the place of a request that is not begun yet.
  void Ask(Request request) {
    {
      const std::lock_guard lock(mutex_);
      next_ = std::move(request);
    }
    asked_.notify_one();
  }

  /// The newest answer; nothing before the first.
  std::optional<Answer> newest() const {
    const std::lock_guard lock(mutex_);
    return newest_;
  }
  /// Whether something has been asked that is not answered yet.
  bool busy() const {
    const std::lock_guard lock(mutex_);
    return working_ || next_;
  }
  const WakeFd& ready() const { return ready_; }  ///< woken by each answer

 private:
  void Run() {
    std::unique_lock lock(mutex_);
    while (true) {
      asked_.wait(lock, [&] { return stop_ || next_; });
      if (stop_) return;
      Request request = std::move(*next_);
      next_.reset();
      working_ = true;
      lock.unlock();
      Answer answer = work_(std::move(request));
      lock.lock();
      newest_ = std::move(answer);
      working_ = false;
      ready_.Wake();
    }
  }

  std::function<Answer(Request)> work_;
  mutable std::mutex mutex_;
  std::condition_variable asked_;
  std::optional<Request> next_;
  std::optional<Answer> newest_;
  bool working_ = false;
  bool stop_ = false;
  WakeFd ready_;
  std::thread thread_;
};

}  // namespace parti::app
