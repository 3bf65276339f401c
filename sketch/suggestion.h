// From a sketch on one item to the operations that may be meant, best first (Jesus 2018, 6.4-6.6).
#pragma once

#include <vector>

#include "base/camera.h"
#include "base/error.h"
#include "base/stroke.h"
#include "grammar/action.h"
#include "grammar/item.h"
#include "sketch/segmentation.h"

namespace parti::sketch {

/// A line of the sketch in the world, and the screen line that it was lifted from.
struct WorldLine {
  Segment3 world;      ///< m
  Segment2 drawn;      ///< px, as drawn, in the view it was drawn in
  double fitness = 0;  ///< (6.13), (0, 1]
};

/// Lines accumulate here, stroke by stroke, and survive view changes (6.4.2).
struct Configuration {
  std::vector<WorldLine> lines;
};

struct Suggestion {
  grammar::Action action;
  double error = 0;          ///< (6.15) after descent, per line, relative to the item's size
  double score = 0;          ///< what the list is ordered by, larger first
  bool by_heuristic = true;  ///< false: found by sampling
};

struct SketchParameters {
  SegmentationParameters segmentation;
  int most_suggestions = 8;
};

/// Segments a stroke and lifts its lines: for each, the best of the candidate lines that the
/// operations of the table make of `item` (Listing 6.1, 6.10-6.13).
/// errors  kTooShort  a tap;  kNoFit  no candidate near any of its lines.
Result<std::vector<WorldLine>> LiftStroke(const Stroke& stroke, const grammar::Item& item,
                                          const Camera& camera,
                                          const SketchParameters& parameters = {});

/// Operations that may be meant by a configuration, best first: the heuristics' (6.5), adjusted by
/// descent (6.6); sampled ones where no heuristic fits.
/// errors  kNoFit.
Result<std::vector<Suggestion>> Suggest(const Configuration& configuration,
                                        const grammar::Item& item,
                                        const SketchParameters& parameters = {});

/// Both of the above for a whole sketch in one view: what `parti suggest` answers.
Result<std::vector<Suggestion>> SuggestFromStrokes(const std::vector<Stroke>& strokes,
                                                   const grammar::Item& item, const Camera& camera,
                                                   const SketchParameters& parameters = {});

}  // namespace parti::sketch
