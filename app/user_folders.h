// Where what belongs to a person is kept: drafts and the list of recent files, by the XDG base
// directory specification 0.8. What is in them is others' business.
#pragma once

#include <string>

#include "base/error.h"

namespace parti::app {

/// Absolute paths; they need not exist.
struct UserFolders {
  std::string data;   ///< drafts are kept in its folder "drafts"
  std::string state;  ///< the list of recent files
};

/// $XDG_DATA_HOME/parti and $XDG_STATE_HOME/parti; where a variable is unset or not absolute,
/// below ~/.local; without a HOME, below parti-UID in the
/// folder for temporary files.
UserFolders UserFoldersFromEnvironment();

/// The absolute path of a file, without "." and ".."; it need not exist, and links stay. The path
/// as it is where there is no working folder any more.
std::string WholePath(const std::string& path);

/// Makes a folder and those above it, readable by this user alone (mode 0700), where missing.
/// errors  kFile  naming it.
Result<void> MakeFolder(const std::string& path);

}  // namespace parti::app
