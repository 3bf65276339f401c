// Weighing adjusted operations against each other: how well each explains the lines, and how much
// freedom it needed for that (docs/inference.md, Ranking).
#pragma once

#include <vector>

#include "sketch/descent.h"
#include "sketch/suggestion.h"

namespace parti::sketch {

/// Log evidence of a hypothesis [nat]: - error / 2, less the log of the number of edges that each
/// line could have stood for, less what its free numbers cost, less its price.
double LogEvidence(const Adjusted& adjusted, size_t edges);

/// What the evidence of evenly spaced parts gains, because cuts that are meant even are drawn a
/// little off: each line may lie off along the axis by a normal deviation of equal_spacing, which
/// explains part of its distance and costs the freedom. 0 for hypotheses that are not even.
double SpacingCredit(const Adjusted& adjusted, const SketchedLines& lines,
                     const RankingParameters& ranking, double outlier);

/// Whether the lines are so far from the action's edges that suggesting it would be noise.
bool IsHopeless(const Adjusted& adjusted, const SketchedLines& lines,
                const RankingParameters& parameters);

/// Whether all lines fit the item's own edges (`traced`) about as well as the edges that the
/// operation makes: then they trace the item. Never so where it makes no other edges (comp).
bool MerelyTraces(const Adjusted& adjusted, const Match& traced, const RankingParameters& ranking);

/// Whether a split leaves a part thinner than this share of the whole: a cut that slid onto the
/// item's own edge, which is no cut. False for operations without sizes.
bool HasSliver(const grammar::Action& action, const grammar::Item& item, double share);

/// Best first, at most SketchParameters::most_suggestions. Of those that differ in numbers only,
/// the best, and after all others the next that is clearly another value and nearly as good.
std::vector<Suggestion> Ranked(std::vector<Suggestion> suggestions, double diagonal_m,
                               const SketchParameters& parameters);

}  // namespace parti::sketch
