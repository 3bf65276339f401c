#include "base/check.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

namespace parti {

void CheckFailed(const char* file, int line, const char* condition, std::string_view why) {
  // Not fmt::print, which throws where standard error can't be written.
  std::fputs(fmt::format("{}:{}: broken invariant: {}: {}\n", file, line, condition, why).c_str(),
             stderr);
  std::abort();
}

}  // namespace parti
