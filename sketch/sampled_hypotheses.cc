#include "sketch/sampled_hypotheses.h"

#include <algorithm>
#include <map>

#include "grammar/operation.h"
#include "sketch/heuristics.h"

namespace parti::sketch {
namespace {

struct Start {
  const Sample* sample;
  double error;
};

double ErrorOf(const Sample& sample, const Candidates& candidates, const SketchedLines& lines,
               double outlier) {
  const auto first = candidates.edges.begin() + sample.first;
  return MatchLines(lines, {first, first + sample.count}, outlier).error;
}

}  // namespace

std::vector<Hypothesis> SampledHypotheses(const SketchedLines& lines, const Candidates& candidates,
                                          bool all, int most, const SketchParameters& parameters) {
  std::map<int, Start> best;
  for (const Sample& sample : candidates.samples) {
    if (!all && HasHeuristic(sample.action.operation->name)) continue;
    const double error = ErrorOf(sample, candidates, lines, parameters.descent.outlier_deviations);
    const auto [known, is_new] = best.try_emplace(sample.family, Start{&sample, error});
    if (!is_new && error < known->second.error) known->second = {&sample, error};
  }
  std::vector<Start> starts;
  for (const auto& [family, start] : best) starts.push_back(start);
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.error < b.error; });
  if (static_cast<int>(starts.size()) > most) starts.resize(static_cast<size_t>(most));
  std::vector<Hypothesis> hypotheses;
  for (const Start& start : starts) {
    Hypothesis hypothesis{start.sample->action};
    hypothesis.by_heuristic = false;
    if (HasHeuristic(hypothesis.action.operation->name)) {
      hypothesis.price = parameters.ranking.sampled;
    }
    hypotheses.push_back(std::move(hypothesis));
  }
  return hypotheses;
}

}  // namespace parti::sketch
