#include "base/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace parti {
namespace {

// Beyond any building or tablet; keeps squares finite.
constexpr double kLargest = 1e12;
// Milliseconds: clocks that count from 1970, in whatever unit they really do.
constexpr double kLatest = 1e18;
// Nobody's data is deeper; copying and printing recurse.
constexpr int kDeepest = 64;

std::optional<double> NumberIn(const Json& value, double largest = kLargest) {
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  if (!std::isfinite(number) || std::abs(number) > largest) return std::nullopt;
  return number;
}

tl::unexpected<Error> FailAt(ErrorCode code, std::string message, std::string hint,
                             SourcePlace place) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(hint), std::move(place)});
}

/// The byte where lists and objects are nested deeper than kDeepest.
std::optional<size_t> TooDeepAt(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\' && in_string) {
      ++i;
    } else if (text[i] == '"') {
      in_string = !in_string;
    } else if (!in_string && (text[i] == '[' || text[i] == '{')) {
      if (++depth > kDeepest) return i;
    } else if (!in_string && (text[i] == ']' || text[i] == '}')) {
      --depth;
    }
  }
  return std::nullopt;
}

/// The word that byte `offset` of `text` is in, such as NaN or -Infinity.
std::string_view WordAt(std::string_view text, size_t offset) {
  const auto in_word = [&](size_t i) { return std::isalpha(static_cast<unsigned char>(text[i])); };
  offset = std::min(offset, text.size());
  size_t start = offset, end = offset;
  while (start > 0 && in_word(start - 1)) --start;
  while (end < text.size() && in_word(end)) ++end;
  return text.substr(start, end - start);
}

Result<Json> NotJson(std::string_view text, std::string_view file, size_t offset) {
  constexpr std::array<std::string_view, 6> kNotFinite = {"NaN", "Infinity", "nan",
                                                          "inf", "Inf",      "infinity"};
  const std::string_view word = WordAt(text, offset);
  if (std::find(kNotFinite.begin(), kNotFinite.end(), word) != kNotFinite.end()) {
    const auto start = static_cast<size_t>(word.data() - text.data());
    return FailAt(ErrorCode::kBadNumber, fmt::format("{} is not a finite number", word),
                  "leave out what is not known", PlaceIn(text, file, start, word.size()));
  }
  return FailAt(ErrorCode::kBadText, "this is not JSON", "one JSON value is wanted here",
                PlaceIn(text, file, offset));
}

/// `what` of the library's complaint about a number quotes it: "… parsing '1e999'".
Result<Json> TooLarge(std::string_view text, std::string_view file, std::string_view what) {
  const size_t open = what.find('\''), close = what.rfind('\'');
  const std::string_view number =
      open < close ? what.substr(open + 1, close - open - 1) : std::string_view("a number");
  return FailAt(ErrorCode::kBadNumber, fmt::format("{} is out of range", number),
                "numbers here are doubles", PlaceIn(text, file, text.find(number), number.size()));
}

Result<double> NumberAt(const Json& list, size_t i, std::string_view what, double largest) {
  if (const auto number = NumberIn(list[i], largest)) return *number;
  return NumberFrom(list[i], fmt::format("{}[{}]", what, i));
}

Result<StrokeSample> SampleFrom(const Json& point, std::string_view what, size_t i) {
  const auto name = [&] { return fmt::format("{}[{}]", what, i); };
  if (!point.is_array() || point.size() < 3 || point.size() > 4) {
    return Fail(ErrorCode::kBadText, name() + " is not [x, y, t] or [x, y, t, pressure]");
  }
  std::array<double, 4> numbers = {};
  for (size_t k = 0; k < point.size(); ++k) {
    if (const auto fine = NumberIn(point[k], k == 2 ? kLatest : kLargest)) {
      numbers[k] = *fine;
    } else {
      return Fail(NumberAt(point, k, name(), kLargest));
    }
  }
  StrokeSample sample{Vec2(numbers[0], numbers[1]), numbers[2] / 1000.0};
  if (point.size() == 4) sample.pressure = std::clamp(numbers[3], 0.0, 1.0);
  return sample;
}

}  // namespace

Result<Json> ParseJson(std::string_view text, std::string_view file) {
  if (const auto deep = TooDeepAt(text)) {
    return FailAt(ErrorCode::kBadText, fmt::format("nested deeper than {} levels", kDeepest), "",
                  PlaceIn(text, file, *deep));
  }
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& e) {
    return NotJson(text, file, e.byte > 0 ? e.byte - 1 : 0);
  } catch (const Json::exception& e) {
    return TooLarge(text, file, e.what());
  }
}

Result<double> NumberFrom(const Json& value, std::string_view what) {
  if (const auto number = NumberIn(value)) return *number;
  if (!value.is_number()) return Fail(ErrorCode::kBadText, fmt::format("{} is not a number", what));
  return Fail(ErrorCode::kBadNumber,
              fmt::format("{} is not a finite number of at most {:g}", what, kLargest));
}

Result<Vec3> Vec3From(const Json& value, std::string_view what) {
  if (!value.is_array() || value.size() != 3) {
    return Fail(ErrorCode::kBadText, fmt::format("{} is not a list of 3 numbers", what));
  }
  Vec3 v;
  for (int i = 0; i < 3; ++i) {
    const auto number = NumberAt(value, static_cast<size_t>(i), what, kLargest);
    if (!number) return Fail(number);
    v[i] = *number;
  }
  return v;
}

Result<Stroke> StrokeFrom(const Json& points, std::string_view what) {
  if (!points.is_array()) {
    return Fail(ErrorCode::kBadText, fmt::format("{} is not a list of points", what));
  }
  if (points.empty()) return Fail(ErrorCode::kTooShort, fmt::format("{} has no points", what));
  Stroke stroke;
  stroke.reserve(points.size());
  for (const Json& point : points) {
    auto sample = SampleFrom(point, what, stroke.size());
    if (!sample) return Fail(sample);
    if (!stroke.empty()) sample->t_s = std::max(sample->t_s, stroke.back().t_s);
    stroke.push_back(*sample);
  }
  return stroke;
}

}  // namespace parti
