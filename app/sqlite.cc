#include "app/sqlite.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <sys/stat.h>

#include "app/file_ending.h"

namespace parti::app {
namespace {

int FlagsOf(Database::Mode mode) {
  switch (mode) {
    case Database::Mode::kRead:
      return SQLITE_OPEN_READONLY;
    case Database::Mode::kReadAlone:
      return SQLITE_OPEN_READONLY | SQLITE_OPEN_URI;
    case Database::Mode::kWrite:
      return SQLITE_OPEN_READWRITE;
    case Database::Mode::kCreate:
      return SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  }
  return SQLITE_OPEN_READONLY;
}

/// A path as SQLite reads it behind "file:".
std::string UriOf(const std::string& path) {
  std::string uri = "file:";
  for (const char c : path) {
    if (c == '%' || c == '?' || c == '#') {
      uri += fmt::format("%{:02x}", static_cast<unsigned>(c));
    } else {
      uri += c;
    }
  }
  return uri;
}

/// What helps against a failing of the disk, by SQLite's code.
std::string_view RemedyFor(int code) {
  switch (code) {
    case SQLITE_FULL:
      return "make room on the disk, or save it as another file elsewhere";
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return "check that the folder exists and that you may write there, or save it elsewhere";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "close the other program that writes into it, or save it as another file";
    default:
      return "check the disk, or save it as another file elsewhere";
  }
}

/// What a file that is no database may be instead, and what makes a document of it.
std::string RemedyForNoDocument(const std::string& path) {
  const std::string ending = EndingOf(path);
  if (ending == ".cga")
    return fmt::format("build what it says: parti derive '{}' --save house.parti", path);
  if (ending == ".pen") return fmt::format("play it: parti replay '{}' --save house.parti", path);
  return "open a .parti document; if this was one, a copy of it from before it was damaged";
}

}  // namespace

void Statement::Finalizer::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void Database::Closer::operator()(sqlite3* database) const { sqlite3_close(database); }

Statement& Statement::Bind(int index, std::string_view text) {
  sqlite3_bind_text64(handle_.get(), index, text.data(), text.size(), SQLITE_TRANSIENT,
                      SQLITE_UTF8);
  return *this;
}

Statement& Statement::Bind(int index, double value) {
  sqlite3_bind_double(handle_.get(), index, value);
  return *this;
}

Statement& Statement::Bind(int index, int64_t value) {
  sqlite3_bind_int64(handle_.get(), index, value);
  return *this;
}

Statement& Statement::BindBlob(int index, std::string_view bytes) {
  sqlite3_bind_blob64(handle_.get(), index, bytes.data(), bytes.size(), SQLITE_TRANSIENT);
  return *this;
}

Result<bool> Statement::Step() {
  const int code = sqlite3_step(handle_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return tl::unexpected<Error>(database_->Failure());
}

Result<void> Statement::Run() {
  const auto stepped = Step();
  if (!stepped) return Fail(stepped);
  sqlite3_reset(handle_.get());
  return {};
}

std::string Statement::Text(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(handle_.get(), column));
  const int size = sqlite3_column_bytes(handle_.get(), column);
  return bytes ? std::string(bytes, static_cast<size_t>(size)) : std::string();
}

double Statement::Number(int column) const { return sqlite3_column_double(handle_.get(), column); }

int64_t Statement::Integer(int column) const { return sqlite3_column_int64(handle_.get(), column); }

Result<Database> Database::Open(const std::string& path, Mode mode) {
  constexpr int kWait_ms = 2000;
  struct stat facts {};
  if (::stat(path.c_str(), &facts) == 0 && !S_ISREG(facts.st_mode)) {
    return Fail(ErrorCode::kFile,
                fmt::format("{} is a {}, not a file", path,
                            S_ISDIR(facts.st_mode) ? "folder" : "device or a pipe"),
                "open a .parti document");
  }
  Database database;
  database.path_ = path;
  sqlite3* handle = nullptr;
  const std::string name = mode == Mode::kReadAlone ? UriOf(path) + "?immutable=1" : path;
  const int code = sqlite3_open_v2(name.c_str(), &handle, FlagsOf(mode), nullptr);
  database.handle_.reset(handle);
  if (code != SQLITE_OK) return tl::unexpected<Error>(database.Failure());
  sqlite3_busy_timeout(handle, kWait_ms);
  return database;
}

Result<Database> Database::CopyInMemory() {
  auto copy = Open(":memory:", Mode::kCreate);
  if (!copy) return copy;
  sqlite3_backup* backup = sqlite3_backup_init(copy->handle_.get(), "main", handle_.get(), "main");
  if (backup != nullptr) sqlite3_backup_step(backup, -1);  // -1: all pages
  // Finishing reports what went wrong on the way.
  if (backup == nullptr || sqlite3_backup_finish(backup) != SQLITE_OK) {
    Error error = copy->Failure();
    error.message = fmt::format("can't read {}: {}", path_, error.message);
    return tl::unexpected<Error>(std::move(error));
  }
  return copy;
}

Result<int64_t> Database::Pragma(const std::string& name) {
  auto statement = Prepare("PRAGMA " + name);
  if (!statement) return Fail(statement);
  const auto row = statement->Step();
  if (!row) return Fail(row);
  return statement->Integer(0);
}

Result<int> Database::Checkpoint() {
  int in_log = 0;
  const int code = sqlite3_wal_checkpoint_v2(handle_.get(), nullptr, SQLITE_CHECKPOINT_PASSIVE,
                                             &in_log, nullptr);
  if (code != SQLITE_OK) return tl::unexpected<Error>(Failure());
  return in_log;
}

int64_t Database::last_row() const { return sqlite3_last_insert_rowid(handle_.get()); }

Result<void> Database::Execute(const std::string& sql) {
  if (sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK) return {};
  return tl::unexpected<Error>(Failure());
}

Result<Statement> Database::Prepare(std::string_view sql) {
  sqlite3_stmt* handle = nullptr;
  const int code =
      sqlite3_prepare_v2(handle_.get(), sql.data(), static_cast<int>(sql.size()), &handle, nullptr);
  Statement statement;
  statement.handle_.reset(handle);
  statement.database_ = this;
  if (code != SQLITE_OK) return tl::unexpected<Error>(Failure());
  return statement;
}

Error Database::Failure() const {
  const char* reason = handle_ ? sqlite3_errmsg(handle_.get()) : "out of memory";
  const int code = handle_ ? sqlite3_errcode(handle_.get()) : SQLITE_NOMEM;
  switch (code) {
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_READONLY:
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_NOMEM:
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {ErrorCode::kFile, fmt::format("can't use {}: {}", path_, reason),
              std::string(RemedyFor(code))};
    case SQLITE_NOTADB:
      return {ErrorCode::kDamagedFile, fmt::format("{} is no Parti document", path_),
              RemedyForNoDocument(path_)};
    default:
      return {ErrorCode::kDamagedFile, fmt::format("{} is not a whole document: {}", path_, reason),
              "open a copy of it from before it was damaged"};
  }
}

}  // namespace parti::app
