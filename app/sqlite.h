// The few calls of SQLite that documents need, with Results instead of codes.
// Knows nothing of what a document holds (document.h).
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/error.h"

struct sqlite3;
struct sqlite3_stmt;

namespace parti::app {

class Database;

/// A prepared statement. Values are bound from 1, columns read from 0.
class Statement {
 public:
  /// Puts a value into place `index`; a failure shows when the statement runs.
  Statement& Bind(int index, std::string_view text);
  Statement& Bind(int index, double value);
  Statement& Bind(int index, int64_t value);
  Statement& BindBlob(int index, std::string_view bytes);

  /// Steps once. true: a row is there to read. false: done.
  /// errors  kDamagedFile  the database is corrupt or of another shape;  kFile  it can't be
  /// written.
  Result<bool> Step();
  /// Steps to the end, expecting no rows.
  Result<void> Run();

  std::string Text(int column) const;  ///< bytes of a text or blob; "" for null
  double Number(int column) const;
  int64_t Integer(int column) const;

 private:
  friend class Database;
  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::unique_ptr<sqlite3_stmt, Finalizer> handle_;
  const Database* database_ = nullptr;
};

/// An open database file; closed when this goes.
class Database {
 public:
  enum class Mode {
    kRead,
    kReadAlone,  ///< as kRead, where no other process writes and no file may be made beside it
    kWrite,      ///< a file that is there
    kCreate,     ///< made where it is missing
  };
  /// Waits up to 2 s for other connections that write.
  /// errors  kFile  it can't be opened or made;  kDamagedFile  not a database.
  static Result<Database> Open(const std::string& path, Mode mode);

  /// A copy that can be changed and leaves nothing behind. errors  as Statement::Step.
  Result<Database> CopyInMemory();

  /// Runs, or readies, statements of SQL. errors  as Statement::Step.
  Result<void> Execute(const std::string& sql);
  Result<Statement> Prepare(std::string_view sql);
  /// The number that "PRAGMA name" gives.
  Result<int64_t> Pragma(const std::string& name);

  /// In WAL mode: what the log holds goes into the file itself, as far as no reader is in the way.
  /// returns  pages that are in the log.
  Result<int> Checkpoint();
  int64_t last_row() const;  ///< id of the row inserted last

 private:
  friend class Statement;
  Error Failure() const;

  struct Closer {
    void operator()(sqlite3* database) const;
  };
  std::string path_;
  std::unique_ptr<sqlite3, Closer> handle_;
};

}  // namespace parti::app
