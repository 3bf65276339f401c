#include "sketch/line_match.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "sketch/made_edges.h"

namespace parti::sketch {
namespace {

// An end that can't be seen counts as this many deviations off.
constexpr double kUnseen = 1e3;

double Squared(const Vec2& v) { return glm::dot(v, v); }

// Both ends' damped errors add up to a logarithm of this product, which is monotonic in it.
double DampedProduct(const Vec2& off_a, const Vec2& off_b, double scale) {
  return (1 + Squared(off_a) * scale) * (1 + Squared(off_b) * scale);
}

LineMatch BestWhole(const SketchedLines::Line& line,
                    const std::vector<std::optional<Segment2>>& screen, double outlier) {
  const double variance = line.deviation_px * line.deviation_px;
  const double c = outlier * outlier;
  LineMatch best;
  double least = (1 + kUnseen * kUnseen / c) * (1 + kUnseen * kUnseen / c);
  for (size_t i = 0; i < screen.size(); ++i) {
    if (!screen[i]) continue;
    for (const bool flipped : {false, true}) {
      const Vec2 off_a = (flipped ? screen[i]->b : screen[i]->a) - line.drawn.a;
      const Vec2 off_b = (flipped ? screen[i]->a : screen[i]->b) - line.drawn.b;
      const double product = DampedProduct(off_a, off_b, 1 / (variance * c));
      if (product >= least) continue;
      least = product;
      best = {static_cast<int>(i), off_a, off_b};
    }
  }
  best.error = c * std::log(least);
  return best;
}

struct End {
  Vec2 off;
  double error;  // with its price twice
  double price;
};

// The end where the edge ends, or wherever it lies along the edge, if that costs less.
End BestEnd(const Vec2& drawn, const Vec2& whole, const Segment2& edge, double variance, double c2,
            double price) {
  const auto damped = [&](const Vec2& off) {
    return c2 * std::log1p(Squared(off) / variance / c2);
  };
  const End fixed{whole - drawn, damped(whole - drawn), 0};
  if (fixed.error <= 2 * price) return fixed;
  const Vec2 along = edge.b - edge.a;
  const double t = glm::dot(drawn - edge.a, along) / Squared(along);
  if (!(t > 0 && t < 1)) return fixed;
  const Vec2 off = edge.a + along * t - drawn;
  const double error = damped(off) + 2 * price;
  return error < fixed.error ? End{off, error, price} : fixed;
}

// As BestWhole, where lines may be parts of edges on the item, or left over.
LineMatch BestPart(const SketchedLines::Line& line,
                   const std::vector<std::optional<Segment2>>& screen,
                   const std::vector<bool>& on_item, const PartParameters& parts, double outlier) {
  const double variance = line.deviation_px * line.deviation_px;
  LineMatch best = BestWhole(line, screen, outlier);
  for (size_t i = 0; i < screen.size(); ++i) {
    if (!screen[i] || !on_item[i]) continue;
    for (const bool flipped : {false, true}) {
      const Segment2& edge = *screen[i];
      const End a = BestEnd(line.drawn.a, flipped ? edge.b : edge.a, edge, variance,
                            outlier * outlier, parts.free_end);
      const End b = BestEnd(line.drawn.b, flipped ? edge.a : edge.b, edge, variance,
                            outlier * outlier, parts.free_end);
      if (a.error + b.error >= best.error) continue;
      best = {static_cast<int>(i), a.off, b.off, a.error + b.error, a.price + b.price};
    }
  }
  if (best.error <= 2 * parts.left_over) return best;
  return {-1, {}, {}, 2 * parts.left_over, parts.left_over, true};
}

}  // namespace

SketchedLines::SketchedLines(const Configuration& configuration, const PenNoise& noise,
                             const PartParameters& parts, const MadeEdges& made)
    : SketchedLines(configuration, noise) {
  parts_ = parts;
  made_ = &made;
}

bool SketchedLines::MayBeDrawnInPart(const Segment3& edge) const {
  return parts_.allowed && made_ != nullptr && made_->IsOnItem(edge);
}

SketchedLines::SketchedLines(const Configuration& configuration, const PenNoise& noise) {
  for (const WorldLine& line : configuration.lines) {
    const auto same = [&](const View& view) { return view.camera() == line.camera; };
    const auto known = std::find_if(views_.begin(), views_.end(), same);
    const int view = static_cast<int>(known - views_.begin());
    if (known == views_.end()) views_.emplace_back(line.camera);
    const double length_px = glm::distance(line.drawn.a, line.drawn.b);
    lines_.push_back({line.drawn, noise.Deviation_px(length_px), view});
  }
}

double DampedError(double squared_deviations, double outlier) {
  const double c = outlier * outlier;
  return c * std::log1p(squared_deviations / c);
}

double LineError(const Vec2& off_a, const Vec2& off_b, const SketchedLines::Line& line,
                 double outlier) {
  const double variance = line.deviation_px * line.deviation_px;
  return DampedError(Squared(off_a) / variance, outlier) +
         DampedError(Squared(off_b) / variance, outlier);
}

Match MatchLines(const SketchedLines& lines, const std::vector<Segment3>& edges, double outlier) {
  std::vector<std::vector<std::optional<Segment2>>> screens;
  for (const View& view : lines.views()) {
    auto& screen = screens.emplace_back();
    screen.reserve(edges.size());
    for (const Segment3& edge : edges) screen.push_back(view.Project(edge));
  }
  std::vector<bool> on_item;
  if (lines.parts().allowed) {
    for (const Segment3& edge : edges) on_item.push_back(lines.MayBeDrawnInPart(edge));
  }
  Match match;
  for (const SketchedLines::Line& line : lines.lines()) {
    const auto& screen = screens[static_cast<size_t>(line.view)];
    match.lines.push_back(lines.parts().allowed
                              ? BestPart(line, screen, on_item, lines.parts(), outlier)
                              : BestWhole(line, screen, outlier));
    match.error += match.lines.back().error;
    match.explained += match.lines.back().left_over ? 0 : 1;
  }
  return match;
}

double MeanEndDistance_px(const Match& match) {
  double sum = 0;
  for (const LineMatch& line : match.lines) {
    if (line.left_over) continue;
    if (line.edge < 0) return std::numeric_limits<double>::infinity();
    sum += Squared(line.off_a) + Squared(line.off_b);
  }
  if (match.lines.empty()) return 0;
  if (match.explained == 0) return std::numeric_limits<double>::infinity();
  return std::sqrt(sum / (2.0 * static_cast<double>(match.explained)));
}

}  // namespace parti::sketch
