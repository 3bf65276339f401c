#include "app/folder_list.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>
#include <tuple>

#include "app/document_drafts.h"
#include "app/file_ending.h"
#include "app/recent_files.h"

namespace parti::app {
namespace {

namespace fs = std::filesystem;

bool IsShown(const fs::path& path, bool is_folder) {
  const bool hidden = path.filename().string().starts_with('.');
  return !hidden && (is_folder || path.extension() == kDocumentEnding);
}

std::string Folded(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

fs::path Absolute(const std::string& path) {
  const char* home = std::getenv("HOME");
  std::error_code failed;
  const fs::path absolute = fs::absolute(path.empty() && home ? home : path, failed);
  return failed ? fs::path("/") : absolute.lexically_normal();
}

}  // namespace

PanelFiles ListOf(const FolderRequest& request, const UserFolders& folders) {
  PanelFiles files;
  for (const std::string& draft : request.throw_away) {
    std::error_code unknown;
    if (!fs::exists(draft, unknown)) continue;
    const auto gone = ThrowAwayDraft(folders.data, draft);
    if (!gone) files.trouble = gone.error().message;
  }
  if (!folders.data.empty()) files.drafts = DraftsLeft(folders.data);
  files.recent = RecentFiles(folders.state);
  std::erase_if(files.recent, [&](const auto& path) { return IsDraft(folders.data, path); });
  const fs::path folder = Absolute(request.folder);
  files.folder = folder.string();
  auto others = std::make_shared<std::set<std::string>>();
  std::error_code failed;
  for (fs::directory_iterator i(folder, failed), end; !failed && i != end; i.increment(failed)) {
    const std::string name = i->path().filename().string();
    std::error_code unknown;
    const bool is_folder = i->is_directory(unknown);
    if (IsShown(i->path(), is_folder) && files.here.size() < kMostFiles) {
      files.here.push_back({name, is_folder});
    } else {
      others->insert(name);
    }
  }
  files.others = std::move(others);
  std::sort(files.here.begin(), files.here.end(), [](const PanelFile& a, const PanelFile& b) {
    return std::tuple(!a.is_folder, Folded(a.name), a.name) <
           std::tuple(!b.is_folder, Folded(b.name), b.name);
  });
  return files;
}

}  // namespace parti::app
