// An X server's 32-bit milliseconds as the seconds of everything else (CLOCK_MONOTONIC).
// Not responsible for the order of events.
#pragma once

#include <cstdint>
#include <optional>

namespace parti::input {

/// Value-typed. Xorg's clock is CLOCK_MONOTONIC with its upper bits cut off (they come back every
/// 50 days); servers elsewhere have a clock of their own, which is then shifted as a whole, so that
/// the first event comes when it is noticed.
class X11Clock {
 public:
  /// `now_s` is CLOCK_MONOTONIC at which `time_ms` was noticed. The result never decreases.
  double ToSeconds(uint32_t time_ms, double now_s);

  /// The time of what is not the server's to tell: CLOCK_MONOTONIC's now_s, but never before what
  /// was given out.
  double Local(double now_s);

  /// A foreign clock is one that is farther off than this; events wait for less. [s]
  static constexpr double kNear_s = 2;

 private:
  std::optional<double> shift_s_;
  double last_s_ = 0;
};

}  // namespace parti::input
