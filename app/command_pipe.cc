#include "app/command_pipe.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace parti::app {

Result<CommandPipe> CommandPipe::Open(const std::string& path) {
  // Also for writing: so there is always a writer, and the end of one is no end of the pipe.
  const int fd = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) {
    return Fail(ErrorCode::kFile, fmt::format("{}: {}", path, std::strerror(errno)),
                "make it with mkfifo");
  }
  CommandPipe pipe(fd);
  struct stat status {};
  if (::fstat(fd, &status) != 0 || !S_ISFIFO(status.st_mode)) {
    return Fail(ErrorCode::kFile, path + " is not a FIFO", "make one with mkfifo");
  }
  return pipe;
}

CommandPipe::CommandPipe(CommandPipe&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)), unread_(std::move(other.unread_)) {}

CommandPipe& CommandPipe::operator=(CommandPipe&& other) noexcept {
  std::swap(fd_, other.fd_);
  std::swap(unread_, other.unread_);
  return *this;
}

CommandPipe::~CommandPipe() {
  if (fd_ >= 0) ::close(fd_);
}

std::vector<Result<Command>> CommandPipe::Read() {
  std::array<char, 4096> bytes{};
  ssize_t count = 0;
  while ((count = ::read(fd_, bytes.data(), bytes.size())) > 0) {
    unread_.append(bytes.data(), static_cast<size_t>(count));
  }
  std::vector<Result<Command>> commands;
  for (size_t end = 0; (end = unread_.find('\n')) != std::string::npos;) {
    const std::string line = unread_.substr(0, end);
    unread_.erase(0, end + 1);
    if (!line.empty()) commands.push_back(ParseCommand(line));
  }
  return commands;
}

}  // namespace parti::app
