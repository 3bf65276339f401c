// Drafts: documents that have no name yet live in the user's data folder, so that nothing is lost
// before the first "save as". How a document is written is document.h's.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace parti::app {

/// A path for a new draft below `data_folder`/drafts, named after the local time, "2026-11-22
/// 09.30.05.parti". The folder is made, and an empty file holds the place against other instances.
/// errors  kFile.
Result<std::string> NewDraftPath(const std::string& data_folder);

/// Whether a path lies among them, also of a file that is not there.
bool IsDraft(const std::string& data_folder, const std::string& path);

/// Drafts that were left there, by a kill or by ending without saving; newest first.
std::vector<std::string> DraftsIn(const std::string& data_folder);

/// Those of them that nobody has open, this process included.
std::vector<std::string> DraftsLeft(const std::string& data_folder);

/// Deletes a draft for good, with what SQLite keeps beside it.
/// errors  kFile  it is no draft of that folder; somebody has it open; it can't be deleted.
Result<void> ThrowAwayDraft(const std::string& data_folder, const std::string& path);

}  // namespace parti::app
