#include "app/recent_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "app/user_folders.h"
#include "base/text_file.h"

namespace parti::app {
namespace {

std::string ListPath(const std::string& state_folder) { return state_folder + "/recent"; }

/// Paths may hold line feeds: one path a line, with \n and \\.
std::string Escaped(const std::string& path) {
  std::string line;
  for (const char c : path) line += c == '\n' ? "\\n" : c == '\\' ? "\\\\" : std::string(1, c);
  return line + '\n';
}

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> paths(1);
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') {
      paths.emplace_back();
    } else if (text[i] == '\\' && i + 1 < text.size()) {
      paths.back() += text[++i] == 'n' ? '\n' : text[i];
    } else {
      paths.back() += text[i];
    }
  }
  std::erase_if(paths, [](const std::string& path) { return path.empty() || path[0] != '/'; });
  if (paths.size() > kMostRecentFiles) paths.resize(kMostRecentFiles);
  return paths;
}

/// Instances change the list one after the other; it goes when the process does.
class ListLock {
 public:
  explicit ListLock(const std::string& state_folder)
      : fd_(::open((state_folder + "/recent.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC,
                   S_IRUSR | S_IWUSR)) {
    if (fd_ >= 0) ::flock(fd_, LOCK_EX);
  }
  ~ListLock() {
    if (fd_ >= 0) ::close(fd_);
  }
  ListLock(const ListLock&) = delete;
  ListLock& operator=(const ListLock&) = delete;

 private:
  int fd_;
};

}  // namespace

std::vector<std::string> RecentFiles(const std::string& state_folder) {
  const auto text = ReadFile(ListPath(state_folder));
  return text ? Lines(*text) : std::vector<std::string>();
}

void NoteRecentFile(const std::string& state_folder, const std::string& path) {
  if (!MakeFolder(state_folder)) return;
  const std::string whole = WholePath(path);
  const ListLock lock(state_folder);
  std::vector<std::string> paths = RecentFiles(state_folder);
  std::erase(paths, whole);
  paths.insert(paths.begin(), whole);
  if (paths.size() > kMostRecentFiles) paths.resize(kMostRecentFiles);
  std::string text;
  for (const std::string& recent : paths) text += Escaped(recent);
  static_cast<void>(WriteFile(ListPath(state_folder), text));
}

}  // namespace parti::app
