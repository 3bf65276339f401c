#include "app/document_drafts.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <system_error>

#include "app/document_lock.h"
#include "app/file_ending.h"
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
  for (int i = 1;; ++i) {  // several in one second
    const fs::path path =
        folder / fmt::format("{}{}{}", name, i == 1 ? "" : fmt::format(" {}", i), kDocumentEnding);
    const int fd = ::open(path.c_str(), O_CREAT | O_EXCL | O_CLOEXEC | O_WRONLY, S_IRUSR | S_IWUSR);
    if (fd >= 0) {
      ::close(fd);
      return path.string();
    }
    if (errno != EEXIST) {
      return Fail(ErrorCode::kFile,
                  fmt::format("can't make {}: {}", path.string(), std::strerror(errno)),
                  "make room or get permission there, or save it as another file elsewhere");
    }
  }
}

bool IsDraft(const std::string& data_folder, const std::string& path) {
  if (data_folder.empty()) return false;
  const fs::path drafts = DraftFolder(data_folder);
  const fs::path folder = fs::path(WholePath(path)).parent_path();
  // By its name first: a path may be on a disk that does not answer.
  if (folder.filename() != drafts.filename()) return false;
  std::error_code failed;
  return folder == drafts || fs::equivalent(folder, drafts, failed);
}

std::vector<std::string> DraftsIn(const std::string& data_folder) {
  std::vector<std::pair<fs::file_time_type, std::string>> found;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(DraftFolder(data_folder), code)) {
    if (entry.path().extension() != kDocumentEnding || entry.file_size(code) == 0) continue;
    found.emplace_back(entry.last_write_time(code), entry.path().string());
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<std::string> paths;
  for (auto& [time, path] : found) paths.push_back(std::move(path));
  return paths;
}

std::vector<std::string> DraftsLeft(const std::string& data_folder) {
  std::vector<std::string> paths = DraftsIn(data_folder);
  std::erase_if(paths,
                [](const std::string& path) { return DocumentLock::HolderOf(path).has_value(); });
  return paths;
}

Result<void> ThrowAwayDraft(const std::string& data_folder, const std::string& path) {
  const std::vector<std::string> drafts = DraftsIn(data_folder);
  if (std::find(drafts.begin(), drafts.end(), path) == drafts.end()) {
    return Fail(ErrorCode::kFile, fmt::format("{} is no draft", path));
  }
  if (const auto holder = DocumentLock::HolderOf(path)) {
    return Fail(ErrorCode::kFile, fmt::format("{} is open in {}", path, *holder), "close it there");
  }
  std::error_code failed;
  fs::remove(path, failed);
  if (failed) {
    return Fail(ErrorCode::kFile, fmt::format("can't delete {}: {}", path, failed.message()));
  }
  for (const char* beside : {"-wal", "-shm"}) fs::remove(path + beside, failed);
  return {};
}

}  // namespace parti::app
