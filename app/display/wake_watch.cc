#include "app/display/wake_watch.h"

#include <sys/timerfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <ctime>

#include "base/check.h"

namespace parti::app {
namespace {

constexpr double kLeastSleep_s = 0.05;  ///< far above what reading two clocks takes

double Read(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

/// Since the machine was started.
double Asleep_s() { return Read(CLOCK_BOOTTIME) - Read(CLOCK_MONOTONIC); }

}  // namespace

WakeWatch::WakeWatch()
    : fd_(::timerfd_create(CLOCK_REALTIME, TFD_CLOEXEC | TFD_NONBLOCK)), asleep_s_(Asleep_s()) {
  CHECK(fd_ >= 0, "the system has descriptors left");
  Arm();
}
WakeWatch::~WakeWatch() { ::close(fd_); }

void WakeWatch::Arm() const {
  itimerspec never{};
  never.it_value.tv_sec = std::time(nullptr) + 100'000'000;  // years away
  ::timerfd_settime(fd_, TFD_TIMER_ABSTIME | TFD_TIMER_CANCEL_ON_SET, &never, nullptr);
}

bool WakeWatch::Look() {
  uint64_t times = 0;
  // Fails with ECANCELED when the clock jumped, with EAGAIN otherwise.
  if (::read(fd_, &times, sizeof(times)) < 0 && errno == ECANCELED) Arm();
  const double asleep_s = Asleep_s();
  const bool slept = asleep_s - asleep_s_ > kLeastSleep_s;
  asleep_s_ = asleep_s;
  return slept;
}

}  // namespace parti::app
