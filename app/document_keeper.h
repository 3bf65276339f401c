// The open document and its fortunes: a draft that gets a name, a file that someone else has open,
// a disk that is full. Nothing is lost: what the file can't take is kept here until it can, or
// until another file takes everything.
// Knows nothing of threads (document_thread.h) nor of what changes mean.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document_file.h"
#include "app/session_snapshot.h"
#include "app/user_folders.h"

namespace parti::app {

/// Not thread-safe. New or Open comes first. What goes wrong with writing is in status(), and tried
/// again with each call.
class DocumentKeeper {
 public:
  explicit DocumentKeeper(UserFolders folders);
  ~DocumentKeeper();  ///< leaves the open document, as New does

  const DocumentStatus& status() const { return status_; }
  /// What was done up to this number is on the disk.
  int64_t acknowledged() const { return acknowledged_; }

  /// Whether the open document can be left: `give_up`, or nothing but looking is not on the disk,
  /// and the file is still there.
  /// errors  kFile  strokes or commands would be lost, or the whole document.
  Result<void> MayLeave(bool give_up) const;

  /// A new document without a name, which is `start` now. It gets a file, a draft, with the first
  /// change. The one that was open is left: a draft of its own in which nothing was done but begin,
  /// with a lot or a view, goes away.
  /// errors  those of MayLeave.
  Result<void> New(Document start, bool give_up);

  /// Opens a document, read-only where another process has it or where it can't be written;
  /// status() says why. A draft that was left stays a draft. Where this fails, what was open stays
  /// open. errors  those of OpenDocument and MayLeave.
  Result<Document> Open(const std::string& path, bool give_up);

  /// Writes everything to `path`, also what could not be written so far, and goes on there. A draft
  /// goes away. Where this fails, what was open stays open.
  /// in_memory  what the session knows, for where the open file can't be read any more.
  /// replace    another file may lie there, and goes; the document's own always may.
  /// errors  those of SaveDocument;  kFile  another file is there, and `replace` is false.
  Result<void> SaveAs(const std::string& path, Document in_memory, bool replace = false);

  /// For who has to leave: where strokes or commands can't be written where they belong, or the
  /// file is gone, makes a draft of everything and goes on there; status() says so. Else it does
  /// nothing. in_memory  as for SaveAs; without states where the session can't be asked. waiting
  /// requests that stay for the next opening, without what has been executed of them. errors kFile
  /// a draft was needed and can't be made.
  Result<void> Rescue(Document in_memory, const std::vector<KeptRequest>& waiting);

  /// All that is known of the open document, on the disk or not; `in_memory` as for SaveAs.
  Document Everything(Document in_memory);

  /// To be told before a request is executed that a kill left over, numbered up to 0, and that had
  /// been begun before: as of DocumentFile.
  void BeginLeftOver(int64_t number);

  /// Keeps requests that are not executed yet; they are not in `status().unwritten`.
  void Keep(const std::vector<KeptRequest>& requests);

  /// Writes changes, in one transaction with those that could not be written before.
  void Apply(std::vector<DocumentChange> changes);

  /// Tries once more to write what could not be written, and looks whether the file is still there.
  void TryAgain();

  /// Does what can be done when nobody waits for an acknowledgement.
  void Tidy();

 private:
  void Leave();
  bool IsGone() const;
  Result<void> MakeDraft();
  Result<void> Write();
  Result<void> WriteInto(const std::string& path, Document document);
  void CountUnwritten();
  void Acknowledge(int64_t number);
  void GoOnIn(const std::string& path, Result<DocumentFile> file, Document document);
  void Note(const Result<void>& done);
  void DropOldStates();

  UserFolders folders_;
  DocumentStatus status_;
  int64_t acknowledged_ = 0;
  std::optional<DocumentFile> file_;
  bool is_own_draft_ = false;  ///< file_ was made by MakeDraft
  bool was_gone_ = false;      ///< the last time that TryAgain looked
  bool only_begun_ = true;     ///< nothing was done since New but give it a lot and look
  /// The document as it was before `unwritten_`, where there is no file to read it from.
  Document start_;
  std::vector<DocumentChange> unwritten_;
};

/// Makes a change to a document in memory.
void ApplyTo(const DocumentChange& change, Document* document);

}  // namespace parti::app
