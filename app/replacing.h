// Files that are there already are not written over unless somebody has said that they may go.
// Who asks a person is the panels' business; the command line replaces, as tools do.
#pragma once

#include <string>

#include "base/error.h"

namespace parti::app {

/// errors  kFile  something of that name is there, a folder included.
Result<void> CheckNothingIsAt(const std::string& path);

}  // namespace parti::app
