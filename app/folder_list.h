// What lies in a folder, for the panels' document sheet.
// Opening files is others' business.
#pragma once

#include <string>
#include <vector>

#include "app/panels/panel_view.h"
#include "app/user_folders.h"

namespace parti::app {

/// What is asked of the folders.
struct FolderRequest {
  std::string folder;  ///< absolute or relative to the program's; "" is the user's home
  std::vector<std::string> throw_away = {};  ///< drafts; such as are gone already don't matter
};

/// Folders first, then documents, each by name without regard to capitals; nothing hidden, at most
/// kMostFiles, and the names of all else apart. A folder that can't be read has nothing in it.
/// Drafts that are thrown away are deleted first; those that are left are listed apart, not among
/// the recent files.
PanelFiles ListOf(const FolderRequest& request, const UserFolders& folders);

inline constexpr size_t kMostFiles = 2000;

}  // namespace parti::app
