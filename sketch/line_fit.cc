#include "sketch/line_fit.h"

#include <algorithm>
#include <cmath>

namespace parti::sketch {

LineFits::LineFits(const StrokePath& path) {
  before_.reserve(path.position.size() + 1);
  Sums sums;
  before_.push_back(sums);
  for (const Vec2& position : path.position) {
    const Vec2 p = (position - path.position.front()) / path.diagonal;
    sums.x += p.x;
    sums.y += p.y;
    sums.xx += p.x * p.x;
    sums.yy += p.y * p.y;
    sums.xy += p.x * p.y;
    before_.push_back(sums);
  }
}

double LineFits::Bow(int from, int to) const {
  const Sums& a = before_[from];
  const Sums& b = before_[to + 1];
  const double n = to - from + 1;
  const double x = (b.x - a.x) / n, y = (b.y - a.y) / n;
  const double xx = (b.xx - a.xx) / n - x * x;
  const double yy = (b.yy - a.yy) / n - y * y;
  const double xy = (b.xy - a.xy) / n - x * y;
  // The smaller eigenvalue of the covariance; rounding may take it below 0.
  const double across = 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
  return std::sqrt(std::max(0.0, across));
}

}  // namespace parti::sketch
