#include "app/commands/commands.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace parti::app {

void Say(const std::string& line) {
  // fmt::print would throw where standard error can't be written, and there is nobody left to tell.
  const std::string whole = line + "\n";
  std::fwrite(whole.data(), 1, whole.size(), stderr);
}

int Report(const Error& error) {
  Say(FormatError(error));
  return kFailed;
}

int PrintAnswer(std::string_view text) {
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (is_written && std::fflush(stdout) == 0) return kDone;
  return Report({ErrorCode::kFile,
                 fmt::format("can't write to standard output: {}", std::strerror(errno)),
                 "check that the disk has room"});
}

}  // namespace parti::app
