// Says what is safe: a line for each request that outlives a power cut from now on. For tests that
// cut the power, and for scripts that wait for a command's end.
// Which requests are safe is the session thread's business (session_snapshot.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/session_snapshot.h"
#include "base/error.h"

namespace parti::app {

/// Lines "acknowledged N" with the number of the last request that is safe, and "failed N: why"; N
/// is 0 for opening the document that the program was started with.
class AcknowledgementLog {
 public:
  /// Appends to the file, which is made where there is none; a device or a FIFO is written into.
  /// errors  kFile  it can't be written.
  static Result<AcknowledgementLog> Open(const std::string& path);
  AcknowledgementLog(AcknowledgementLog&& other) noexcept;
  AcknowledgementLog& operator=(AcknowledgementLog&& other) noexcept;
  ~AcknowledgementLog();

  /// Writes what is new in a snapshot, at once. errors  kFile  it can't be written any more.
  Result<void> Note(const SessionSnapshot& snapshot);

 private:
  AcknowledgementLog(int fd, std::string path) : fd_(fd), path_(std::move(path)) {}

  int fd_;
  std::string path_;
  uint64_t acknowledged_ = 0;
  std::optional<uint64_t> failed_;
};

}  // namespace parti::app
