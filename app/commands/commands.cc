#include "app/commands/commands.h"

#include <fmt/format.h>

namespace parti::app {

int Report(const Error& error) {
  fmt::print(stderr, "{}\n", FormatError(error));
  return kFailed;
}

}  // namespace parti::app
