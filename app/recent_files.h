// The documents that were open lately, for the list to choose from. Several instances may change
// the list at once. Drafts are document_drafts.h's.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace parti::app {

inline constexpr size_t kMostRecentFiles = 20;

/// Absolute paths, newest first; also of files that are not there at the moment. Empty where there
/// is no list or it can't be read.
std::vector<std::string> RecentFiles(const std::string& state_folder);

/// Puts a path first in the list. A list that can't be written stays as it is: it is a convenience.
void NoteRecentFile(const std::string& state_folder, const std::string& path);

}  // namespace parti::app
