// A stroke to lines in the world: its readings by how well their lines find candidates.
// One line alone is lift.h's; what the lines mean together is for the hypotheses to say.
#pragma once

#include <vector>

#include "base/error.h"
#include "sketch/candidates.h"
#include "sketch/configuration.h"
#include "sketch/stroke_reading.h"

namespace parti::sketch {

/// The best reading of a stroke on one item.
struct LiftedStroke {
  std::vector<WorldLine> lines;  ///< n >= 1
  int lost_lines = 0;            ///< lines of the reading near which nothing can be made
  double lost_px = 0;            ///< their length
  double worth = 0;  ///< how much likelier it is drawn for its candidates than for nothing [nat]
  double price = 0;  ///< of the reading [nat]
};

/// A line near a candidate speaks for its reading, the more the nearer; a line far from all of them
/// is lost, as a hook or a slip of the pen is, and says nothing.
///
/// readings  n >= 1.
/// returns   n >= 1, of the greatest worth first.
/// errors    kNoFit  no line of any reading is near a candidate.
Result<std::vector<LiftedStroke>> LiftReadings(const std::vector<StrokeReading>& readings,
                                               const Candidates& candidates, const Camera& camera,
                                               const SketchParameters& parameters);

}  // namespace parti::sketch
