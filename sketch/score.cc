#include "sketch/score.h"

#include <algorithm>

namespace parti::sketch {
namespace {

double SquaredDistance(const Vec2& p, const Vec2& q) { return glm::dot(p - q, p - q); }

}  // namespace

double SquaredEndDistance(const Segment2& drawn, const Segment2& projected) {
  return std::min(SquaredDistance(drawn.a, projected.a) + SquaredDistance(drawn.b, projected.b),
                  SquaredDistance(drawn.a, projected.b) + SquaredDistance(drawn.b, projected.a));
}

double EndFitness(const Vec2& p, const Vec2& q, double radius_px) {
  return std::exp(-SquaredDistance(p, q) / (radius_px * radius_px));
}

double LineFitness(const Segment2& drawn, const Segment2& projected, double radius_px) {
  // A product of Gaussians is the Gaussian of the sum.
  return std::exp(-SquaredEndDistance(drawn, projected) / (radius_px * radius_px));
}

}  // namespace parti::sketch
