#include "sketch/candidates.h"

#include <algorithm>

#include "grammar/operation.h"
#include "sketch/heuristic_geometry.h"
#include "sketch/heuristics.h"
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

// Every so manieth of them: at most `most`.
std::vector<double> Thinned(const std::vector<double>& lengths, int most) {
  const size_t stride =
      (lengths.size() + static_cast<size_t>(most) - 1) / static_cast<size_t>(most);
  std::vector<double> few;
  for (size_t i = stride; i <= lengths.size() && stride > 0; i += stride) {
    few.push_back(lengths[i - 1]);
  }
  return few;
}

// What samples are added to, and how.
struct Collector {
  const MadeEdges* made;
  const View* view;
  bool generous;
  Candidates* candidates;
};

void AddEdges(grammar::Action action, int family, const std::vector<Segment3>& edges,
              const Collector& to) {
  Candidates& all = *to.candidates;
  Sample sample{std::move(action), family, static_cast<uint32_t>(all.edges.size()),
                static_cast<uint32_t>(edges.size())};
  for (const Segment3& edge : edges) {
    all.edges.push_back(edge);
    all.screen.push_back(to.view->Project(edge));
    if (to.generous) all.on_item.push_back(to.made->IsOnItem(edge) ? 1 : 0);
  }
  all.samples.push_back(std::move(sample));
}

void AddSamples(Family family, int number, const Collector& to) {
  for (grammar::Action& action : family.actions) {
    const auto edges = to.made->Of(action);
    if (!edges || edges->empty()) continue;  // this length does not fit this item
    AddEdges(std::move(action), number, *edges, to);
  }
}

// Samples whose lengths are evenly spaced, of operations whose edges move evenly with the length:
// the first and the last tell those between.
void AddEvenSamples(Family family, int number, const Collector& to) {
  std::vector<grammar::Action>& actions = family.actions;
  if (actions.size() < 2) return AddSamples(std::move(family), number, to);
  const auto first = to.made->Of(actions.front()), last = to.made->Of(actions.back());
  if (!first || !last || first->size() != last->size()) return;
  for (size_t i = 0; i < actions.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(actions.size() - 1);
    const auto between = [&](const Vec3& p, const Vec3& q) { return p + (q - p) * share; };
    std::vector<Segment3> edges;
    for (size_t e = 0; e < first->size(); ++e) {
      const Segment3 &low = (*first)[e], &high = (*last)[e];
      edges.push_back({between(low.a, high.a), between(low.b, high.b)});
    }
    AddEdges(std::move(actions[i]), number, edges, to);
  }
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
  const Collector to{&made, &view, parameters.generous, &candidates};
  int family = 0;
  const std::vector<double> few = Thinned(*lengths, parameters.most_rarer_lengths);
  for (const grammar::Operation& operation : grammar::Operations()) {
    if (!(operation.takes & grammar::Types(item.type))) continue;
    const Heuristic* heuristic = HeuristicFor(operation.name);
    const bool rarer = heuristic != nullptr && heuristic->rarer;
    if (rarer && !(parameters.generous && LooksUp(item))) continue;
    for (Family& f : FamiliesOf(operation, item, rarer ? few : *lengths)) {
      if (rarer) {
        AddEvenSamples(std::move(f), family, to);
      } else {
        AddSamples(std::move(f), family, to);
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
