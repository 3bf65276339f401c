#include "sketch/line_match.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace parti::sketch {
namespace {

// An end that can't be seen counts as this many deviations off.
constexpr double kUnseen = 1e3;

double Squared(const Vec2& v) { return glm::dot(v, v); }

// Both ends' damped errors add up to a logarithm of this product, which is monotonic in it.
double DampedProduct(const Vec2& off_a, const Vec2& off_b, double scale) {
  return (1 + Squared(off_a) * scale) * (1 + Squared(off_b) * scale);
}

LineMatch BestEdge(const SketchedLines::Line& line,
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

}  // namespace

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
  Match match;
  for (const SketchedLines::Line& line : lines.lines()) {
    const auto& screen = screens[static_cast<size_t>(line.view)];
    match.lines.push_back(BestEdge(line, screen, outlier));
    match.error += match.lines.back().error;
  }
  return match;
}

double MeanEndDistance_px(const Match& match) {
  double sum = 0;
  for (const LineMatch& line : match.lines) {
    if (line.edge < 0) return std::numeric_limits<double>::infinity();
    sum += Squared(line.off_a) + Squared(line.off_b);
  }
  return match.lines.empty() ? 0 : std::sqrt(sum / (2.0 * static_cast<double>(match.lines.size())));
}

}  // namespace parti::sketch
