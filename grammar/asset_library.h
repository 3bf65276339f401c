// Assets by name, each read once: what i() and texture() of actions refer to becomes a value that
// they share. The caller owns the library and says how files are read; there is no global one.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "grammar/action.h"
#include "grammar/asset.h"

namespace parti::grammar {

/// Reads through `files` and keeps what it read, failures included. Any number of threads.
class AssetLibrary {
 public:
  /// files gets paths as Get does, and names of what a file refers to, put in the file's folder.
  explicit AssetLibrary(FileReader files) : files_(std::move(files)) {}

  /// errors  those of AssetFrom and of the reader, the same every time.
  Result<std::shared_ptr<const Asset>> Get(const std::string& path);

 private:
  FileReader files_;
  std::mutex mutex_;
  std::map<std::string, Result<std::shared_ptr<const Asset>>> read_;
};

/// "rules" of "rules/house.cga"; "" of "house.cga".
std::string_view FolderOf(std::string_view path);
/// `name` as written in a file in `folder`: beside it, unless it is absolute. Slashes only.
std::string PathBeside(std::string_view folder, std::string_view name);

/// Sets Action::asset of every action that names a file (ParameterKind::kFile), those in braces
/// included; paths are relative to `folder`, that of the rules ("" where they have none).
/// errors  those of Get, the first in reading order.
Result<void> ResolveAssets(std::string_view folder, AssetLibrary* library, Action* action);

}  // namespace parti::grammar
