#include "sketch/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>

#include "sketch/candidates.h"
#include "sketch/descent.h"
#include "sketch/heuristics.h"
#include "sketch/lift_stroke.h"
#include "sketch/ranking.h"
#include "sketch/readable.h"
#include "sketch/sampled_hypotheses.h"
#include "sketch/symbols.h"

namespace parti::sketch {
namespace {

constexpr const char* kNoLine = "the sketch has no line";
constexpr const char* kDrawEdges = "draw one or more edges of what the operation should make";

// What the stages after lifting share for one configuration on one item.
struct Sketch {
  const Configuration* configuration;
  const grammar::Item* item;
  const MadeEdges& made;
  const SketchedLines& lines;
  Match traced;  ///< the lines against the item's own edges
  const SketchParameters* parameters;
};

std::vector<Hypothesis> ProposedByHeuristics(const Configuration& configuration,
                                             const Sketch& sketch) {
  std::vector<Hypothesis> all;
  for (const Heuristic& heuristic : Heuristics()) {
    std::ranges::move(heuristic.propose(configuration, *sketch.item, sketch.parameters->heuristics),
                      std::back_inserter(all));
  }
  return all;
}

// What the heuristics make of all lines but one: a slip of the pen must not cost the rest.
std::vector<Hypothesis> ProposedWithoutOneLine(const Sketch& sketch) {
  std::vector<Hypothesis> all;
  const std::vector<WorldLine>& lines = sketch.configuration->lines;
  if (lines.size() < 2) return all;
  for (size_t left_out = 0; left_out < lines.size(); ++left_out) {
    Configuration others;
    for (size_t i = 0; i < lines.size(); ++i) {
      if (i != left_out) others.lines.push_back(lines[i]);
    }
    std::ranges::move(ProposedByHeuristics(others, sketch), std::back_inserter(all));
  }
  return all;
}

std::optional<Suggestion> Judge(const Hypothesis& hypothesis, const Sketch& sketch) {
  auto adjusted = Adjust(hypothesis, sketch.made, sketch.lines, *sketch.parameters);
  if (!adjusted || IsHopeless(*adjusted, sketch.lines, sketch.parameters->ranking) ||
      MerelyTraces(*adjusted, sketch.traced, sketch.parameters->ranking) ||
      HasSliver(adjusted->hypothesis.action, *sketch.item,
                sketch.parameters->heuristics.plane_relative)) {
    return std::nullopt;
  }
  const auto edges = sketch.made.Of(adjusted->hypothesis.action, /*distinct=*/true);
  Suggestion suggestion;
  suggestion.error = MeanEndDistance_px(adjusted->match);
  suggestion.score = LogEvidence(*adjusted, edges ? edges->size() : 1) +
                     SpacingCredit(*adjusted, sketch.lines, sketch.parameters->ranking,
                                   sketch.parameters->descent.outlier_deviations);
  suggestion.by_heuristic = hypothesis.by_heuristic;
  for (const LineMatch& line : adjusted->match.lines) {
    suggestion.worst_line = std::max(suggestion.worst_line, line.error / 2);
  }
  suggestion.action = std::move(adjusted->hypothesis.action);
  NameProducts(*sketch.item, hypothesis.equal, &suggestion.action);
  return suggestion;
}

void JudgeAll(const std::vector<Hypothesis>& hypotheses, const Sketch& sketch,
              std::vector<Suggestion>* suggestions) {
  for (const Hypothesis& hypothesis : hypotheses) {
    auto suggestion = Judge(hypothesis, sketch);
    if (suggestion) suggestions->push_back(std::move(*suggestion));
  }
}

Result<std::vector<Suggestion>> SuggestWith(const Configuration& configuration,
                                            const grammar::Item& item, const Candidates& candidates,
                                            const SketchParameters& parameters) {
  const MadeEdges made(item);
  const SketchedLines lines =
      parameters.parts.allowed
          ? SketchedLines(configuration, parameters.noise, parameters.parts, made)
          : SketchedLines(configuration, parameters.noise);
  Sketch sketch{&configuration, &item, made, lines, {}, &parameters};
  sketch.traced =
      MatchLines(sketch.lines, sketch.made.item_edges(), parameters.descent.outlier_deviations);
  std::vector<Suggestion> suggestions;
  JudgeAll(ProposedByHeuristics(configuration, sketch), sketch, &suggestions);
  if (suggestions.empty()) JudgeAll(ProposedWithoutOneLine(sketch), sketch, &suggestions);
  const bool all = suggestions.empty();
  JudgeAll(
      SampledHypotheses(sketch.lines, candidates, all, parameters.most_suggestions, parameters),
      sketch, &suggestions);
  if (suggestions.empty()) {
    return Fail(ErrorCode::kNoFit, "no operation makes edges like the drawn lines", kDrawEdges);
  }
  suggestions = Ranked(std::move(suggestions), sketch.made.diagonal_m(), parameters);
  for (Suggestion& suggestion : suggestions) {
    suggestion.action = Readable(suggestion.action, sketch.made, sketch.lines, parameters);
  }
  return suggestions;
}

Result<void> CheckItem(const grammar::Item& item) {
  const Vec3& size = item.scope.size;
  const double area = grammar::IsFlat(item.type) ? size.x * size.y : size.x * size.y * size.z;
  if (std::isfinite(area) && area > 0) return {};
  return Fail(ErrorCode::kDegenerateGeometry, "the shape that was drawn on has no size",
              "draw on a shape that has an area");
}

double LengthOf(const StrokeReading& reading) {
  double length_px = 0;
  for (const Segment2& line : reading.lines) length_px += glm::distance(line.a, line.b);
  return length_px;
}

using LiftedStrokes = std::vector<std::vector<LiftedStroke>>;

// Every stroke's readings in the world; strokes that find no candidate are counted as lost.
// errors  kNoFit  none finds any.
Result<LiftedStrokes> LiftAll(const std::vector<std::vector<StrokeReading>>& strokes,
                              const Candidates& candidates, const Camera& camera,
                              const SketchParameters& parameters, SketchReading* lost) {
  LiftedStrokes all;
  Error last{ErrorCode::kTooShort, kNoLine, kDrawEdges};
  for (const std::vector<StrokeReading>& stroke : strokes) {
    auto lifted = LiftReadings(stroke, candidates, camera, parameters);
    if (lifted) {
      all.push_back(std::move(*lifted));
    } else {
      last = lifted.error();
      ++lost->lost_lines;
      lost->lost_px += LengthOf(stroke.front());
    }
  }
  if (all.empty()) return tl::unexpected<Error>(last);
  return all;
}

// Which reading of each stroke: the best of all, and for every stroke whose second reading is worth
// nearly as much the same with that one, the nearest first.
std::vector<std::vector<size_t>> Choices(const LiftedStrokes& strokes,
                                         const LiftParameters& parameters) {
  struct Swap {
    double behind;
    size_t stroke, reading;
  };
  std::vector<Swap> swaps;
  for (size_t i = 0; i < strokes.size(); ++i) {
    for (size_t j = 1; j < strokes[i].size(); ++j) {
      const double behind = strokes[i][0].worth - strokes[i][j].worth;
      if (behind <= parameters.near_reading) swaps.push_back({behind, i, j});
    }
  }
  std::ranges::stable_sort(swaps, std::less<>(), &Swap::behind);
  std::vector<std::vector<size_t>> choices = {std::vector<size_t>(strokes.size(), 0)};
  for (const Swap& swap : swaps) {
    if (static_cast<int>(choices.size()) == parameters.most_sketch_readings) break;
    choices.push_back(choices.front());
    choices.back()[swap.stroke] = swap.reading;
  }
  return choices;
}

// The chosen reading of each stroke, added to what was lost.
SketchReading Chosen(const LiftedStrokes& strokes, const std::vector<size_t>& choice,
                     SketchReading reading, const LiftParameters& parameters) {
  for (size_t i = 0; i < strokes.size(); ++i) {
    const LiftedStroke& stroke = strokes[i][choice[i]];
    std::ranges::copy(stroke.lines, std::back_inserter(reading.configuration.lines));
    reading.lost_lines += stroke.lost_lines;
    reading.lost_px += stroke.lost_px;
    reading.worth += parameters.line_worth * static_cast<double>(stroke.lines.size());
    reading.worth -= stroke.price;
  }
  return reading;
}

Result<Candidates> CandidatesFor(const grammar::Item& item, const Camera& camera,
                                 const SketchParameters& parameters) {
  if (const auto fine = Validate(camera); !fine) return tl::unexpected<Error>(fine.error());
  if (const auto fine = CheckItem(item); !fine) return tl::unexpected<Error>(fine.error());
  return CandidatesOf(item, View(camera), parameters.candidates);
}

using Strokes = std::vector<std::vector<StrokeReading>>;

// Whether more was lost than hooks and other slips of the pen.
bool LosesLines(const SketchReading& reading, const PartParameters& parameters) {
  double found_px = 0;
  for (const WorldLine& line : reading.configuration.lines) {
    found_px += glm::distance(line.drawn.a, line.drawn.b);
  }
  return reading.lost_px > parameters.slip * found_px;
}

// What a reading is worth to one that finds other lines: lost ones are left over.
double WorthOfAll(const SketchReading& reading, const PartParameters& parameters) {
  const double lost = LosesLines(reading, parameters) ? reading.lost_lines : 0;
  return reading.worth - parameters.left_over * lost;
}

// The first reading where it explains every line, or about as much as the generous one.
Result<SketchReading> ReadTwice(const Strokes& strokes, const grammar::Item& item,
                                const Camera& camera, const SketchParameters& parameters) {
  auto first = ReadSketch(strokes, item, camera, parameters);
  if (first && ExplainsAll(*first, parameters.parts)) return first;
  if (!first && first.error().code != ErrorCode::kNoFit) return first;
  auto second = ReadSketch(strokes, item, camera, Generous(parameters));
  if (!second) return first;
  const auto worth = [&](const SketchReading& r) { return WorthOfAll(r, parameters.parts); };
  const bool better = !first || worth(*second) > worth(*first) + parameters.parts.least_gain;
  return better ? second : first;
}

}  // namespace

SketchParameters Generous(SketchParameters parameters) {
  parameters.parts.allowed = true;
  parameters.candidates.generous = true;
  parameters.heuristics.partly = true;
  return parameters;
}

bool ExplainsAll(const SketchReading& reading, const PartParameters& parameters) {
  return !LosesLines(reading, parameters) &&
         reading.suggestions.front().worst_line < parameters.unexplained;
}

Result<std::vector<WorldLine>> LiftStroke(const Stroke& stroke, const grammar::Item& item,
                                          const Camera& camera,
                                          const SketchParameters& parameters) {
  const auto candidates = CandidatesFor(item, camera, parameters);
  if (!candidates) return Fail(candidates);
  const auto readings = ReadStroke(stroke, parameters.segmentation, parameters.lines);
  if (!readings) return Fail(readings);
  auto lifted = LiftReadings(*readings, *candidates, camera, parameters);
  if (!lifted) return Fail(lifted);
  return std::move(lifted->front().lines);
}

Result<std::vector<Suggestion>> Suggest(const Configuration& configuration,
                                        const grammar::Item& item,
                                        const SketchParameters& parameters) {
  if (configuration.lines.empty()) return Fail(ErrorCode::kTooShort, kNoLine, kDrawEdges);
  const auto candidates = CandidatesFor(item, configuration.lines.back().camera, parameters);
  if (!candidates) return Fail(candidates);
  return SuggestWith(configuration, item, *candidates, parameters);
}

Result<SketchReading> ReadSketch(const std::vector<std::vector<StrokeReading>>& strokes,
                                 const grammar::Item& item, const Camera& camera,
                                 const SketchParameters& parameters) {
  if (strokes.size() > static_cast<size_t>(parameters.most_strokes)) {
    return Fail(ErrorCode::kLimitReached,
                fmt::format("the sketch has more than {} strokes", parameters.most_strokes),
                "accept an operation before drawing the next");
  }
  const auto candidates = CandidatesFor(item, camera, parameters);
  if (!candidates) return Fail(candidates);
  SketchReading lost;
  const auto lifted = LiftAll(strokes, *candidates, camera, parameters, &lost);
  if (!lifted) return Fail(lifted);
  Result<SketchReading> best = Fail(ErrorCode::kNoFit, "the sketch has no reading");
  for (const std::vector<size_t>& choice : Choices(*lifted, parameters.lift)) {
    SketchReading reading = Chosen(*lifted, choice, lost, parameters.lift);
    auto suggestions = SuggestWith(reading.configuration, item, *candidates, parameters);
    if (!suggestions) {
      if (!best) best = Fail(suggestions);
      continue;
    }
    reading.worth += suggestions->front().score;
    reading.suggestions = std::move(*suggestions);
    if (!best || reading.worth > best->worth) best = std::move(reading);
  }
  return best;
}

Result<std::vector<Suggestion>> SuggestFromStrokes(const std::vector<Stroke>& strokes,
                                                   const grammar::Item& item, const Camera& camera,
                                                   const SketchParameters& parameters) {
  const auto readings = ReadStrokes(strokes, parameters.segmentation, parameters.lines);
  if (!readings) return Fail(readings);
  auto reading = ReadTwice(*readings, item, camera, parameters);
  if (!reading) return Fail(reading);
  return std::move(reading->suggestions);
}

Configuration Settled(const Configuration& configuration, const grammar::Item& item,
                      const grammar::Action& action) {
  const SketchParameters parameters;
  const auto edges = MadeEdges(item).Of(action);
  if (!edges) return configuration;
  const SketchedLines lines(configuration, parameters.noise);
  const Match match = MatchLines(lines, *edges, parameters.descent.outlier_deviations);
  Configuration settled = configuration;
  for (size_t i = 0; i < settled.lines.size(); ++i) {
    const LineMatch& line = match.lines[i];
    if (line.edge < 0) continue;
    const double length_px = glm::distance(settled.lines[i].drawn.a, settled.lines[i].drawn.b);
    const double off_px =
        std::sqrt(glm::dot(line.off_a, line.off_a) + glm::dot(line.off_b, line.off_b));
    if (off_px > parameters.ranking.hopeless_relative * length_px) continue;
    settled.lines[i].world = (*edges)[static_cast<size_t>(line.edge)];
  }
  return settled;
}

}  // namespace parti::sketch
