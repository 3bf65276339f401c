#include "app/replacing.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace parti::app {

Result<void> CheckNothingIsAt(const std::string& path) {
  std::error_code unknown;  // what can't be looked at can't be written either, and says so then
  if (!std::filesystem::exists(path, unknown)) return {};
  return Fail(ErrorCode::kFile,
              fmt::format("{} is there already, and what it holds would be lost", path),
              "choose another name, or say that it may be replaced");
}

}  // namespace parti::app
