// One pen line as it was drawn: samples with position, time and pressure.
// What a line means is sketch's; its JSON form is read by base/json.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/math.h"

namespace parti {

/// One report of the pen while it is down.
struct StrokeSample {
  Vec2 position;                        ///< view px, y down (any unit of length in `parti segment`)
  double t_s = 0;                       ///< s, never decreasing within a stroke
  std::optional<double> pressure = {};  ///< [0, 1]; absent where the device has none

  bool operator==(const StrokeSample&) const = default;
};

/// Samples in the order they were drawn. Real recordings hold coincident positions, repeated times
/// and batched events; every reader of a stroke copes with them.
using Stroke = std::vector<StrokeSample>;

/// Sum of the distances between consecutive samples.
double PathLength(const Stroke& stroke);

/// Diagonal of the bounding box; 0 for an empty stroke.
double Diagonal(const Stroke& stroke);

/// "0,0 10,0 10,8" as a stroke sampled every 10 ms; for tests and documentation.
Stroke StrokeFrom(std::string_view text);

}  // namespace parti
