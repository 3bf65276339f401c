#include "app/user_folders.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace parti::app {
namespace {

std::string FromEnvironment(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && value[0] == '/' ? value : "";
}

std::string WithoutAHome() {
  std::error_code code;
  return (std::filesystem::temp_directory_path(code) / fmt::format("parti-{}", ::getuid()))
      .string();
}

}  // namespace

UserFolders UserFoldersFromEnvironment() {
  std::string data = FromEnvironment("XDG_DATA_HOME"), state = FromEnvironment("XDG_STATE_HOME");
  const std::string home = FromEnvironment("HOME");
  const std::string local = home.empty() ? WithoutAHome() : home + "/.local";
  if (data.empty()) data = local + "/share";
  if (state.empty()) state = local + "/state";
  return {data + "/parti", state + "/parti"};
}

std::string WholePath(const std::string& path) {
  std::error_code failed;
  const std::filesystem::path whole = std::filesystem::absolute(path, failed);
  return failed ? path : whole.lexically_normal().string();
}

Result<void> MakeFolder(const std::string& path) {
  std::string so_far;
  for (const auto& part : std::filesystem::path(path)) {
    so_far = (std::filesystem::path(so_far) / part).string();
    ::mkdir(so_far.c_str(), S_IRWXU);  // whether it worked shows at the end
  }
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return {};
  return Fail(ErrorCode::kFile, fmt::format("can't make the folder {}", path),
              "check that you may write there, or set XDG_DATA_HOME and XDG_STATE_HOME");
}

}  // namespace parti::app
