#include "sketch/descent.h"

#include <algorithm>
#include <cmath>

#include "grammar/operation.h"
#include "sketch/cholesky.h"

namespace parti::sketch {
namespace {

// One unknown of the descent: a dial, or several that are kept equal.
struct Unknown {
  std::vector<size_t> dials;
  double range = 1;  ///< what a step is measured in: the dial's range, or the item's size
  double low = 0, high = 0;
};

// The error function F of (6.16) with what it needs.
struct Problem {
  const MadeEdges* made;
  const SketchedLines* lines;
  DescentParameters parameters;
  std::vector<Unknown> unknowns;
};

// What a length can be: up to the item's extent along the action's axis, or its diagonal.
double LengthRange(const grammar::Action& action, const MadeEdges& made) {
  for (const grammar::Argument& argument : action.arguments) {
    const auto* axis = std::get_if<grammar::Axis>(&argument);
    const double extent = axis ? made.item().scope.size[static_cast<int>(*axis)] : 0;
    if (extent > 0) return extent;
  }
  return made.diagonal_m();
}

double RangeOf(const grammar::Dial& dial, double length_range_m) {
  if (dial.kind == grammar::ParameterKind::kLength) return length_range_m;
  const double whole = dial.high - dial.low;
  return std::isfinite(whole) && whole > 0 && whole < 1e3 ? whole
                                                          : std::max(1.0, std::abs(*dial.value));
}

std::vector<Unknown> UnknownsOf(Hypothesis hypothesis, const MadeEdges& made) {
  const double length_range_m = LengthRange(hypothesis.action, made);
  const std::vector<grammar::Dial> dials = grammar::Dials(&hypothesis.action);
  std::vector<std::vector<size_t>> groups = hypothesis.equal;
  for (size_t i = 0; i < dials.size(); ++i) {
    const auto has = [&](const std::vector<size_t>& g) { return std::ranges::count(g, i) > 0; };
    const bool turned = hypothesis.turned.empty() || std::ranges::count(hypothesis.turned, i) > 0;
    if (turned && std::ranges::none_of(hypothesis.equal, has)) groups.push_back({i});
  }
  std::vector<Unknown> unknowns;
  for (std::vector<size_t>& group : groups) {
    const grammar::Dial& dial = dials[group.front()];
    unknowns.push_back({std::move(group), RangeOf(dial, length_range_m), dial.low, dial.high});
  }
  return unknowns;
}

double Value(const grammar::Action& action, const Unknown& unknown) {
  grammar::Action copy = action;
  return *grammar::Dials(&copy)[unknown.dials.front()].value;
}

// The action with one unknown set to a value, within its range.
grammar::Action With(grammar::Action action, const Unknown& unknown, double value) {
  const std::vector<grammar::Dial> dials = grammar::Dials(&action);
  for (const size_t i : unknown.dials) {
    *dials[i].value = std::clamp(value, unknown.low, unknown.high);
  }
  return action;
}

Result<Match> MatchOf(const grammar::Action& action, const Problem& problem) {
  const auto edges = problem.made->Of(action);
  if (!edges) return Fail(edges);
  return MatchLines(*problem.lines, *edges, problem.parameters.outlier_deviations);
}

// Distances of all ends as one vector, in expected deviations, outliers weighing less.
struct Residuals {
  std::vector<double> values;
  std::vector<double> weights;
};

Residuals ResidualsOf(const Match& match, const Problem& problem) {
  Residuals r;
  const double c2 = problem.parameters.outlier_deviations * problem.parameters.outlier_deviations;
  for (size_t i = 0; i < match.lines.size(); ++i) {
    const double deviation = problem.lines->lines()[i].deviation_px;
    for (const Vec2& off : {match.lines[i].off_a / deviation, match.lines[i].off_b / deviation}) {
      const double weight = 1 / (1 + glm::dot(off, off) / c2);
      r.values.insert(r.values.end(), {off.x, off.y});
      r.weights.insert(r.weights.end(), {weight, weight});
    }
  }
  return r;
}

// (6.17) for every end: change of the residuals over the unknown's whole range.
std::vector<double> Slope(const grammar::Action& action, const Unknown& unknown,
                          const Problem& problem) {
  const double value = Value(action, unknown);
  const double step = problem.parameters.step_relative * unknown.range;
  const grammar::Action above = With(action, unknown, value + step);
  const grammar::Action below = With(action, unknown, value - step);
  const double apart = Value(above, unknown) - Value(below, unknown);
  const auto match_above = MatchOf(above, problem), match_below = MatchOf(below, problem);
  std::vector<double> slope(4 * problem.lines->lines().size(), 0.0);
  if (!match_above || !match_below || apart <= 0) return slope;
  const Residuals r = ResidualsOf(*match_above, problem), s = ResidualsOf(*match_below, problem);
  for (size_t i = 0; i < slope.size(); ++i) {
    slope[i] = (r.values[i] - s.values[i]) * unknown.range / apart;
  }
  return slope;
}

struct Curvature {
  SquareMatrix matrix;           ///< Gauss and Newton's, in ranges of the unknowns
  std::vector<double> gradient;  ///< half of grad F, in the same units
};

Curvature CurvatureAt(const grammar::Action& action, const Match& match, const Problem& problem) {
  std::vector<std::vector<double>> slopes;
  for (const Unknown& unknown : problem.unknowns) {
    slopes.push_back(Slope(action, unknown, problem));
  }
  const Residuals r = ResidualsOf(match, problem);
  const size_t n = slopes.size();
  Curvature curvature{SquareMatrix(n), std::vector<double>(n, 0.0)};
  for (size_t k = 0; k < r.values.size(); ++k) {
    for (size_t i = 0; i < n; ++i) {
      curvature.gradient[i] += r.weights[k] * slopes[i][k] * r.values[k];
      for (size_t j = 0; j <= i; ++j) {
        curvature.matrix(i, j) += r.weights[k] * slopes[i][k] * slopes[j][k];
      }
    }
  }
  return curvature;
}

std::vector<double> ScaledStep(const Curvature& curvature) {
  SquareMatrix damped = curvature.matrix;
  for (size_t i = 0; i < damped.n; ++i) damped(i, i) = damped(i, i) * (1 + 1e-6) + 1e-9;
  const auto lower = Cholesky(damped);
  return lower ? Solve(*lower, curvature.gradient) : std::vector<double>(damped.n, 0.0);
}

double SharpnessOf(const Curvature& curvature) {
  SquareMatrix whole = curvature.matrix;
  for (size_t i = 0; i < whole.n; ++i) whole(i, i) += 1;
  const auto lower = Cholesky(whole);
  return lower ? LogDeterminant(*lower) / 2 : 0;
}

grammar::Action Moved(grammar::Action action, const std::vector<double>& step, double share,
                      const Problem& problem) {
  for (size_t i = 0; i < step.size(); ++i) {
    const Unknown& unknown = problem.unknowns[i];
    const double value = Value(action, unknown) - share * step[i] * unknown.range;
    action = With(std::move(action), unknown, value);
  }
  return action;
}

// Goes along the step as far as it pays; false where it does not pay at all.
bool SearchAlong(const std::vector<double>& step, const Problem& problem, Adjusted* adjusted) {
  double share = 1;
  for (int i = 0; i <= problem.parameters.most_halvings; ++i, share /= 2) {
    grammar::Action moved = Moved(adjusted->hypothesis.action, step, share, problem);
    auto match = MatchOf(moved, problem);
    if (!match || !(match->error < adjusted->match.error)) continue;
    adjusted->hypothesis.action = std::move(moved);
    adjusted->match = std::move(*match);
    return true;
  }
  return false;
}

}  // namespace

Result<Adjusted> Adjust(const Hypothesis& hypothesis, const MadeEdges& made,
                        const SketchedLines& lines, const SketchParameters& parameters) {
  const Problem problem{&made, &lines, parameters.descent, UnknownsOf(hypothesis, made)};
  auto first = MatchOf(hypothesis.action, problem);
  if (!first) return Fail(first);
  Adjusted adjusted{hypothesis, std::move(*first)};
  adjusted.first_error = adjusted.match.error;
  Curvature curvature = CurvatureAt(hypothesis.action, adjusted.match, problem);
  for (int i = 0; i < parameters.descent.most_iterations; ++i) {
    const double before = adjusted.match.error;
    if (!SearchAlong(ScaledStep(curvature), problem, &adjusted)) break;
    curvature = CurvatureAt(adjusted.hypothesis.action, adjusted.match, problem);
    if (before - adjusted.match.error <= parameters.descent.negligible * before) break;
  }
  adjusted.sharpness = SharpnessOf(curvature);
  return adjusted;
}

}  // namespace parti::sketch
