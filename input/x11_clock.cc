#include "input/x11_clock.h"

#include <algorithm>
#include <cmath>

namespace parti::input {

double X11Clock::ToSeconds(uint32_t time_ms, double now_s) {
  const double now_on_server_ms = (now_s - shift_s_.value_or(0)) * 1000;
  const auto whole_ms = static_cast<int64_t>(std::llround(now_on_server_ms));
  // The full time nearest to now whose lower 32 bits these are.
  const auto ahead_ms = static_cast<int32_t>(time_ms - static_cast<uint32_t>(whole_ms));
  double t_s = static_cast<double>(whole_ms + ahead_ms) / 1000;
  if (!shift_s_) {
    shift_s_ = std::abs(t_s - now_s) > kNear_s ? now_s - t_s : 0;
  }
  t_s += *shift_s_;
  return Local(t_s);
}

double X11Clock::Local(double now_s) { return last_s_ = std::max(last_s_, now_s); }

}  // namespace parti::input
