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

/// Whether the lines are so far from the action's edges that suggesting it would be noise.
bool IsHopeless(const Adjusted& adjusted, const SketchedLines& lines,
                const RankingParameters& parameters);

/// Best first; of those that differ in numbers only, the best; at most `most`.
std::vector<Suggestion> Ranked(std::vector<Suggestion> suggestions, int most);

}  // namespace parti::sketch
