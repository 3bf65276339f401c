#include "app/acknowledgement_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace parti::app {
namespace {

tl::unexpected<Error> CannotWrite(const std::string& path) {
  const int reason = errno;
  return Fail(ErrorCode::kFile, fmt::format("can't write {}: {}", path, std::strerror(reason)),
              "name a file that can be written, on a disk with room");
}

}  // namespace

Result<AcknowledgementLog> AcknowledgementLog::Open(const std::string& path) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (fd < 0) return CannotWrite(path);
  return AcknowledgementLog(fd, path);
}

AcknowledgementLog::AcknowledgementLog(AcknowledgementLog&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)),
      path_(std::move(other.path_)),
      acknowledged_(other.acknowledged_),
      failed_(other.failed_) {}

AcknowledgementLog& AcknowledgementLog::operator=(AcknowledgementLog&& other) noexcept {
  std::swap(fd_, other.fd_);
  path_ = std::move(other.path_);
  acknowledged_ = other.acknowledged_;
  failed_ = other.failed_;
  return *this;
}

AcknowledgementLog::~AcknowledgementLog() {
  if (fd_ >= 0) ::close(fd_);
}

Result<void> AcknowledgementLog::Note(const SessionSnapshot& snapshot) {
  std::string lines;
  if (snapshot.last_error && snapshot.last_error->number != failed_) {
    failed_ = snapshot.last_error->number;
    lines += fmt::format("failed {}: {}\n", *failed_, snapshot.last_error->error.message);
  }
  if (snapshot.acknowledged > acknowledged_) {
    acknowledged_ = snapshot.acknowledged;
    lines += fmt::format("acknowledged {}\n", acknowledged_);
  }
  if (lines.empty()) return {};
  const ssize_t written = ::write(fd_, lines.data(), lines.size());
  if (written != static_cast<ssize_t>(lines.size())) return CannotWrite(path_);
  return {};
}

}  // namespace parti::app
