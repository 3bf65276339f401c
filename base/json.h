// JSON as batches use it: one value a line, every number finite, every failure with its place.
// Reads what interfaces.md (docs/) fixes; what a task or an answer means is app's business.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/math.h"
#include "base/stroke.h"

namespace parti {

using Json = nlohmann::json;

/// errors  kBadText  not JSON, or nested deeper than 64 levels; the place is where parsing stopped;
///         kBadNumber  NaN, an infinity, or more than a double holds.
Result<Json> ParseJson(std::string_view text, std::string_view file = {});

/// Readers of one value; `what` names it in the message ("camera.eye").
/// errors  kBadText  of another kind;  kBadNumber  not finite, or beyond 1e12.
Result<double> NumberFrom(const Json& value, std::string_view what);
Result<Vec3> Vec3From(const Json& value, std::string_view what);

/// [[x,y,t] or [x,y,t,pressure], …], t in milliseconds, as a stroke in seconds.
/// A time before its predecessor's becomes its predecessor's; pressure is clamped to [0, 1].
/// errors  kBadText, kBadNumber as above, times up to 1e18;  kTooShort  an empty list.
Result<Stroke> StrokeFrom(const Json& points, std::string_view what);

}  // namespace parti
