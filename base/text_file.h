// Whole files in and out, with errors that name the file and the remedy.
// Documents (SQLite) and pictures (libpng) have writers of their own.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace parti {

/// The bytes of a file; "-" reads standard input.
/// errors  kFile  it does not exist, is a folder, or can't be read; the message names it.
Result<std::string> ReadFile(const std::string& path);

/// Writes through a temporary file in the same folder, so that a reader sees the old bytes or the
/// new, never a part.
/// errors  kFile  the folder does not exist or can't be written, or the disk is full.
Result<void> WriteFile(const std::string& path, std::string_view bytes);

}  // namespace parti
