#include "app/document.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "app/document_lock.h"
#include "app/document_migration.h"
#include "app/document_record.h"
#include "app/document_values.h"
#include "base/text_file.h"

namespace parti::app {
namespace {

namespace fs = std::filesystem;

/// Every state, and at last the present one once more, so that it is the present one.
Result<void> WriteStates(Database* database, const Document& document) {
  Result<void> done;
  StateSpan span = document.span;
  span.now = span.first;
  for (const SessionRecord& state : document.states) {
    if (done) done = WriteState(database, span, PartsOf(state));
    ++span.now;
  }
  return done ? WriteState(database, document.span, PartsOf(PresentOf(document))) : done;
}

Result<void> WriteAll(Database* database, const Document& document) {
  auto done = database->Execute("BEGIN");
  if (done) done = MakeTables(database);
  for (size_t i = 0; done && i < document.strokes.size(); ++i) {
    done = WriteStroke(database, *document.strokes[i]);
  }
  for (size_t i = 0; done && i < document.history.size(); ++i) {
    done = WriteHistory(database, document.history[i]);
  }
  if (done) done = WriteStates(database, document);
  if (done) done = WritePosted(database, document.posted);
  for (size_t i = 0; done && i < document.laid_aside.size(); ++i) {
    done = WriteLaidAside(database, document.laid_aside[i]);
  }
  if (done) done = database->Execute("COMMIT");
  return done;
}

Result<void> WriteNewFile(const Document& document, const std::string& path) {
  auto database = Database::Open(path, Database::Mode::kCreate);
  if (!database) return Fail(database);
  auto done = database->Execute("PRAGMA synchronous=FULL");
  return done ? WriteAll(&*database, document) : done;
}

bool Exists(const std::string& path) {
  std::error_code code;
  return fs::exists(path, code);
}

/// Files that SQLite keeps beside a database while it works: what a killed program left in them
/// belongs to that database, and would destroy another of the same name.
constexpr std::array kBeside = {"-wal", "-journal", "-shm"};

/// Whether what a database holds is not in its file alone.
bool HasLog(const std::string& path) { return Exists(path + "-wal") || Exists(path + "-journal"); }

void SettleLog(const std::string& path) {
  if (!HasLog(path)) return;
  if (auto old = Database::Open(path, Database::Mode::kWrite)) {
    static_cast<void>(old->Execute("PRAGMA journal_mode=DELETE"));
  }
}

/// A rename is on the disk when its folder is.
void FlushFolderOf(const std::string& path) {
  std::error_code code;
  const fs::path folder = fs::absolute(path, code).parent_path();
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  ::fsync(fd);
  ::close(fd);
}

/// Takes errno as the reason; call it at once.
tl::unexpected<Error> CantWrite(const std::string& path, const char* hint) {
  const int reason = errno;
  return Fail(ErrorCode::kFile, fmt::format("can't write {}: {}", path, std::strerror(reason)),
              hint);
}

/// Whether a document may take the place of what is there: no folder, device or pipe, and no file
/// that may not be written.
Result<void> MayReplace(const std::string& path, const struct stat& old) {
  if (!S_ISREG(old.st_mode)) {
    return Fail(ErrorCode::kFile, fmt::format("can't write {}: it is not a regular file", path),
                "give a name of its own to a document");
  }
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0) return {};
  return CantWrite(path, "check that you may write it, or save it elsewhere");
}

Result<void> Rename(const std::string& from, const std::string& to) {
  if (std::rename(from.c_str(), to.c_str()) == 0) return {};
  return CantWrite(to, "check that the name is not a folder's");
}

Result<Document> ReadFrom(const std::string& path, Database::Mode mode) {
  auto database = Database::Open(path, mode);
  if (!database) return Fail(database);
  return ReadAnyVersion(&*database, path);
}

/// Reads a copy, for documents with a log in folders where nothing can be made: SQLite would need
/// a file beside them.
Result<Document> ReadFromCopy(const std::string& path) {
  std::error_code code;
  const fs::path folder =
      fs::temp_directory_path(code) / fmt::format("parti-{}-{}", ::getuid(), ::getpid());
  fs::create_directory(folder, code);
  const std::string copy = (folder / "copy.parti").string();
  fs::copy_file(path, copy, fs::copy_options::overwrite_existing, code);
  for (const char* log : {"-wal", "-journal"}) {
    if (!code && Exists(path + log)) {
      fs::copy_file(path + log, copy + log, fs::copy_options::overwrite_existing, code);
    }
  }
  auto document = code ? Result<Document>(Fail(ErrorCode::kFile, fmt::format("can't read {}: {}",
                                                                             path, code.message())))
                       : ReadFrom(copy, Database::Mode::kWrite);
  fs::remove_all(folder, code);
  return document;
}

}  // namespace

