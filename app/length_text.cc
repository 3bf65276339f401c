#include "app/length_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace parti::app {
namespace {

struct Unit {
  std::string_view name;
  double metres;
};

constexpr double kFoot_m = 0.3048, kInch_m = 0.0254;
constexpr std::array kUnits = {Unit{"mm", 0.001},   Unit{"cm", 0.01},   Unit{"m", 1},
                               Unit{"ft", kFoot_m}, Unit{"'", kFoot_m}, Unit{"in", kInch_m},
                               Unit{"\"", kInch_m}};

void SkipBlanks(std::string_view* text) {
  text->remove_prefix(std::min(text->find_first_not_of(" \t"), text->size()));
}

/// Takes a number from the front of the text; with a comma for the point where it has one.
std::optional<double> TakeNumber(std::string_view* text) {
  const size_t length = std::min(text->find_first_not_of("+-0123456789.,eE"), text->size());
  std::string digits(text->substr(0, length));
  if (const size_t comma = digits.find(','); comma != std::string::npos) digits[comma] = '.';
  double value = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (code != std::errc() || end == digits.data() || !std::isfinite(value)) return std::nullopt;
  text->remove_prefix(static_cast<size_t>(end - digits.data()));
  return value;
}

const Unit* TakeUnit(std::string_view* text) {
  for (const Unit& unit : kUnits) {
    if (!text->starts_with(unit.name)) continue;
    text->remove_prefix(unit.name.size());
    return &unit;
  }
  return nullptr;
}

bool IsFeet(const Unit& unit) { return unit.metres == kFoot_m; }
bool IsInches(const Unit& unit) { return unit.metres == kInch_m; }

tl::unexpected<Error> Refused(std::string_view text) {
  return Fail(ErrorCode::kBadNumber, fmt::format("'{}' is not a number", text),
              "for example: 3.5, 350 cm, 12'6\"");
}

}  // namespace

Result<double> ParseLength(std::string_view text) {
  std::string_view rest = text;
  SkipBlanks(&rest);
  const auto number = TakeNumber(&rest);
  if (!number) return Refused(text);
  SkipBlanks(&rest);
  if (rest.empty()) return *number;
  const Unit* unit = TakeUnit(&rest);
  if (unit == nullptr) return Refused(text);
  double metres = *number * unit->metres;
  SkipBlanks(&rest);
  if (IsFeet(*unit) && !rest.empty()) {
    const auto inches = TakeNumber(&rest);
    SkipBlanks(&rest);
    const bool said = !rest.empty();  // 12'6 are inches too
    const Unit* second = TakeUnit(&rest);
    if (!inches || *inches < 0) return Refused(text);
    if (said && (second == nullptr || !IsInches(*second))) return Refused(text);
    metres += std::copysign(*inches * kInch_m, metres);
    SkipBlanks(&rest);
  }
  if (!rest.empty() || !std::isfinite(metres)) return Refused(text);
  return metres;
}

}  // namespace parti::app
