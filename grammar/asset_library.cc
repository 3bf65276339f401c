#include "grammar/asset_library.h"

#include <fmt/format.h>

#include <utility>

#include "grammar/operation.h"

namespace parti::grammar {
namespace {

/// How CityEngine names assets that come with it and are no files.
constexpr std::string_view kBuiltIn = "builtin:";

/// errors  kUnknownName  another one than its cube, with texture coordinates or without.
Result<Asset> BuiltIn(const std::string& name) {
  if (name != "builtin:cube" && name != "builtin:cube:notex") {
    return Fail(ErrorCode::kUnknownName, fmt::format("there is no '{}'", name),
                "built-in assets are builtin:cube and builtin:cube:notex");
  }
  const Vec3 unit(1, 1, 1);
  return Asset{Vec3(0, 0, 0), unit, std::make_shared<const Mesh>(BoxMesh(unit)), nullptr};
}

/// "rules" of "rules/a", "" of "rules", ".." of "", "../.." of "..".
std::string FolderAbove(const std::string& folder) {
  if (folder.empty()) return "..";
  if (folder == ".." || folder.ends_with("/..")) return folder + "/..";
  return std::string(FolderOf(folder));
}

/// The first that can be had; the error of the first path where none can.
Result<std::shared_ptr<const Asset>> FirstOf(const std::vector<std::string>& paths,
                                             AssetLibrary* library) {
  auto first = library->Get(paths.front());
  for (size_t i = 1; i < paths.size() && !first && first.error().code == ErrorCode::kFile; ++i) {
    if (auto above = library->Get(paths[i])) return above;
  }
  return first;
}

Result<void> ResolveAll(std::string_view folder, AssetLibrary* library,
                        std::vector<Successor>* successors) {
  for (Successor& successor : *successors) {
    for (Action& action : successor.actions) {
      if (auto good = ResolveAssets(folder, library, &action); !good) return good;
    }
    if (auto good = ResolveAll(folder, library, &successor.repeat); !good) return good;
  }
  return {};
}

}  // namespace

Result<std::shared_ptr<const Asset>> AssetLibrary::Get(const std::string& path) {
  const std::lock_guard lock(mutex_);
  const auto found = read_.find(path);
  if (found != read_.end()) return found->second;
  const auto read = [&]() -> Result<Asset> {
    if (path.starts_with(kBuiltIn)) return BuiltIn(path);
    const auto bytes = files_(path);
    if (!bytes) return Fail(bytes);
    const std::string folder(FolderOf(path));
    return AssetFrom(*bytes, path,
                     [&](const std::string& name) { return files_(PathBeside(folder, name)); });
  };
  auto asset =
      read().map([](Asset&& one) { return std::make_shared<const Asset>(std::move(one)); });
  return read_.emplace(path, std::move(asset)).first->second;
}

std::shared_ptr<const Asset> AssetLibrary::Get(const PrimitiveBody& body) {
  const std::lock_guard lock(mutex_);
  std::shared_ptr<const Asset>& kept = bodies_[body];
  if (!kept) {
    kept = std::make_shared<const Asset>(Asset{Vec3(0), Vec3(1), MeshOf(body), nullptr});
  }
  return kept;
}

std::string_view FolderOf(std::string_view path) {
  const size_t slash = path.rfind('/');
  if (slash == 0) return path.substr(0, 1);
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

std::string PathBeside(std::string_view folder, std::string_view name) {
  const bool is_absolute = name.starts_with('/');
  if (folder.empty() || is_absolute) return std::string(name);
  return std::string(folder) + (folder == "/" ? "" : "/") + std::string(name);
}

std::vector<std::string> PathsFor(std::string_view folder, std::string_view name) {
  std::vector<std::string> paths = {PathBeside(folder, name)};
  if (name.starts_with('/')) {  // as it is; else from the root of CityEngine's workspace
    name.remove_prefix(1);
    paths.push_back(PathBeside(folder, name));
  }
  for (std::string at(folder); at != "/" && paths.size() < kMostFolders;) {
    at = FolderAbove(at);
    paths.push_back(PathBeside(at, name));
  }
  return paths;
}

bool WantsAsset(const Action& action) {
  return action.operation->file >= 0 || PrimitiveBodyOf(action).has_value();
}

Result<void> ResolveAssets(std::string_view folder, AssetLibrary* library, Action* action) {
  if (const auto body = PrimitiveBodyOf(*action)) action->asset = library->Get(*body);
  const int file = action->operation->file;
  if (file >= 0) {
    const auto& name = std::get<std::string>(action->arguments[static_cast<size_t>(file)]);
    auto asset =
        name.starts_with(kBuiltIn) ? library->Get(name) : FirstOf(PathsFor(folder, name), library);
    if (!asset) return Fail(asset);
    action->asset = std::move(*asset);
  }
  return ResolveAll(folder, library, &action->successors);
}

}  // namespace parti::grammar
