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

/// errors  kBadText  not JSON; the place is the byte where parsing stopped.
Result<Json> ParseJson(std::string_view text, std::string_view file = {});

/// Readers of one value; `what` names it in the message ("camera.eye").
/// errors  kBadText  missing or of another kind;  kBadNumber  a number that is not finite.
Result<double> NumberFrom(const Json& value, std::string_view what);
Result<Vec3> Vec3From(const Json& value, std::string_view what);

/// [[x,y,t] or [x,y,t,pressure], …], t in milliseconds, as a stroke in seconds.
/// errors  kBadText, kBadNumber as above; kTooShort when the list is empty. Times that run
/// backwards
///         are kept from doing so (a sample is never before its predecessor), positions are kept.
Result<Stroke> StrokeFrom(const Json& points, std::string_view what);

}  // namespace parti
