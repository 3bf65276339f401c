// Commands from outside, for tests and scripts: lines of a FIFO, as in a drawing's command stream
// (command.h). Executing them is the session's.
#pragma once

#include <string>
#include <vector>

#include "app/command.h"
#include "base/error.h"

namespace parti::app {

/// A FIFO that is listened to; writers may come and go.
class CommandPipe {
 public:
  /// errors  kFile  there is no FIFO of that name, or it may not be opened.
  static Result<CommandPipe> Open(const std::string& path);
  CommandPipe(CommandPipe&& other) noexcept;
  CommandPipe& operator=(CommandPipe&& other) noexcept;
  ~CommandPipe();

  int fd() const { return fd_; }  ///< readable when Read has something to give

  /// What the lines that came since the last call say, in order, of at most 64 KiB: there may be
  /// more. Never waits. A line is read when its line feed has come; empty ones are left out, what
  /// is no command fails as ParseCommand, a line of more than 8 MiB with kLimitReached.
  std::vector<Result<Command>> Read();

 private:
  explicit CommandPipe(int fd) : fd_(fd) {}

  int fd_;
  std::string unread_;  // the beginning of a line
};

}  // namespace parti::app
