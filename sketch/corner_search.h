// The search for the best combination of candidate corners (Jesus 2018, 6.3, after 6.9).
// The thesis tries every combination and takes the fewest corners under an error threshold; here
// every corner and every segment has a price, and the cheapest sum is found without trying all.
#pragma once

#include <vector>

#include "sketch/line_fit.h"
#include "sketch/segmentation_parameters.h"
#include "sketch/stroke_path.h"

namespace parti::sketch {

/// A corner chosen, and whether the segment that ends there is a curve.
struct ChosenCorner {
  int at = 0;  ///< point of the path
  bool after_curve = false;
};

/// candidates  points of the path in order, without its ends.
/// price       nats per point of the path.
/// returns     corners in order, first and last point of the path included; at least 2.
/// cost        the square of the number of candidates, exactly once per pair (dynamic programming).
std::vector<ChosenCorner> ChooseCorners(const StrokePath& path, const std::vector<int>& candidates,
                                        const std::vector<double>& price,
                                        const SegmentationParameters& parameters);

}  // namespace parti::sketch
