// A session in a process of its own that is killed at any moment; what it acknowledged comes
// through a pipe, as a terminal would have shown it.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/session_thread.h"

namespace parti::tests {

/// A child process. Nothing of it outlives the object.
class KilledSession {
 public:
  /// Posts all requests at once to a session thread, and reports each number that is acknowledged.
  KilledSession(const app::SessionThreadOptions& options,
                const std::vector<app::SessionRequest>& requests);
  ~KilledSession();
  KilledSession(const KilledSession&) = delete;
  KilledSession& operator=(const KilledSession&) = delete;

  /// Waits until `number` is acknowledged, or the process has ended.
  void WaitFor(uint64_t number);
  /// SIGKILL after a while; returns the last number that was acknowledged.
  uint64_t KillAfter(std::chrono::microseconds wait);

 private:
  bool ReadOne();

  pid_t child_ = -1;
  int pipe_ = -1;
  uint64_t acknowledged_ = 0;
};

/// The demo house as requests: what a hand drew and chose, at full speed.
std::vector<app::SessionRequest> HouseRequests();

}  // namespace parti::tests
