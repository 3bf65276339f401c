// The straight lines of a stroke, on the screen: segments without hooks, with merged neighbours.
// Where the stroke bends is segmentation's; where the lines are in the world is lifting's.
#pragma once

#include <vector>

#include "base/error.h"
#include "base/stroke.h"
#include "sketch/parameters.h"

namespace parti::sketch {

/// returns  n >= 1 lines in drawing order, px. The first and last line of a closed stroke meet
/// where
///          their straight parts cross, not where the pen happened to go down and up.
/// errors   kTooShort  a tap;  kNoFit  nothing but curves;  kBadNumber  a sample is not finite.
/// Properties: (1) reversing the stroke reverses the lines.
Result<std::vector<Segment2>> DrawnLines(const Stroke& stroke,
                                         const SegmentationParameters& segmentation = {},
                                         const LineParameters& parameters = {});

/// The lines of several strokes one after the other. Strokes without a line (taps, scribbles) are
/// passed over as long as one has a line.
/// errors   those of the last stroke when none has a line;  kTooShort  no strokes.
Result<std::vector<Segment2>> DrawnLines(const std::vector<Stroke>& strokes,
                                         const SegmentationParameters& segmentation = {},
                                         const LineParameters& parameters = {});

}  // namespace parti::sketch
