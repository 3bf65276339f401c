// Colors as people write them: "#c8beb4", "#c8beb480", "firebrick".
// What wears them is item.h's.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace parti::grammar {

/// A color as items keep it: 0 means that none was given, so black becomes the darkest blue.
constexpr uint32_t ColorOrNone(uint32_t rgb) { return rgb == 0 ? 1 : rgb; }

/// What a text says: 0xRRGGBB (never 0) and, of eight digits, how opaque it is.
struct WrittenColor {
  uint32_t rgb = 1;
  std::optional<double> opacity;
};

/// "#rrggbb" or "#rrggbboo" in hexadecimal digits, or one of CSS's names in any case. Nothing for
/// other texts.
std::optional<WrittenColor> ColorFrom(std::string_view text);

/// The name that was meant, for hints: "firebrik" gives "firebrick".
std::optional<std::string> ColorMeant(std::string_view text);

}  // namespace parti::grammar
