#include "sketch/ranking.h"

#include <algorithm>
#include <iterator>

#include "grammar/operation.h"

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

// The same operation with a number that is clearly another, and evidence that is nearly as good.
bool IsAnotherValue(const Suggestion& best, Suggestion other, double diagonal_m,
                    const RankingParameters& parameters) {
  if (other.score < best.score - parameters.distinct_nats) return false;
  grammar::Action action = best.action;
  const std::vector<grammar::Dial> a = grammar::Dials(&action), b = grammar::Dials(&other.action);
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    const double unit = a[i].kind == grammar::ParameterKind::kLength ? diagonal_m : 1;
    if (std::abs(*a[i].value - *b[i].value) >= parameters.distinct_relative * unit) return true;
  }
  return false;
}

}  // namespace

double LogEvidence(const Adjusted& adjusted, size_t edges) {
  const double choices = std::log(static_cast<double>(std::max<size_t>(edges, 1)));
  return -adjusted.match.error / 2 - choices * static_cast<double>(adjusted.match.explained) -
         adjusted.sharpness - adjusted.hypothesis.price;
}

double SpacingCredit(const Adjusted& adjusted, const SketchedLines& lines,
                     const RankingParameters& ranking, double outlier) {
  if (!adjusted.hypothesis.spaced_along) return 0;
  double credit = 0;
  for (size_t i = 0; i < adjusted.match.lines.size(); ++i) {
    const SketchedLines::Line& line = lines.lines()[i];
    const LineMatch& match = adjusted.match.lines[i];
    if (match.left_over) continue;
    const auto along =
        lines.views()[static_cast<size_t>(line.view)].Project(*adjusted.hypothesis.spaced_along);
    if (!along || along->a == along->b) continue;
    const double spacing_px = ranking.equal_spacing * glm::distance(along->a, along->b);
    const double spacing = spacing_px * spacing_px;
    // The pen's part of the distance along the axis; the mean of two ends varies half as much.
    const double pen = line.deviation_px * line.deviation_px / 2;
    const double share = std::sqrt(pen / (pen + spacing));
    const Vec2 axis = glm::normalize(along->b - along->a);
    const Vec2 even = axis * (glm::dot((match.off_a + match.off_b) / 2.0, axis) * (1 - share));
    const double left = LineError(match.off_a - even, match.off_b - even, line, outlier);
    credit += (match.error - left) / 2 - match.price + std::log(share);
  }
  return credit;
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

bool MerelyTraces(const Adjusted& adjusted, const Match& traced, const RankingParameters& ranking) {
  const double apart = std::abs(adjusted.match.error - traced.error);
  if (apart <= 1e-6 * (1 + traced.error)) return false;  // comp: the item's own edges
  for (size_t i = 0; i < traced.lines.size(); ++i) {
    if (traced.lines[i].error / 2 > adjusted.match.lines[i].error / 2 + ranking.tracing) {
      return false;
    }
  }
  return true;
}

bool HasSliver(const grammar::Action& action, const grammar::Item& item, double share) {
  if (action.operation->braces != grammar::Braces::kSizes) return false;
  const auto products = grammar::Apply(action, item);
  if (!products) return false;
  return std::any_of(products->begin(), products->end(), [&](const grammar::Product& product) {
    for (int axis = 0; axis < 3; ++axis) {
      if (product.item.scope.size[axis] < share * item.scope.size[axis]) return true;
    }
    return false;
  });
}

std::vector<Suggestion> Ranked(std::vector<Suggestion> suggestions, double diagonal_m,
                               const SketchParameters& parameters) {
  std::stable_sort(suggestions.begin(), suggestions.end(),
                   [](const Suggestion& a, const Suggestion& b) { return a.score > b.score; });
  std::vector<Suggestion> ranked, others;
  for (Suggestion& suggestion : suggestions) {
    const auto same = [&](const Suggestion& s) { return SameWords(s.action, suggestion.action); };
    const auto known = std::find_if(ranked.begin(), ranked.end(), same);
    if (known == ranked.end()) {
      ranked.push_back(std::move(suggestion));
    } else if (IsAnotherValue(*known, suggestion, diagonal_m, parameters.ranking) &&
               std::none_of(others.begin(), others.end(), same)) {
      others.push_back(std::move(suggestion));
    }
  }
  std::ranges::move(others, std::back_inserter(ranked));
  if (static_cast<int>(ranked.size()) > parameters.most_suggestions) {
    ranked.resize(static_cast<size_t>(parameters.most_suggestions));
  }
  return ranked;
}

}  // namespace parti::sketch
