// Assets by name, each read once: what i() and texture() of actions refer to becomes a value that
// they share, and so do the bodies that come without a file. The caller owns the library and says
// how files are read; there is no global one.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "grammar/action.h"
#include "grammar/asset.h"
#include "grammar/primitive_body.h"

namespace parti::grammar {

/// Reads through `files` and keeps what it read, failures included. Any number of threads.
class AssetLibrary {
 public:
  /// files gets paths as Get does, and names of what a file refers to, put in the file's folder.
  explicit AssetLibrary(FileReader files) : files_(std::move(files)) {}

  /// CityEngine's "builtin:cube" and "builtin:cube:notex" are unit cubes, and no files.
  /// errors  those of AssetFrom and of the reader, the same every time;  kUnknownName  another
  ///         "builtin:".
  Result<std::shared_ptr<const Asset>> Get(const std::string& path);

  /// A body without a file, made when it is first asked for.
  std::shared_ptr<const Asset> Get(const PrimitiveBody& body);

 private:
  FileReader files_;
  std::mutex mutex_;
  std::map<std::string, Result<std::shared_ptr<const Asset>>> read_;
  std::map<PrimitiveBody, std::shared_ptr<const Asset>> bodies_;
};

/// "rules" of "rules/house.cga"; "" of "house.cga"; "/" of "/house.cga".
std::string_view FolderOf(std::string_view path);
/// `name` as written in a file in `folder`: beside it, unless it is absolute. Slashes only.
std::string PathBeside(std::string_view folder, std::string_view name);
/// Where rules in `folder` mean `name` to be: beside them, else in the folders above, the nearest
/// first; kMostFolders at most, and never none. An absolute name is itself first, then what it is
/// from those folders: CityEngine's "/ESRI.lib/rules/a.cga". A pure function: no file is looked at.
std::vector<std::string> PathsFor(std::string_view folder, std::string_view name);
inline constexpr size_t kMostFolders = 16;

/// Whether ResolveAssets has something to do for the action itself.
bool WantsAsset(const Action& action);

/// Sets Action::asset of every action that names a file (ParameterKind::kFile) or inserts a body
/// without one, those in braces included; `folder` is that of the rules ("" where they have none),
/// names are looked for as PathsFor says, but for built-in ones. errors  those of Get for the path
/// beside the rules, the first in reading order.
Result<void> ResolveAssets(std::string_view folder, AssetLibrary* library, Action* action);

}  // namespace parti::grammar
