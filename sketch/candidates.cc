#include "sketch/candidates.h"

#include <algorithm>

#include "grammar/operation.h"
#include "sketch/made_edges.h"

namespace parti::sketch {
namespace {

// What the samples of a family have in common: the words, and the signs of the numbers.
grammar::Action WordsOf(grammar::Action action) {
  for (const grammar::Dial& dial : grammar::Dials(&action)) {
    *dial.value = *dial.value < 0 ? -1 : 1;
  }
  return action;
}

struct Family {
  grammar::Action words;
  std::vector<grammar::Action> actions;  // by length
};

std::vector<Family> FamiliesOf(const grammar::Operation& operation, const grammar::Item& item,
                               const std::vector<double>& lengths) {
  std::vector<Family> families;
  for (grammar::Action& action : grammar::Samples(operation, item, lengths)) {
    grammar::Action words = WordsOf(action);
    const auto same = [&](const Family& f) { return f.words == words; };
    auto family = std::find_if(families.begin(), families.end(), same);
    if (family == families.end()) {
      family = families.insert(family, Family{std::move(words), {}});
    }
    family->actions.push_back(std::move(action));
  }
  return families;
}

void AddSample(grammar::Action action, int family, const MadeEdges& made, const View& view,
               bool parts, Candidates* candidates) {
  const auto edges = made.Of(action);
  if (!edges || edges->empty()) return;  // this length does not fit this item
  Sample sample{std::move(action), family, static_cast<uint32_t>(candidates->edges.size()),
                static_cast<uint32_t>(edges->size())};
  for (const Segment3& edge : *edges) {
    candidates->edges.push_back(edge);
    candidates->screen.push_back(view.Project(edge));
    if (parts) candidates->on_item.push_back(made.IsOnItem(edge) ? 1 : 0);
  }
  candidates->samples.push_back(std::move(sample));
}

}  // namespace

Result<std::vector<double>> SampleLengths(const grammar::Item& item, const View& view,
                                          const CandidateParameters& parameters) {
  double nearest_px_per_m = 0, furthest_m = 0;
  for (const Segment3& edge : grammar::EdgesOf(item)) {
    for (const Vec3& corner : {edge.a, edge.b}) {
      nearest_px_per_m = std::max(nearest_px_per_m, view.PixelsPerMetre(corner));
      furthest_m = std::max(furthest_m, view.Depth(corner));
    }
  }
  if (nearest_px_per_m <= 0) {
    return Fail(ErrorCode::kBehindEye, "the shape lies behind the viewer",
                "turn the view until the shape can be seen");
  }
  const double half_view = view.camera().vertical_fov.radians() / 2;
  const double longest_m = parameters.reach * std::tan(half_view) * furthest_m;  // (6.10)
  const double spacing_m =
      std::max({parameters.spacing_px / nearest_px_per_m, longest_m / parameters.most_lengths,
                parameters.finest * DiagonalOf(item)});
  std::vector<double> lengths;
  for (int i = 1; i * spacing_m <= longest_m * (1 + 1e-12); ++i) lengths.push_back(i * spacing_m);
  return lengths;
}

Result<Candidates> CandidatesOf(const grammar::Item& item, const View& view,
                                const CandidateParameters& parameters) {
  const auto lengths = SampleLengths(item, view, parameters);
  if (!lengths) return Fail(lengths);
  Candidates candidates;
  const MadeEdges made(item);
  int family = 0;
  for (const grammar::Operation& operation : grammar::Operations()) {
    if (!(operation.takes & grammar::Types(item.type))) continue;
    for (Family& f : FamiliesOf(operation, item, *lengths)) {
      for (grammar::Action& action : f.actions) {
        AddSample(std::move(action), family, made, view, parameters.parts, &candidates);
      }
      ++family;
    }
  }
  if (candidates.samples.empty()) {
    return Fail(ErrorCode::kNoFit, "no operation can be applied to this shape",
                "draw on a shape that has an area");
  }
  return candidates;
}

}  // namespace parti::sketch
