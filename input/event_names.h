// The words that a drawing has for the enumerations of base/event.h, shared by writer and reader.
// The order of each list is that of the enumeration.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/event.h"

namespace parti::input {

inline constexpr std::array<std::string_view, 2> kDeviceKinds{"added", "removed"};
inline constexpr std::array<std::string_view, 6> kPenKinds{"in", "out",  "down",
                                                           "up", "move", "button"};
inline constexpr std::array<std::string_view, 6> kPenTools{"pen",    "eraser",   "brush",
                                                           "pencil", "airbrush", "mouse"};
inline constexpr std::array<std::string_view, 4> kTouchKinds{"down", "move", "up", "cancel"};
inline constexpr std::array<std::string_view, 2> kKeyKinds{"release", "press"};
inline constexpr std::array<std::string_view, 1> kScrollKinds{"wheel"};

/// The features of a device that are just there or not, by their word.
struct Feature {
  std::string_view word;
  bool DeviceFacts::*flag;
};
inline constexpr std::array<Feature, 9> kFeatures{{{"pen", &DeviceFacts::has_pen},
                                                   {"touch", &DeviceFacts::has_touch},
                                                   {"pressure", &DeviceFacts::has_pressure},
                                                   {"tilt", &DeviceFacts::has_tilt},
                                                   {"distance", &DeviceFacts::has_distance},
                                                   {"eraser", &DeviceFacts::has_eraser},
                                                   {"pointer", &DeviceFacts::has_pointer},
                                                   {"keys", &DeviceFacts::has_keys},
                                                   {"display", &DeviceFacts::has_display}}};

/// The word of a value.
template <size_t n, typename Enum>
constexpr std::string_view NameOf(const std::array<std::string_view, n>& names, Enum value) {
  return names[static_cast<size_t>(value)];
}

/// The value's number; nothing for a word that is not among the names.
template <size_t n>
constexpr std::optional<size_t> IndexOf(const std::array<std::string_view, n>& names,
                                        std::string_view word) {
  for (size_t i = 0; i < n; ++i) {
    if (names[i] == word) return i;
  }
  return std::nullopt;
}

}  // namespace parti::input
