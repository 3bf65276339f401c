// How much each point of a path looks like a corner: the pen turns there, and slows down (Jesus
// 2018, 6.3 to 6.8; errata 16, 17, 17a). Does not choose corners.
#pragma once

#include <vector>

#include "sketch/segmentation_parameters.h"
#include "sketch/stroke_path.h"

namespace parti::sketch {

/// Angle between the chord that reaches point `at` and the one that leaves it, each over `steps`
/// steps or what is left of the path [rad, 0 to pi]; 0 at the ends and where a chord has no length.
/// Menger's curvature (6.4) over the same window is 2 sin(turn) / chord: the angle tells a cusp
/// from a straight run, the sine does not.
double TurnAt(const StrokePath& path, int at, int steps);

/// ln(slowness / median slowness) per point, where slowness is the time that the pen takes per unit
/// of length across a window: the reciprocal of (6.3), for which a resting pen is no special case.
/// Clamped as the parameters say; all 0 when the stroke took no time.
std::vector<double> Slowness(const StrokePath& path, const SegmentationParameters& parameters);

/// What speaks for a corner, for each point of a path.
struct CornerEvidence {
  std::vector<double> near_turn;  ///< rad, in the near window
  std::vector<double> price;      ///< nats; what taking the point as a corner costs, < 0 if likely
};

/// Stands for the thesis's ranking (6.6 to 6.8), a product there and a sum of logarithms here.
CornerEvidence EvidenceOf(const StrokePath& path, const SegmentationParameters& parameters);

/// Points to try as corners, in order along the path: those cheaper than everything within
/// candidate_span, at most most_candidates of them, and no two at one sample; without the ends.
std::vector<int> CornerCandidates(const StrokePath& path, const CornerEvidence& evidence,
                                  const SegmentationParameters& parameters);

}  // namespace parti::sketch
