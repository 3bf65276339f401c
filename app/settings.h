// What a person has set and expects to find again: theme, scale, hand, pen buttons.
// A small JSON file of one's own; nothing of a document is in it.
#pragma once

#include <string>

#include "base/error.h"

namespace parti::app {

/// The two looks of panels.
enum class Theme { kLight, kDark };

/// Values, compared and copied freely.
struct Settings {
  Theme theme = Theme::kLight;
  double scale = 0;           ///< of panels, in [0.5, 4]; 0: as the display says
  bool left_handed = false;   ///< panels keep to the other side of the pen; tablets may be turned
  bool finger_draws = false;  ///< one finger draws, for screens without a pen
  /// What pen and mouse buttons do, as input::PenBindings reads it; "": as shipped.
  std::string bindings;

  bool operator==(const Settings&) const = default;
};

/// $XDG_CONFIG_HOME/parti/settings.json; ~/.config where that is not set; "" without a home.
std::string SettingsPath();

/// The settings of a file. One that is not there gives those of a new user; keys that are not known
/// are ignored, and values that can't be are left at their default.
/// errors  kFile  it can't be read;  kBadText  it is not JSON (the hint: remove it).
Result<Settings> ReadSettings(const std::string& path);

/// Makes the folder where it is missing; the file appears whole.
/// errors  kFile.
Result<void> WriteSettings(const Settings& settings, const std::string& path);

}  // namespace parti::app
