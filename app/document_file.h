// The file of a document while it is worked on: each change becomes one transaction that is on the
// disk when the call returns, and costs what changed, not what there is.
// What to do when a call fails is document_keeper.h's; whole documents are document.h's.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/document_lock.h"

namespace parti::app {

/// What one request did to a session.
struct DocumentChange {
  int64_t number = 0;                              ///< of the request; <= 0: left over by a kill
  std::shared_ptr<const DrawnStroke> stroke = {};  ///< null: none was drawn
  std::string command = {};                        ///< for the history; "" with a stroke or none
  std::optional<SessionRecord> state = {};         ///< nothing: it stayed as it was
  StateSpan span = {};  ///< with a state: which ones are left; it is the present one
  bool looks = false;   ///< nothing was done but look (IsLooking): nobody misses it

  bool IsEmpty() const { return !stroke && command.empty() && !state; }
};

/// A request that waits to be executed.
struct KeptRequest {
  int64_t number = 0;
  PostedRequest request;
};

/// Not thread-safe. SQLite in WAL mode, synchronous=FULL: a commit appends to the log and waits for
/// the disk; the log goes into the file itself in Tidy() and when the document is closed.
class DocumentFile {
 public:
  /// Opens a document that exists for writing, bringing it to the newest version.
  /// errors  kFile  locked by another process, not writable, full disk …;  kDamagedFile.
  static Result<DocumentFile> Open(const std::string& path);

  /// Everything in it. errors  as ReadTables.
  Result<Document> Read();

  /// Readies the requests that a killed program left over, `Document::posted`: their numbers end
  /// with 0 from now on. What ended the program twice is laid aside; what is set about for the
  /// first time is counted, all at once: there may be much of it. errors  as Apply.
  Result<void> TakeUpLeftOver(const std::vector<PostedRequest>& posted);

  /// Counts one that had been begun before, when it is set about and before it is: so only what
  /// ends the program is counted twice. errors  as Apply.
  Result<void> BeginLeftOver(int64_t number);

  /// Keeps requests that are not executed yet, so that they outlive the program. errors  as Apply.
  Result<void> Keep(const std::vector<KeptRequest>& requests);

  /// One transaction: all of these changes, or none. Requests kept up to the last one's number are
  /// forgotten: what they did is in the changes. Nothing is written where nothing changed.
  /// errors  kFile  naming what failed and the remedy; the file is as before.
  Result<void> Apply(std::span<const DocumentChange> changes);

  /// Empties the log where it has grown; takes tens of milliseconds then. errors  as Apply.
  Result<void> Tidy();

  /// Closes: the log goes into the file, so that it can be read where nothing can be written.
  ~DocumentFile();
  DocumentFile(DocumentFile&&) = default;
  DocumentFile& operator=(DocumentFile&&) = default;

  const std::string& path() const { return path_; }
  /// Whether the path still means this file.
  bool IsThere() const { return lock_.IsThere(); }
  /// Whether another path means it.
  bool IsAt(const std::string& path) const { return lock_.IsAt(path); }

 private:
  DocumentFile(std::string path, DocumentLock lock, Database database);
  void DropLog();
  Result<void> Write(const DocumentChange& change);
  Result<void> Forget(int64_t last);
  Result<void> InTransaction(const std::function<Result<void>()>& work);

  std::string path_, target_;        ///< as it was given, and behind links: the log lies there
  std::optional<FileIdentity> log_;  ///< SQLite's, of this document
  DocumentLock lock_;                // outlives the database: see document_lock.h
  Database database_;
  bool has_kept_ = false;  // requests may be in the table "posted"
};

}  // namespace parti::app
