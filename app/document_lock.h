// Who writes a document: a lock on the file itself, which goes when the process does, however it
// ends. A second instance finds it taken, is told by whom, and reads.
// Not responsible for SQLite's own locks, which only last for a transaction.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "base/error.h"

namespace parti::app {

/// Which file a name meant when it was opened.
struct FileIdentity {
  dev_t device = 0;
  ino_t inode = 0;
  bool operator==(const FileIdentity&) const = default;
};

/// Nothing where there is no file.
std::optional<FileIdentity> IdentityOf(const std::string& path);

/// An exclusive lock. Keep it longer than any other descriptor of the file that this process has:
/// closing it gives up the process's POSIX locks on the file, SQLite's among them.
class DocumentLock {
 public:
  /// Neither waits nor writes; the file must exist.
  /// errors  kFile  another process (or another lock in this one) has it, named where it can be;
  ///         you may not write the file; its file system has no locks. The hint says what to do.
  static Result<DocumentLock> Take(const std::string& path);

  /// Who has the document open for writing, "another Parti (process 4711)", "this Parti"; nothing
  /// where nobody.
  static std::optional<std::string> HolderOf(const std::string& path);

  DocumentLock(DocumentLock&& other) noexcept;
  DocumentLock& operator=(DocumentLock&& other) noexcept;
  ~DocumentLock();

  bool IsTaken() const { return fd_ >= 0; }  ///< false: moved away
  /// Whether a path means the locked file.
  bool IsAt(const std::string& path) const;
  /// Whether the name it was taken by still means the locked file: not deleted, moved or replaced.
  bool IsThere() const { return IsAt(path_); }

 private:
  DocumentLock(std::string path, int fd, const FileIdentity& identity)
      : path_(std::move(path)), fd_(fd), identity_(identity) {}

  std::string path_;
  int fd_ = -1;
  bool locked_ = false;
  FileIdentity identity_;
};

}  // namespace parti::app
