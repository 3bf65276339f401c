// CHECK: broken invariants of our own code, on in release too.
// Not for what a user, a file or a device can cause: those failures are Results (base/error.h).
#pragma once

#include <string_view>

namespace parti {

/// Prints "FILE:LINE: broken invariant: CONDITION: why" to standard error and aborts.
[[noreturn]] void CheckFailed(const char* file, int line, const char* condition,
                              std::string_view why);

}  // namespace parti

#define CHECK(condition, why) \
  ((condition) ? (void)0 : ::parti::CheckFailed(__FILE__, __LINE__, #condition, why))
