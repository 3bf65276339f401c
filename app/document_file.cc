#include "app/document_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "app/document_migration.h"
#include "app/document_reading.h"
#include "app/document_record.h"
#include "app/document_values.h"
#include "base/text_file.h"

namespace parti::app {
namespace {

// The log goes into the file when it is larger: in bytes; about SQLite's own default of 1000 pages.
constexpr uintmax_t kLargeLog = uintmax_t{4} << 20;

}  // namespace

Result<DocumentFile> DocumentFile::Open(const std::string& path) {
  auto lock = DocumentLock::Take(path);
  if (!lock) return Fail(lock);
  auto database = Database::Open(path, Database::Mode::kWrite);
  if (!database) return Fail(database);
  // Another program's file stays as it is: what follows, and closing a document, writes.
  if (const auto ours = VersionOf(&*database, path); !ours) return Fail(ours);
  DocumentFile file(path, std::move(*lock), std::move(*database));
  // FULL: a commit has reached the disk, not only the log. Checkpoints are made in Tidy(), and the
  // first commit after one cuts the log off: else it stayed large, and was tidied again each time.
  auto done = file.database_.Execute(
      "PRAGMA synchronous=FULL; PRAGMA journal_mode=WAL; PRAGMA wal_autocheckpoint=0;"
      "PRAGMA journal_size_limit=0");
  if (done) done = Migrate(&file.database_, path);
  if (!done) return Fail(done);
  return file;
}

DocumentFile::DocumentFile(std::string path, DocumentLock lock, Database database)
    : path_(std::move(path)),
      target_(BehindLinks(path_)),
      lock_(std::move(lock)),
      database_(std::move(database)) {}

DocumentFile::~DocumentFile() {
  if (!lock_.IsTaken()) return;
  if (lock_.IsThere()) {
    // Where another process is reading, the log stays until the next time.
    static_cast<void>(database_.Execute("PRAGMA journal_mode=DELETE"));
  } else {
    DropLog();
  }
}

/// Where another file has taken the place of ours, which is gone, our log lies beside it by name,
/// and whoever opens that file would read it into it. It goes, unless it is that file's own by now.
/// Where nothing is at the path, it stays: put back, the file is whole with it.
void DocumentFile::DropLog() {
  if (!IdentityOf(path_) || DocumentLock::HolderOf(path_)) return;
  if (!log_ || IdentityOf(target_ + "-wal") != log_) return;
  for (const char* beside : {"-wal", "-shm"}) std::remove((target_ + beside).c_str());
}

Result<Document> DocumentFile::Read() { return ReadTables(&database_, path_); }

Result<void> DocumentFile::TakeUpLeftOver(const std::vector<PostedRequest>& posted) {
  return InTransaction([&]() -> Result<void> {
    auto done = database_.Execute(
        fmt::format("INSERT INTO laid_aside(command, samples)"
                    "  SELECT command, samples FROM posted WHERE {} ORDER BY number;"
                    "DELETE FROM posted",
                    kLeftAlone));
    if (done) done = WritePosted(&database_, posted);
    if (done) done = database_.Execute("UPDATE posted SET begun = 1 WHERE begun = 0");
    has_kept_ = true;
    return done;
  });
}

Result<void> DocumentFile::BeginLeftOver(int64_t number) {
  auto count = database_.Prepare("UPDATE posted SET begun = begun + 1 WHERE number = ?");
  if (!count) return Fail(count);
  return count->Bind(1, number).Run();
}

Result<void> DocumentFile::InTransaction(const std::function<Result<void>()>& work) {
  auto done = database_.Execute("BEGIN IMMEDIATE");
  if (!done) return done;
  done = work();
  if (done) done = database_.Execute("COMMIT");
  if (done && !log_) log_ = IdentityOf(target_ + "-wal");
  // Some failures have rolled back already; then this one says so, and nobody needs to know.
  if (!done) static_cast<void>(database_.Execute("ROLLBACK"));
  return done;
}

Result<void> DocumentFile::Keep(const std::vector<KeptRequest>& requests) {
  return InTransaction([&]() -> Result<void> {
    has_kept_ = true;
    for (const auto& [number, request] : requests) {
      if (auto done = WritePosted(&database_, number, request); !done) return done;
    }
    return {};
  });
}

Result<void> DocumentFile::Write(const DocumentChange& change) {
  Result<void> done;
  if (change.stroke) done = WriteStroke(&database_, *change.stroke);
  if (done && change.stroke) {
    done = WriteHistory(&database_, fmt::format("stroke {}", change.stroke->number));
  }
  if (done && !change.command.empty()) done = WriteHistory(&database_, change.command);
  if (done && change.state) done = WriteState(&database_, change.span, PartsOf(*change.state));
  return done;
}

Result<void> DocumentFile::Forget(int64_t last) {
  if (!has_kept_) return {};
  auto forget = database_.Prepare("DELETE FROM posted WHERE number <= ?");
  if (!forget) return Fail(forget);
  return forget->Bind(1, last).Run();
}

Result<void> DocumentFile::Apply(std::span<const DocumentChange> changes) {
  const bool nothing = std::all_of(changes.begin(), changes.end(),
                                   [](const DocumentChange& change) { return change.IsEmpty(); });
  if (nothing && !has_kept_) return {};
  return InTransaction([&]() -> Result<void> {
    for (const DocumentChange& change : changes) {
      if (auto written = Write(change); !written) return written;
    }
    return Forget(changes.back().number);
  });
}

Result<void> DocumentFile::Tidy() {
  std::error_code code;
  if (std::filesystem::file_size(target_ + "-wal", code) < kLargeLog || code) return {};
  const auto emptied = database_.Checkpoint();
  return emptied ? Result<void>() : Fail(emptied);
}

}  // namespace parti::app
