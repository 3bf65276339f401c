#include "app/document_drafts.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <system_error>

#include "app/user_folders.h"

namespace parti::app {
namespace {

namespace fs = std::filesystem;

fs::path DraftFolder(const std::string& data_folder) { return fs::path(data_folder) / "drafts"; }

}  // namespace

Result<std::string> NewDraftPath(const std::string& data_folder) {
  const fs::path folder = DraftFolder(data_folder);
  if (const auto made = MakeFolder(folder.string()); !made) return Fail(made);
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  const std::string name = fmt::format("{:%Y-%m-%d %H.%M.%S}", local);
  std::error_code code;
  for (int i = 1;; ++i) {  // several in one second
    fs::path path = folder / (i == 1 ? name + ".parti" : fmt::format("{} {}.parti", name, i));
    if (!fs::exists(path, code)) return path.string();
  }
}

std::vector<std::string> DraftsIn(const std::string& data_folder) {
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(DraftFolder(data_folder), code)) {
    if (entry.path().extension() != ".parti") continue;
    found.emplace_back(entry.last_write_time(code), entry.path().string());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<std::string> paths;
  for (auto& [time, path] : found) paths.push_back(std::move(path));
  return paths;
}

}  // namespace parti::app
