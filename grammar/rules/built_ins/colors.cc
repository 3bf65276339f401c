// colorRGBToHex, colorHexToR …: colors as texts "#rrggbb" and their parts as numbers from 0 to 1.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

int Byte(double share) {
  return static_cast<int>(std::lround(255 * (share > 0 ? std::min(share, 1.0) : 0.0)));
}

std::string Hex(double red, double green, double blue) {
  return fmt::format("#{:02x}{:02x}{:02x}", Byte(red), Byte(green), Byte(blue));
}

/// 0 where the text is not "#rrggbb".
template <int kFrom>
Value Part(Values values, const Situation&) {
  const std::string text = TextOf(values[0]);
  if (text.size() != 7) return 0.0;
  int part = 0;
  std::from_chars(text.data() + kFrom, text.data() + kFrom + 2, part, 16);
  return part / 255.0;
}

/// Hue in degrees, saturation and value from 0 to 1.
Value FromHsv(Values values, const Situation&) {
  const double hue = std::fmod(std::fmod(NumberOf(values[0]), 360) + 360, 360) / 60;
  const double saturation = NumberOf(values[1]), value = NumberOf(values[2]);
  const auto channel = [&](double shift) {
    const double k = std::fmod(shift + hue, 6);
    return value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
  };
  return Hex(channel(5), channel(3), channel(1));
}

constexpr auto kOne = First(kTexts, 1);

constexpr BuiltIn kRows[] = {
    {"colorRGBToHex", kNumbers, kText, "\"#rrggbb\" of red, green and blue from 0 to 1",
     [](Values values, const Situation&) -> Value {
       return Hex(NumberOf(values[0]), NumberOf(values[1]), NumberOf(values[2]));
     }},
    {"colorHSVToHex", kNumbers, kText,
     "\"#rrggbb\" of hue in degrees, saturation and value from 0 to 1", FromHsv},
    {"colorHexToR", kOne, kNumber, "the red of \"#rrggbb\", from 0 to 1", Part<1>},
    {"colorHexToG", kOne, kNumber, "the green", Part<3>},
    {"colorHexToB", kOne, kNumber, "the blue", Part<5>},
};

}  // namespace

std::span<const BuiltIn> Colors() { return kRows; }

}  // namespace parti::grammar::built_ins
