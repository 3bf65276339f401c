// Candidate lines: the edges that every operation of the table makes of an item, over its parameter
// space (Jesus 2018, 6.4.1, Listing 6.1, 6.10, 6.11; errata 17a).
#pragma once

#include <optional>
#include <vector>

#include "base/camera.h"
#include "base/error.h"
#include "grammar/action.h"
#include "grammar/item.h"
#include "sketch/parameters.h"

namespace parti::sketch {

/// One action and the edges that it makes (MadeEdges): an edge that the item has anyhow tells
/// operations apart no better than no line at all. A family is one operation with the same words
/// (axis, selectors) and the same direction; within a family samples lie in order of their length.
struct Sample {
  grammar::Action action;
  int family = 0;
  uint32_t first = 0;  ///< its edges in Candidates
  uint32_t count = 0;
};

/// All samples for one item, with their edges side by side.
struct Candidates {
  std::vector<Sample> samples;                  ///< by family, then by length
  std::vector<Segment3> edges;                  ///< m
  std::vector<std::optional<Segment2>> screen;  ///< px; nothing for edges behind the eye
  /// 1 for edges on the item, which may be drawn in part; empty where none may be.
  std::vector<char> on_item;
};

/// The lengths that operations are sampled with: from 0 to reach * sigma (6.10), no two neighbours
/// further apart on the screen than spacing_px anywhere on the item.
/// errors  kBehindEye  no corner of the item is in front of the eye.
Result<std::vector<double>> SampleLengths(const grammar::Item& item, const View& view,
                                          const CandidateParameters& parameters = {});

/// errors  kBehindEye as above;  kNoFit  no operation can be applied to the item.
/// Cost: linear in the table's rows, the lengths and the item's edges.
Result<Candidates> CandidatesOf(const grammar::Item& item, const View& view,
                                const CandidateParameters& parameters = {});

}  // namespace parti::sketch