const SessionRecord& PresentOf(const Document& document) {
  return document.states[document.span.now - document.span.first];
}

Document DocumentOf(const Session& session) {
  Document document;
  document.span = session.timeline().span();
  for (uint64_t i = document.span.first; i <= document.span.last; ++i) {
    document.states.push_back(session.timeline().step(i).record);
  }
  std::map<uint32_t, std::shared_ptr<const DrawnStroke>> strokes;
  for (const SessionRecord& state : document.states) {
    for (const auto& drawn : state.strokes) strokes[drawn->number] = drawn;
    for (const auto& drawn : state.unread) strokes[drawn->number] = drawn;
  }
  for (const HistoryEntry& entry : session.history()) {
    if (entry.stroke) strokes[entry.stroke->number] = entry.stroke;
    document.history.push_back(entry.stroke ? fmt::format("stroke {}", entry.stroke->number)
                                            : TextOf(*entry.command));
  }
  for (auto& [number, drawn] : strokes) document.strokes.push_back(std::move(drawn));
  return document;
}

Result<Session> SessionOf(const Document& document, const SessionOptions& options) {
  auto present = Restore(PresentOf(document), options);
  if (!present) return Fail(present);
  const uint32_t drawn = document.strokes.empty() ? 0 : document.strokes.back()->number + 1;
  return Session(Timeline(document.states, document.span.first, document.span.now,
                          std::move(*present), options.undo),
                 drawn, options);
}

Result<void> SaveDocument(const Document& document, const std::string& path) {
  if (const auto holder = DocumentLock::HolderOf(path)) {
    return Fail(ErrorCode::kFile, fmt::format("{} is open in {}", path, *holder),
                "close it there, or save it under another name");
  }
  SettleLog(BehindLinks(path));
  return ReplaceDocument(document, path);
}

Result<void> ReplaceDocument(const Document& document, const std::string& path) {
  const std::string target = BehindLinks(path);
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (const auto may = exists ? MayReplace(path, old) : Result<void>(); !may) return may;
  const std::string temporary = fmt::format("{}.{}.tmp", target, ::getpid());
  std::remove(temporary.c_str());
  auto done = WriteNewFile(document, temporary);
  if (done && exists && ::chmod(temporary.c_str(), old.st_mode & 07777) != 0) {
    done = CantWrite(path, "check that you own it");
  }
  if (done) {
    for (const char* log : kBeside) std::remove((target + log).c_str());
    done = Rename(temporary, target);
  }
  if (done) {
    FlushFolderOf(target);
  } else {
    std::remove(temporary.c_str());
    std::string& message = done.error().message;  // the name that was asked for
    const size_t at = message.find(temporary);
    if (at != std::string::npos) message.replace(at, temporary.size(), path);
  }
  return done;
}

Result<Document> OpenDocument(const std::string& path) {
  auto document = ReadFrom(path, Database::Mode::kRead);
  if (document || document.error().code != ErrorCode::kFile || !Exists(path)) return document;
  const std::string target = BehindLinks(path);  // logs lie beside the file, not beside a link
  return HasLog(target) ? ReadFromCopy(target) : ReadFrom(path, Database::Mode::kReadAlone);
}

bool LooksLikeDocument(const std::string& path) {
  char head[16] = {};
  std::ifstream in(path, std::ios::binary);
  return in.read(head, sizeof head) && std::memcmp(head, "SQLite format 3", sizeof head) == 0;
}

}  // namespace parti::app
