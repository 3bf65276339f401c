// Whole files in and out, with errors that name the file and the remedy.
// Documents (SQLite) and pictures (libpng) have writers of their own.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace parti {

/// The file that a link means, also one that is not there yet; the path itself where it is no link.
std::string BehindLinks(const std::string& path);

/// The bytes of a file; "-" reads standard input.
/// errors  kFile  it does not exist, is a folder, can't be read, or is larger than 256 MiB; the
///         message names it.
Result<std::string> ReadFile(const std::string& path);

/// Writes through a temporary file in the same folder, so that a reader sees the old bytes or the
/// new, never a part. An old file's permissions stay, a link stays a link, and a device or a pipe
/// is written into.
/// errors  kFile  the folder does not exist, it or the file can't be written, or the disk is full.
Result<void> WriteFile(const std::string& path, std::string_view bytes);

}  // namespace parti
