#include "base/json.h"

#include <fmt/format.h>

#include <algorithm>

namespace parti {
namespace {

constexpr double kLargest = 1e12;  // beyond any building, tablet or clock; keeps squares finite

std::optional<double> NumberIn(const Json& value) {
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  if (!std::isfinite(number) || std::abs(number) > kLargest) return std::nullopt;
  return number;
}

Result<double> ItemFrom(const Json& list, size_t i, std::string_view what) {
  return NumberFrom(list[i], fmt::format("{}[{}]", what, i));
}

}  // namespace

Result<Json> ParseJson(std::string_view text, std::string_view file) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& e) {
    Error error{ErrorCode::kBadText, "this is not JSON", "one JSON value is wanted here"};
    error.place = PlaceIn(text, file, e.byte > 0 ? e.byte - 1 : 0);
    return tl::unexpected<Error>(error);
  } catch (const Json::exception& e) {  // a number too large for a double
    return Fail(ErrorCode::kBadNumber, "a number is out of range", e.what());
  }
}

Result<double> NumberFrom(const Json& value, std::string_view what) {
  if (const auto number = NumberIn(value)) return *number;
  if (!value.is_number()) return Fail(ErrorCode::kBadText, fmt::format("{} is not a number", what));
  return Fail(ErrorCode::kBadNumber, fmt::format("{} is not a finite number", what));
}

Result<Vec3> Vec3From(const Json& value, std::string_view what) {
  if (!value.is_array() || value.size() != 3) {
    return Fail(ErrorCode::kBadText, fmt::format("{} is not a list of 3 numbers", what));
  }
  Vec3 v;
  for (int i = 0; i < 3; ++i) {
    const auto number = ItemFrom(value, static_cast<size_t>(i), what);
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
    if (!point.is_array() || point.size() < 3 || point.size() > 4) {
      return Fail(ErrorCode::kBadText, fmt::format("{}[{}] is not [x, y, t] or [x, y, t, pressure]",
                                                   what, stroke.size()));
    }
    double numbers[4] = {};
    for (size_t i = 0; i < point.size(); ++i) {
      if (const auto fine = NumberIn(point[i])) {
        numbers[i] = *fine;
        continue;
      }
      const auto failed = ItemFrom(point, i, fmt::format("{}[{}]", what, stroke.size()));
      return Fail(failed);
    }
    StrokeSample sample{Vec2(numbers[0], numbers[1]), numbers[2] / 1000.0};
    if (point.size() == 4) sample.pressure = std::clamp(numbers[3], 0.0, 1.0);
    if (!stroke.empty()) sample.t_s = std::max(sample.t_s, stroke.back().t_s);
    stroke.push_back(sample);
  }
  return stroke;
}

}  // namespace parti
