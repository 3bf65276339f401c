// Sampling for operations that no heuristic speaks for, and for all where none fits (6.5.5).
// Not responsible for making the samples (candidates.h).
#pragma once

#include <vector>

#include "sketch/candidates.h"
#include "sketch/hypothesis.h"
#include "sketch/line_match.h"

namespace parti::sketch {

/// The best sample of each family (an operation with its words) by the error of (6.15), the samples
/// of candidate generation used again; best first, at most `most`.
/// all  also the operations that have a heuristic.
std::vector<Hypothesis> SampledHypotheses(const SketchedLines& lines, const Candidates& candidates,
                                          bool all, int most, const SketchParameters& parameters);

}  // namespace parti::sketch
