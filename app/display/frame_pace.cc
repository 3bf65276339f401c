#include "app/display/frame_pace.h"

#include <sys/timerfd.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>

#include "base/check.h"

namespace parti::app {

FramePace::FramePace() : fd_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK)) {
  CHECK(fd_ >= 0, "the system has descriptors left");
}
FramePace::~FramePace() { ::close(fd_); }

void FramePace::CloseFor(double seconds_s) {
  const auto nanoseconds = static_cast<long>(std::llround(seconds_s * 1e9));
  if (nanoseconds <= 0) return;
  itimerspec once{};
  once.it_value = {nanoseconds / 1'000'000'000, nanoseconds % 1'000'000'000};
  ::timerfd_settime(fd_, 0, &once, nullptr);
  open_ = false;
}

bool FramePace::Look() {
  uint64_t times = 0;
  if (::read(fd_, &times, sizeof(times)) <= 0) return false;
  return open_ = true;
}

}  // namespace parti::app
