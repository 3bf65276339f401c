// The straight lines of a stroke on the screen, in every way that it can be read. Segmentation says
// what is likeliest for the stroke alone; a hook at its end may as well be part of a careless line,
// and the rounded corners of an outline may be corners. Which reading is meant is known only when
// the lines have met the shape (lift_stroke.h).
#pragma once

#include <vector>

#include "base/error.h"
#include "base/stroke.h"
#include "sketch/parameters.h"

namespace parti::sketch {

/// One way to read a stroke.
struct StrokeReading {
  std::vector<Segment2> lines;  ///< n >= 1, in drawing order, px
  double price = 0;             ///< how much less likely than the segmentation's [nat]
};

/// returns  n >= 1 readings, no two alike: the segmentation's, with straight neighbours joined and
///          hooks dropped; the whole stroke as one line, where it bows little enough; and polygons
///          by Douglas and Peucker's method. The first and last line of a closed outline meet where
///          their straight parts cross, not where the pen happened to go down and up.
/// errors   kTooShort  a tap;  kNoFit  nothing but curves;  kBadNumber  a sample is not finite.
/// Properties: (1) reversing the stroke reverses the lines of each reading.
Result<std::vector<StrokeReading>> ReadStroke(const Stroke& stroke,
                                              const SegmentationParameters& segmentation = {},
                                              const LineParameters& parameters = {});

/// The readings of each stroke. Strokes without a line (taps, scribbles) are passed over as long as
/// one has a line.
/// errors   those of the last stroke when none has a line;  kTooShort  no strokes;  kBadNumber any.
Result<std::vector<std::vector<StrokeReading>>> ReadStrokes(
    const std::vector<Stroke>& strokes, const SegmentationParameters& segmentation = {},
    const LineParameters& parameters = {});

}  // namespace parti::sketch
