// What lies in a folder, for the panels' document sheet.
// Opening files is others' business.
#pragma once

#include "app/panels/panel_view.h"

namespace parti::app {

/// Folders first, then documents, rules and drawings, each by name without regard to capitals;
/// nothing hidden. A folder that can't be read has nothing in it. At most kMostFiles.
/// path  absolute or relative to the program's folder; "" is the user's home.
/// state_folder  where the recent files are kept (recent_files.h).
PanelFiles ListOf(const std::string& path, const std::string& state_folder);

inline constexpr size_t kMostFiles = 2000;

}  // namespace parti::app
