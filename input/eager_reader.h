// Reads devices on a thread of its own, so that all they send is taken in time, however long a
// frame takes to draw: the kernel keeps a pen's last fifth of a second or so and drops the rest.
// Not responsible for what is read (libinput_source.h).
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/error.h"
#include "base/event.h"

namespace parti::input {

/// Properties  (1) nothing is lost, doubled or reordered, whoever reads it;
///             (2) `read` and what is done in Alone are never at work at the same time.
class EagerReader {
 public:
  /// What came since the last call, without waiting; a failure is the last call.
  using Read = std::function<Result<std::vector<InputEvent>>()>;

  /// fd is readable when `read` has something to give. Both outlive this.
  EagerReader(int fd, Read read);
  ~EagerReader();
  EagerReader(const EagerReader&) = delete;
  EagerReader& operator=(const EagerReader&) = delete;

  /// Readable when Take has something to give.
  int fd() const { return came_; }

  /// Everything up to now, without waiting for more. errors  those of `read`.
  Result<std::vector<InputEvent>> Take();

  /// Does what must not happen while devices are read, such as giving them back; gives its result.
  template <typename Work>
  auto Alone(const Work& work) {
    const std::lock_guard lock(mutex_);
    return work();
  }

 private:
  void Run();
  void ReadOnce();  // under the lock

  int fd_;
  Read read_;
  int came_;  // an eventfd
  int stop_;  // another
  std::mutex mutex_;
  std::vector<InputEvent> events_;
  std::optional<Error> failed_;
  std::thread thread_;
};

}  // namespace parti::input
