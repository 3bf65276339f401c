// Strokes to segments by speed and curvature (Jesus 2018, 6.3; errata 16, 17, 20).
// Tells curves from lines; it does not fit curves, which stay polylines until a later stage.
#pragma once

#include <vector>

#include "base/error.h"
#include "base/stroke.h"

namespace parti::sketch {

enum class SegmentKind { kLine, kCurve };

struct StrokeSegment {
  int from = 0;  ///< sample index
  int to = 0;    ///< sample index, > from
  SegmentKind kind = SegmentKind::kLine;
};

struct Segmentation {
  std::vector<int> corners;             ///< sample indices, first and last sample included
  std::vector<StrokeSegment> segments;  ///< between consecutive corners
};

/// Every number of the stage; units are multiples of the stroke's own measures, so that a stroke
/// drawn at another scale or on another device segments alike.
struct SegmentationParameters {};

/// stroke   n >= 2 samples with at least two distinct positions, finite.
/// errors   kTooShort  a tap: fewer than 2 distinct positions.
/// Properties: (1) unchanged by translating, rotating and scaling the stroke, and by a constant
/// factor on time; (2) reversing the stroke mirrors the corners, up to one sample.
Result<Segmentation> SegmentStroke(const Stroke& stroke,
                                   const SegmentationParameters& parameters = {});

}  // namespace parti::sketch
