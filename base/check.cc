#include "base/check.h"

#include <fmt/format.h>

#include <cstdlib>

namespace parti {

void CheckFailed(const char* file, int line, const char* condition, std::string_view why) {
  fmt::print(stderr, "{}:{}: broken invariant: {}: {}\n", file, line, condition, why);
  std::abort();
}

}  // namespace parti
