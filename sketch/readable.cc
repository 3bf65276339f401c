#include "sketch/readable.h"

#include <array>
#include <cmath>
#include <optional>

#include "grammar/operation.h"

namespace parti::sketch {
namespace {

constexpr std::array kSteps_m = {5.0,  2.0,  1.0,  0.5,   0.2,   0.1,
                                 0.05, 0.02, 0.01, 0.005, 0.002, 0.001};

// The nearest multiple, written so that 0.1 steps give 2.3 and not 2.3000000000000003.
double Rounded(double value, double step) {
  return step >= 1 ? std::round(value / step) * step
                   : std::round(value / step) / std::round(1 / step);
}

// Sets every dial that has this value to another.
grammar::Action Replaced(grammar::Action action, double value, double with) {
  for (const grammar::Dial& dial : grammar::Dials(&action)) {
    if (*dial.value == value) *dial.value = with;
  }
  return action;
}

std::optional<double> ErrorOf(const grammar::Action& action, const MadeEdges& made,
                              const SketchedLines& lines, const SketchParameters& parameters) {
  const auto edges = made.Of(action);
  if (!edges) return std::nullopt;
  return MatchLines(lines, *edges, parameters.descent.outlier_deviations).error;
}

}  // namespace

grammar::Action Readable(const grammar::Action& action, const MadeEdges& made,
                         const SketchedLines& lines, const SketchParameters& parameters) {
  grammar::Action readable = action;
  auto error = ErrorOf(action, made, lines, parameters);
  if (!error) return action;
  grammar::Action exact = action;
  for (const grammar::Dial& dial : grammar::Dials(&exact)) {
    if (dial.kind == grammar::ParameterKind::kFactor) continue;
    const double value = *dial.value;
    for (const double step : kSteps_m) {
      const double rounded = Rounded(value, step);
      if (rounded == value) break;  // as coarse as it is already
      const bool in_range = rounded >= dial.low && rounded <= dial.high && rounded != 0;
      if (!in_range ||
          std::abs(rounded - value) > parameters.ranking.readable_share * std::abs(value)) {
        continue;
      }
      grammar::Action tried = Replaced(readable, value, rounded);
      const auto tried_error = ErrorOf(tried, made, lines, parameters);
      if (!tried_error || *tried_error > *error + 2 * parameters.ranking.readable_loss) continue;
      readable = std::move(tried);
      error = tried_error;
      break;
    }
  }
  return readable;
}

}  // namespace parti::sketch
