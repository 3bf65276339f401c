// The filter stage: a recorded stroke becomes evenly spaced points with plausible times, whatever
// the device sampled (Jesus 2018, 6.1 and 6.2; errata 17). Does not smooth: pixels and tremor stay.
#pragma once

#include <vector>

#include "base/error.h"
#include "base/stroke.h"
#include "sketch/segmentation_parameters.h"

namespace parti::sketch {

/// A stroke as points at equal distances along it. All vectors have the same size:
/// steps_per_diagonal + 1 or more (a path is no shorter than its diagonal), most_steps + 1 at most.
struct StrokePath {
  std::vector<Vec2> position;  ///< first and last are the stroke's
  std::vector<double> t_s;     ///< never decreasing
  std::vector<int> sample;     ///< nearest sample along the stroke, never decreasing
  double step = 0;             ///< between neighbours, along the stroke; > 0
  double diagonal = 0;         ///< of the stroke's bounding box; > 0

  int size() const { return static_cast<int>(position.size()); }
  /// A length in diagonals as a number of steps, at least 1.
  int Steps(double diagonals) const;
};

/// Times as the pen must have passed the samples: samples that share a time (devices send them in
/// batches, clocks are coarse) are spread evenly, each batch around its time. Same size as stroke;
/// never decreasing; reversal of the stroke reverses it.
std::vector<double> SpreadTimes(const Stroke& stroke);

/// stroke   any number of finite samples.
/// errors   kTooShort  fewer than 2 distinct positions;  kBadNumber  a sample that is not finite.
/// cost     linear in the samples; at most most_steps + 1 points come out.
Result<StrokePath> FilterStroke(const Stroke& stroke, const SegmentationParameters& parameters);

}  // namespace parti::sketch
