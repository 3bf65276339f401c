// Heuristics: what configurations of lines mean the common operations, with first values for their
// numbers (Jesus 2018, 6.5.1-6.5.4; errata 21-23). Each reads the lines in the world, through the
// readings that lifting kept, and refuses by returning nothing. Exact values are descent's.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "grammar/item.h"
#include "sketch/configuration.h"
#include "sketch/hypothesis.h"
#include "sketch/parameters.h"

namespace parti::sketch {

/// 6.5.1: every line rises at right angles from a vertex of a planar item, or runs parallel to one
/// of its edges off its plane. Distance: the mean of the lines' greatest distances, signed.
std::vector<Hypothesis> ExtrudeHeuristic(const Configuration& configuration,
                                         const grammar::Item& item,
                                         const HeuristicParameters& parameters = {});

/// 6.5.2: every line lies on the bisector of a corner of a planar item, or runs parallel to an edge
/// between the bisectors of its ends. Distance: the mean over the lines.
std::vector<Hypothesis> OffsetHeuristic(const Configuration& configuration,
                                        const grammar::Item& item,
                                        const HeuristicParameters& parameters = {});

/// 6.5.3, for each axis of the scope: every line lies on the item at right angles to the axis.
/// Lines near each other are one plane. Gives the split with its equal sizes tied, the same with
/// all sizes free where any were tied, and the repeat where there are at least two planes and the
/// deviation of the sizes is small against their mean.
std::vector<Hypothesis> SplitHeuristic(const Configuration& configuration,
                                       const grammar::Item& item,
                                       const HeuristicParameters& parameters = {});

/// 6.5.4: every line is an edge of the item. Gives sides apart from top, and all faces alike
/// (errata 23).
std::vector<Hypothesis> CompHeuristic(const Configuration& configuration, const grammar::Item& item,
                                      const HeuristicParameters& parameters = {});

/// Every line belongs to a roof over a planar item that lies: its height, for each of the rows that
/// make roofs. Only where a part of the lines may be left over (HeuristicParameters::partly).
std::vector<Hypothesis> RoofHeuristic(const Configuration& configuration, const grammar::Item& item,
                                      const HeuristicParameters& parameters = {});

/// Lines in a planar item that lies, parallel to its axes, that turn corners with each other:
/// shapeL, shapeU or shapeO, whichever has no more widths than lines speak of. What the lines
/// enclose is the remainder. Only where lines may be left over.
std::vector<Hypothesis> ShapeHeuristic(const Configuration& configuration,
                                       const grammar::Item& item,
                                       const HeuristicParameters& parameters = {});

/// One row for each heuristic; operations without a row are found by sampling.
struct Heuristic {
  std::vector<std::string_view> operations;  ///< names in the operation table that it speaks for
  std::vector<Hypothesis> (*propose)(const Configuration&, const grammar::Item&,
                                     const HeuristicParameters&);
  bool rarer = false;  ///< sampled in the generous reading only (suggestion.h)
};
std::span<const Heuristic> Heuristics();
/// The row that speaks for an operation; nullptr where there is none.
const Heuristic* HeuristicFor(std::string_view operation);
inline bool HasHeuristic(std::string_view operation) { return HeuristicFor(operation) != nullptr; }

}  // namespace parti::sketch
