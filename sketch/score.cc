#include "sketch/score.h"

#include <algorithm>
#include <limits>

namespace parti::sketch {
namespace {

double SquaredDistance(const Vec2& p, const Vec2& q) { return glm::dot(p - q, p - q); }

struct End {
  double at;
  double squared_px;
  bool free;
};

// The end at `at` of the edge, or wherever along it the point lies, if that costs less.
End EndOf(const Vec2& p, double at, const Segment2& edge, double free_end_squared_px) {
  const End fixed{at, SquaredDistance(p, at > 0 ? edge.b : edge.a), false};
  if (fixed.squared_px <= free_end_squared_px) return fixed;
  const Vec2 along = edge.b - edge.a;
  const double t = glm::dot(p - edge.a, along) / glm::dot(along, along);
  if (!(t > 0 && t < 1)) return fixed;
  const double beside = SquaredDistance(p, edge.a + along * t);
  if (beside + free_end_squared_px >= fixed.squared_px) return fixed;
  return {t, beside, true};
}

}  // namespace

double SquaredEndDistance(const Segment2& drawn, const Segment2& projected) {
  return std::min(SquaredDistance(drawn.a, projected.a) + SquaredDistance(drawn.b, projected.b),
                  SquaredDistance(drawn.a, projected.b) + SquaredDistance(drawn.b, projected.a));
}

Cover CoverOf(const Segment2& drawn, const Segment2& projected, double free_end_squared_px) {
  Cover best;
  double least = std::numeric_limits<double>::infinity();
  for (const double at_a : {0.0, 1.0}) {
    const End a = EndOf(drawn.a, at_a, projected, free_end_squared_px);
    const End b = EndOf(drawn.b, 1 - at_a, projected, free_end_squared_px);
    const int free_ends = (a.free ? 1 : 0) + (b.free ? 1 : 0);
    const double squared = a.squared_px + b.squared_px;
    const double cost = free_ends > 0 ? squared + free_ends * free_end_squared_px : squared;
    if (cost >= least) continue;
    least = cost;
    best = {a.at, b.at, squared, free_ends};
  }
  return best;
}

double EndFitness(const Vec2& p, const Vec2& q, double radius_px) {
  return std::exp(-SquaredDistance(p, q) / (radius_px * radius_px));
}

double LineFitness(const Segment2& drawn, const Segment2& projected, double radius_px) {
  // A product of Gaussians is the Gaussian of the sum.
  return std::exp(-SquaredEndDistance(drawn, projected) / (radius_px * radius_px));
}

}  // namespace parti::sketch
