#include "app/settings.h"

#include <cstdlib>
#include <filesystem>

#include "base/json.h"
#include "base/text_file.h"

namespace parti::app {
namespace {

/// A value of the right kind, or what was there.
template <typename T>
void Take(const Json& json, const char* key, T* value) {
  const auto found = json.find(key);
  if (found == json.end()) return;
  if constexpr (std::is_same_v<T, bool>) {
    if (found->is_boolean()) *value = found->get<bool>();
  } else if constexpr (std::is_same_v<T, double>) {
    if (found->is_number()) *value = found->get<double>();
  } else {
    if (found->is_string()) *value = found->get<std::string>();
  }
}

}  // namespace

std::string SettingsPath() {
  const char* folder = std::getenv("XDG_CONFIG_HOME");
  if (folder && *folder) return std::string(folder) + "/parti/settings.json";
  const char* home = std::getenv("HOME");
  return home && *home ? std::string(home) + "/.config/parti/settings.json" : std::string();
}

Result<Settings> ReadSettings(const std::string& path) {
  std::error_code unreachable;  // another user's, say: no reason not to start
  if (path.empty() || !std::filesystem::exists(path, unreachable)) return Settings{};
  const auto text = ReadFile(path);
  if (!text) return Fail(text);
  const auto json = ParseJson(*text, path);
  if (!json) {
    Error error = json.error();
    error.hint = "remove the file to go on with the settings of a new user";
    return tl::unexpected<Error>(std::move(error));
  }
  Settings settings;
  if (!json->is_object()) return settings;
  std::string theme;
  Take(*json, "theme", &theme);
  settings.theme = theme == "dark" ? Theme::kDark : Theme::kLight;
  Take(*json, "scale", &settings.scale);
  if (settings.scale < 0.5 || settings.scale > 4) settings.scale = 0;
  Take(*json, "left_handed", &settings.left_handed);
  Take(*json, "finger_draws", &settings.finger_draws);
  Take(*json, "bindings", &settings.bindings);
  return settings;
}

Result<void> WriteSettings(const Settings& settings, const std::string& path) {
  if (path.empty()) {
    return Fail(ErrorCode::kFile, "there is no place for settings",
                "set HOME or XDG_CONFIG_HOME to a folder of your own");
  }
  std::error_code failed;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), failed);
  if (failed) {
    return Fail(ErrorCode::kFile, "can't make the folder of " + path + ": " + failed.message());
  }
  const Json json = {{"theme", settings.theme == Theme::kDark ? "dark" : "light"},
                     {"scale", settings.scale},
                     {"left_handed", settings.left_handed},
                     {"finger_draws", settings.finger_draws},
                     {"bindings", settings.bindings}};
  return WriteFile(path, json.dump(2) + "\n");
}

}  // namespace parti::app
