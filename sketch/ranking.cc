#include "sketch/ranking.h"

#include <algorithm>

namespace parti::sketch {
namespace {

bool SameSelectors(const grammar::Action& a, const grammar::Action& b) {
  const auto selects = [](const grammar::Successor& s, const grammar::Successor& t) {
    const auto* p = std::get_if<grammar::Selector>(&s.key);
    const auto* q = std::get_if<grammar::Selector>(&t.key);
    return !p == !q && (!p || *p == *q);
  };
  const bool sizes =
      !a.successors.empty() && std::holds_alternative<grammar::Size>(a.successors.front().key);
  return sizes || std::equal(a.successors.begin(), a.successors.end(), b.successors.begin(),
                             b.successors.end(), selects);
}

// One operation with the same words: only its numbers, and how many sizes it has, may differ.
bool SameWords(const grammar::Action& a, const grammar::Action& b) {
  if (a.operation != b.operation || a.arguments.size() != b.arguments.size()) return false;
  for (size_t i = 0; i < a.arguments.size(); ++i) {
    const bool numbers = std::holds_alternative<double>(a.arguments[i]) &&
                         std::holds_alternative<double>(b.arguments[i]);
    if (!numbers && a.arguments[i] != b.arguments[i]) return false;
  }
  return SameSelectors(a, b);
}

}  // namespace

double LogEvidence(const Adjusted& adjusted, size_t edges) {
  const double choices = std::log(static_cast<double>(std::max<size_t>(edges, 1)));
  return -adjusted.match.error / 2 - choices * static_cast<double>(adjusted.match.lines.size()) -
         adjusted.sharpness - adjusted.hypothesis.price;
}

bool IsHopeless(const Adjusted& adjusted, const SketchedLines& lines,
                const RankingParameters& parameters) {
  double length_px = 0;
  for (const SketchedLines::Line& line : lines.lines()) {
    length_px += glm::distance(line.drawn.a, line.drawn.b);
  }
  length_px /= static_cast<double>(std::max<size_t>(lines.lines().size(), 1));
  const double far = std::max(parameters.hopeless_px, parameters.hopeless_relative * length_px);
  return !(MeanEndDistance_px(adjusted.match) <= far);
}

std::vector<Suggestion> Ranked(std::vector<Suggestion> suggestions, int most) {
  std::stable_sort(suggestions.begin(), suggestions.end(),
                   [](const Suggestion& a, const Suggestion& b) { return a.score > b.score; });
  std::vector<Suggestion> ranked;
  for (Suggestion& suggestion : suggestions) {
    const auto same = [&](const Suggestion& s) { return SameWords(s.action, suggestion.action); };
    if (std::any_of(ranked.begin(), ranked.end(), same)) continue;
    if (static_cast<int>(ranked.size()) == most) break;
    ranked.push_back(std::move(suggestion));
  }
  return ranked;
}

}  // namespace parti::sketch
