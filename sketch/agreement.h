// One value from several lines, each of which may be read in several ways.
// Used by the heuristics to start the descent near the right minimum (Jesus 2018, 6.5; errata 19).
#pragma once

#include <vector>

namespace parti::sketch {

/// What one line may say about the value.
struct ValueReading {
  double value = 0;
  double fitness = 0;  ///< of the candidate line that it comes from, (0, 1]
};

/// Means over the lines, one reading of each, that agree best; best first, at most `most`, no two
/// alike. Where a reading is off its mean by more than `scale`, its own value counts too. Nothing
/// where a line has no reading: then the operation is not feasible. scale  the difference that
/// counts as much as a fitness of 1/e; > 0. Cost: quadratic in the number of readings.
std::vector<double> AgreedValues(const std::vector<std::vector<ValueReading>>& lines, double scale,
                                 int most);

}  // namespace parti::sketch
