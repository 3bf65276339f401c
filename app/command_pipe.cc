#include "app/command_pipe.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

namespace parti::app {
namespace {

constexpr size_t kMostAtOnce = size_t{64} << 10;  ///< bytes of a call, so that a flood ends each
constexpr size_t kLongestLine = size_t{8} << 20;

}  // namespace

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
  std::vector<char> bytes(kMostAtOnce);
  const ssize_t count = ::read(fd_, bytes.data(), bytes.size());
  std::vector<Result<Command>> commands;
  for (ssize_t i = 0; i < count; ++i) {
    const char c = bytes[static_cast<size_t>(i)];
    if (c != '\n') {
      if (unread_.size() <= kLongestLine) unread_ += c;
      continue;
    }
    const std::string line = std::exchange(unread_, {});
    if (line.size() > kLongestLine) {
      commands.emplace_back(
          Fail(ErrorCode::kLimitReached, "a line is longer than 8 MiB", "give a command per line"));
    } else if (!line.empty()) {
      commands.push_back(ParseCommand(line));
    }
  }
  return commands;
}

}  // namespace parti::app
