#include "app/sqlite.h"

#include <fmt/format.h>
#include <sqlite3.h>

namespace parti::app {

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
  const int flags =
      mode == Mode::kRead ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  Database database;
  database.path_ = path;
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &handle, flags, nullptr);
  database.handle_.reset(handle);
  if (code != SQLITE_OK) return tl::unexpected<Error>(database.Failure());
  return database;
}

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
  switch (handle_ ? sqlite3_errcode(handle_.get()) : SQLITE_NOMEM) {
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_READONLY:
    case SQLITE_FULL:
    case SQLITE_IOERR:
    case SQLITE_NOMEM:
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {ErrorCode::kFile, fmt::format("can't use {}: {}", path_, reason),
              "check that the folder exists, that you may write there and that the disk has room"};
    default:
      return {ErrorCode::kDamagedFile, fmt::format("{} is not a whole document: {}", path_, reason),
              "open a copy of it from before it was damaged"};
  }
}

}  // namespace parti::app
