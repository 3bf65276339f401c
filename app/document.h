// The `.parti` document: one SQLite file with everything of a session (docs/document.md).
// Not responsible for writing while a person draws; that comes with the application.
#pragma once

#include <string>
#include <vector>

#include "app/session.h"

namespace parti::app {

/// What a document keeps, as one value.
struct Document {
  std::vector<Lot> lots;
  grammar::Trees trees;
  Camera view;                       ///< the view on the model when it was saved
  std::vector<DrawnStroke> strokes;  ///< every stroke, with pressure and time
  /// What was done, in order: "stroke N" (from 0) and commands as ParseCommand reads them.
  std::vector<std::string> history;
};

/// What is kept of a session.
Document DocumentOf(const Session& session);

/// Writes a whole document through a temporary file in the same folder: the old one or the new.
/// The same document gives the same bytes.
/// errors  kFile.
Result<void> SaveDocument(const Document& document, const std::string& path);

/// errors  kFile  it does not exist or can't be read;  kDamagedFile  not a document, a damaged one,
///         or one by a newer version of the program (the hint says which).
Result<Document> OpenDocument(const std::string& path);

/// Whether a file begins as SQLite files do; false where it can't be read.
bool LooksLikeDocument(const std::string& path);

inline constexpr int kDocumentApplicationId = 0x50525449;  // "PRTI"
inline constexpr int kDocumentVersion = 1;

}  // namespace parti::app
