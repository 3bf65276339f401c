// Strokes to segments by speed and curvature (Jesus 2018, 6.3; errata 16, 17, 20). Sequences the
// stages: filter (stroke_path), evidence (speed_curvature), combination search (corner_search).
// Tells curves from lines; it does not fit curves, which stay polylines until a later stage.
#pragma once

#include <vector>

#include "base/error.h"
#include "base/stroke.h"
#include "sketch/segmentation_parameters.h"

namespace parti::sketch {

/// What a part of a stroke was meant to be.
enum class SegmentKind { kLine, kCurve };

/// A part of a stroke between two corners.
struct StrokeSegment {
  int from = 0;  ///< sample index
  int to = 0;    ///< sample index, > from
  SegmentKind kind = SegmentKind::kLine;

  bool operator==(const StrokeSegment&) const = default;
};

/// A stroke cut at its corners.
struct Segmentation {
  std::vector<int> corners;             ///< sample indices, first and last sample included
  std::vector<StrokeSegment> segments;  ///< between consecutive corners, at least one

  bool operator==(const Segmentation&) const = default;
};

/// stroke   n >= 2 samples with at least two distinct positions, finite. Times may repeat, come in
///          batches or be all the same (then curvature alone decides).
/// errors   kTooShort  a tap: fewer than 2 distinct positions;  kBadNumber  not finite.
/// cost     linear in the samples, plus at most most_candidates squared.
/// Hooks that pen-down and pen-up leave at the ends stay part of the first and last segment.
/// Properties: (1) unchanged by translating, rotating and scaling the stroke, and by a constant
/// factor on time; (2) reversing the stroke mirrors the corners; either up to one step of the path
/// (1/80 of the diagonal) where two points are equally good and rounding chooses.
Result<Segmentation> SegmentStroke(const Stroke& stroke,
                                   const SegmentationParameters& parameters = {});

}  // namespace parti::sketch
