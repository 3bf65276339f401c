#include "app/document_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace parti::app {
namespace {

// Bytes of the page that SQLite keeps free for its own locks and never reads or writes; its locks
// end at +511 (the SQLite file format, 1.3 "The lock-byte page").
constexpr off_t kLockByte = 0x40000000 + 1024;
// A POSIX lock beside it tells whose it is: a lock of an open file has no process.
constexpr off_t kOwnerByte = kLockByte + 1;

struct flock Lock(off_t byte) {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = 1;
  return lock;
}

std::optional<FileIdentity> IdentityOf(const struct stat& status) {
  return FileIdentity{status.st_dev, status.st_ino};
}

std::optional<FileIdentity> IdentityOf(int fd) {
  struct stat status {};
  return ::fstat(fd, &status) == 0 ? IdentityOf(status) : std::nullopt;
}

/// The files that this process has locked: asking the kernel would need a descriptor, and closing
/// that gives up SQLite's locks on the file.
class OwnLocks {
 public:
  void Add(const FileIdentity& file) {
    const std::lock_guard lock(mutex_);
    files_.emplace_back(file);
  }
  void Remove(const FileIdentity& file) {
    const std::lock_guard lock(mutex_);
    const auto at = std::find(files_.begin(), files_.end(), file);
    if (at != files_.end()) files_.erase(at);
  }
  bool Has(const std::optional<FileIdentity>& file) {
    const std::lock_guard lock(mutex_);
    return file && std::find(files_.begin(), files_.end(), *file) != files_.end();
  }

 private:
  std::mutex mutex_;
  std::vector<FileIdentity> files_;
};

OwnLocks& Own() {
  static OwnLocks locks;
  return locks;
}

/// "Parti (process 4711)", as far as can be told.
std::string OwnerOf(int fd) {
  struct flock asked = Lock(kOwnerByte);
  if (::fcntl(fd, F_GETLK, &asked) == 0 && asked.l_type != F_UNLCK && asked.l_pid > 0) {
    return fmt::format("another Parti (process {})", asked.l_pid);
  }
  return "another Parti";
}

Error CannotWrite(const std::string& path, int error) {
  return {ErrorCode::kFile, fmt::format("{} can't be written: {}", path, std::strerror(error)),
          error == ENOENT ? "check the name, or save it as another file"
                          : "save it as another file, where you may write"};
}

}  // namespace

std::optional<FileIdentity> IdentityOf(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? IdentityOf(status) : std::nullopt;
}

Result<DocumentLock> DocumentLock::Take(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (fd < 0) return tl::unexpected<Error>(CannotWrite(path, errno));
  DocumentLock lock(path, fd, IdentityOf(fd).value_or(FileIdentity{}));
  struct flock wanted = Lock(kLockByte);
  if (::fcntl(fd, F_OFD_SETLK, &wanted) == 0) {
    struct flock owner = Lock(kOwnerByte);
    ::fcntl(fd, F_SETLK, &owner);  // only tells the name: no matter if it fails
    Own().Add(lock.identity_);
    lock.locked_ = true;
    return lock;
  }
  if (errno == EAGAIN || errno == EACCES) {
    return Fail(ErrorCode::kFile, fmt::format("{} is open in {}", path, OwnerOf(fd)),
                "close it there, or save it as another file here");
  }
  return Fail(ErrorCode::kFile,
              fmt::format("the file system of {} can't keep others from writing it: {}", path,
                          std::strerror(errno)),
              "save it as another file, on a disk of this machine");
}

std::optional<std::string> DocumentLock::HolderOf(const std::string& path) {
  if (Own().Has(IdentityOf(path))) return "this Parti";
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (fd < 0) return std::nullopt;
  struct flock asked = Lock(kLockByte);
  const bool held = ::fcntl(fd, F_OFD_GETLK, &asked) == 0 && asked.l_type != F_UNLCK;
  auto holder = held ? std::optional(OwnerOf(fd)) : std::nullopt;
  ::close(fd);
  return holder;
}

DocumentLock::DocumentLock(DocumentLock&& other) noexcept
    : path_(std::move(other.path_)),
      fd_(std::exchange(other.fd_, -1)),
      locked_(std::exchange(other.locked_, false)),
      identity_(other.identity_) {}

DocumentLock& DocumentLock::operator=(DocumentLock&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(fd_, other.fd_);
  std::swap(locked_, other.locked_);
  std::swap(identity_, other.identity_);
  return *this;
}

DocumentLock::~DocumentLock() {
  if (locked_) Own().Remove(identity_);
  if (fd_ >= 0) ::close(fd_);
}

bool DocumentLock::IsAt(const std::string& path) const { return IdentityOf(path) == identity_; }

}  // namespace parti::app
