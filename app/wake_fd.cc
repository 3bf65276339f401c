#include "app/wake_fd.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cstdint>

#include "base/check.h"

namespace parti::app {

WakeFd::WakeFd() : fd_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  CHECK(fd_ >= 0, "the process has no file descriptors left");
}

WakeFd::~WakeFd() { close(fd_); }

void WakeFd::Wake() const {
  const uint64_t one = 1;
  // It fails only where the count is at its end, and then whoever waits is awake already.
  [[maybe_unused]] const ssize_t written = write(fd_, &one, sizeof one);
}

bool WakeFd::Clear() const {
  uint64_t count = 0;
  return read(fd_, &count, sizeof count) == sizeof count;
}

}  // namespace parti::app
