// The `.parti` document: one SQLite file with everything of a session (docs/document.md).
// Whole documents, written and read at once; writing while a person draws is document_file.h's.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/document_tables.h"
#include "app/session.h"

namespace parti::app {

/// What a document keeps, as one value.
struct Document {
  std::vector<std::shared_ptr<const DrawnStroke>> strokes;  ///< all that are known, by number
  /// What was done, in order: "stroke N" (its number) and commands as ParseCommand reads them.
  std::vector<std::string> history;
  /// What undo and redo go through, oldest first: the states span.first … span.last; n >= 1.
  std::vector<SessionRecord> states;
  StateSpan span;                     ///< its `now` is the state that the person sees
  std::vector<PostedRequest> posted;  ///< to be executed first, in order
  /// What ended the program each time, for a report: not executed again. Those that were not laid
  /// aside before have been `begun`, the others not.
  std::vector<PostedRequest> laid_aside;
};

/// The state that the person sees.
const SessionRecord& PresentOf(const Document& document);

/// Everything of a session.
Document DocumentOf(const Session& session);

/// A session that goes on where the document left, undo and redo included; `posted` is the caller's
/// to execute. errors  those of Restore.
Result<Session> SessionOf(const Document& document, const SessionOptions& options);

/// Writes a whole document through a temporary file in the same folder: the old one or the new,
/// flushed to the disk. The same document gives the same bytes.
/// errors  kFile  it can't be written, or another Parti has it open.
Result<void> SaveDocument(const Document& document, const std::string& path);

/// As SaveDocument, where the caller itself has the old document open, and closes it before it
/// opens the new one.
Result<void> ReplaceDocument(const Document& document, const std::string& path);

/// Reads a document of this or an older version, also while another process writes it, and after
/// one that was killed.
/// errors  kFile  it does not exist or can't be read;  kDamagedFile  not a document, a damaged one,
///         or one by a newer version of the program (the hint says which).
Result<Document> OpenDocument(const std::string& path);

/// Whether a file begins as SQLite files do; false where it can't be read.
bool LooksLikeDocument(const std::string& path);

inline constexpr int kDocumentApplicationId = 0x50525449;  // "PRTI"
inline constexpr int kDocumentVersion = 3;

}  // namespace parti::app
