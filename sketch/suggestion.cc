#include "sketch/suggestion.h"

#include <algorithm>
#include <optional>

#include "sketch/candidates.h"
#include "sketch/descent.h"
#include "sketch/drawn_lines.h"
#include "sketch/heuristics.h"
#include "sketch/lift.h"
#include "sketch/ranking.h"
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
  MadeEdges made;
  SketchedLines lines;
  const Candidates* candidates;
  const SketchParameters* parameters;
};

std::vector<Hypothesis> ProposedByHeuristics(const Sketch& sketch) {
  std::vector<Hypothesis> all;
  for (const Heuristic& heuristic : Heuristics()) {
    for (Hypothesis& hypothesis :
         heuristic.propose(*sketch.configuration, *sketch.item, sketch.parameters->heuristics)) {
      all.push_back(std::move(hypothesis));
    }
  }
  return all;
}

std::optional<Suggestion> Judge(const Hypothesis& hypothesis, const Sketch& sketch) {
  auto adjusted = Adjust(hypothesis, sketch.made, sketch.lines, *sketch.parameters);
  if (!adjusted || IsHopeless(*adjusted, sketch.lines, sketch.parameters->ranking)) {
    return std::nullopt;
  }
  const auto edges = sketch.made.Of(adjusted->hypothesis.action, /*distinct=*/true);
  Suggestion suggestion;
  suggestion.error = MeanEndDistance_px(adjusted->match);
  suggestion.score = LogEvidence(*adjusted, edges ? edges->size() : 1);
  suggestion.by_heuristic = hypothesis.by_heuristic;
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
  const Sketch sketch{&configuration,  &item,
                      MadeEdges(item), SketchedLines(configuration, parameters.noise),
                      &candidates,     &parameters};
  std::vector<Suggestion> suggestions;
  JudgeAll(ProposedByHeuristics(sketch), sketch, &suggestions);
  const bool all = suggestions.empty();
  JudgeAll(
      SampledHypotheses(sketch.lines, candidates, all, parameters.most_suggestions, parameters),
      sketch, &suggestions);
  if (suggestions.empty()) {
    return Fail(ErrorCode::kNoFit, "no operation makes edges like the drawn lines", kDrawEdges);
  }
  return Ranked(std::move(suggestions), parameters.most_suggestions);
}

Result<void> CheckItem(const grammar::Item& item) {
  const Vec3& size = item.scope.size;
  const double area =
      item.type == grammar::ItemType::kPlanar ? size.x * size.y : size.x * size.y * size.z;
  if (std::isfinite(area) && area > 0) return {};
  return Fail(ErrorCode::kDegenerateGeometry, "the shape that was drawn on has no size",
              "draw on a shape that has an area");
}

// The lines that could be lifted. errors  kNoFit  none could.
Result<SketchReading> LiftLines(const std::vector<Segment2>& drawn, const Candidates& candidates,
                                const Camera& camera, const LiftParameters& parameters) {
  SketchReading reading;
  for (const Segment2& line : drawn) {
    auto lifted = Lift(line, candidates, camera, parameters);
    if (lifted) {
      reading.configuration.lines.push_back(std::move(*lifted));
      continue;
    }
    ++reading.lost_lines;
    if (reading.lost_lines == static_cast<int>(drawn.size())) return Fail(lifted);
  }
  if (drawn.empty()) return Fail(ErrorCode::kTooShort, kNoLine, kDrawEdges);
  return reading;
}

Result<Candidates> CandidatesFor(const grammar::Item& item, const Camera& camera,
                                 const SketchParameters& parameters) {
  if (const auto fine = Validate(camera); !fine) return tl::unexpected<Error>(fine.error());
  if (const auto fine = CheckItem(item); !fine) return tl::unexpected<Error>(fine.error());
  return CandidatesOf(item, View(camera), parameters.candidates);
}

}  // namespace

Result<std::vector<WorldLine>> LiftStroke(const Stroke& stroke, const grammar::Item& item,
                                          const Camera& camera,
                                          const SketchParameters& parameters) {
  const auto candidates = CandidatesFor(item, camera, parameters);
  if (!candidates) return Fail(candidates);
  const auto drawn = DrawnLines(stroke, parameters.segmentation, parameters.lines);
  if (!drawn) return Fail(drawn);
  auto lifted = LiftLines(*drawn, *candidates, camera, parameters.lift);
  if (!lifted) return Fail(lifted);
  return std::move(lifted->configuration.lines);
}

Result<std::vector<Suggestion>> Suggest(const Configuration& configuration,
                                        const grammar::Item& item,
                                        const SketchParameters& parameters) {
  if (configuration.lines.empty()) return Fail(ErrorCode::kTooShort, kNoLine, kDrawEdges);
  const auto candidates = CandidatesFor(item, configuration.lines.back().camera, parameters);
  if (!candidates) return Fail(candidates);
  return SuggestWith(configuration, item, *candidates, parameters);
}

Result<SketchReading> ReadSketch(const std::vector<Segment2>& drawn, const grammar::Item& item,
                                 const Camera& camera, const SketchParameters& parameters) {
  const auto candidates = CandidatesFor(item, camera, parameters);
  if (!candidates) return Fail(candidates);
  auto reading = LiftLines(drawn, *candidates, camera, parameters.lift);
  if (!reading) return Fail(reading);
  auto suggestions = SuggestWith(reading->configuration, item, *candidates, parameters);
  if (!suggestions) return Fail(suggestions);
  reading->suggestions = std::move(*suggestions);
  return reading;
}

Result<std::vector<Suggestion>> SuggestFromStrokes(const std::vector<Stroke>& strokes,
                                                   const grammar::Item& item, const Camera& camera,
                                                   const SketchParameters& parameters) {
  const auto drawn = DrawnLines(strokes, parameters.segmentation, parameters.lines);
  if (!drawn) return Fail(drawn);
  auto reading = ReadSketch(*drawn, item, camera, parameters);
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
