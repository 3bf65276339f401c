// Which shape a sketch is drawn on, so that nothing has to be selected before drawing (feature S5):
// the item on which some operation explains the lines best, among those that can be seen.
#pragma once

#include <span>
#include <vector>

#include "base/camera.h"
#include "base/stroke.h"
#include "grammar/item.h"
#include "sketch/suggestion.h"

namespace parti::sketch {

/// The numbers of choosing a target; prices as in RankingParameters.
struct TargetParameters {
  /// Items compared in full, chosen by how near the drawn ends lie to their edges on the screen.
  int most_compared = 10;
  int most_checked = 100;  ///< of these at most are asked whether they can be seen
  /// An end further from an item's edges than this says nothing more about it [px].
  double reach_px = 60;
  double hidden = 12;     ///< price of an item that is wholly hidden, or seen from behind [nat]
  double lost_line = 20;  ///< price of a line that no operation on the item comes near [nat]
};

/// A shape that may be meant, and the sketch read on it.
struct RankedTarget {
  size_t item = 0;        ///< index
  double score = 0;       ///< the reading's worth, less prices [nat]
  double hidden = 0;      ///< share of it that others hide, [0, 1]
  SketchReading reading;  ///< on this item
};

/// items    the visible leaves, or whatever may be drawn on; in the world.
/// returns  n >= 1 targets, best first; equally good ones in the order given.
/// errors   kNoFit  the sketch fits none of them;  kTooShort  no line;  kBadNumber  the camera.
/// Where whole edges of no shape explain every line, all are read once more, generously.
/// Cost: linear in the items on the screen, plus most_compared times ReadSketch.
Result<std::vector<RankedTarget>> RankTargets(const std::vector<Stroke>& strokes,
                                              const Camera& camera,
                                              std::span<const grammar::Item> items,
                                              const SketchParameters& parameters = {},
                                              const TargetParameters& target = {});

}  // namespace parti::sketch
