// How well a projected candidate line fits a drawn one (Jesus 2018, 6.4.2).
// Equations (6.12) and (6.13), with errata 17a and 20.
#pragma once

#include "base/math.h"

namespace parti::sketch {

/// Squared distances of the ends, in the better of both orientations (errata 19) [px^2].
double SquaredEndDistance(const Segment2& drawn, const Segment2& projected);

/// How a drawn line covers an edge: from and to which share of it.
struct Cover {
  double at_a = 0;        ///< where drawn.a lies, [0, 1]
  double at_b = 1;        ///< where drawn.b lies, [0, 1]
  double squared_px = 0;  ///< squared distances of both ends from there, added
  int free_ends = 0;      ///< ends that lie along the edge, not at its end
};

/// The cover that costs least, over both orientations, where an end that lies free costs
/// free_end_squared_px.
Cover CoverOf(const Segment2& drawn, const Segment2& projected, double free_end_squared_px);

/// (6.12): 1 where the points agree, 1/e at radius_px (errata 17a). radius_px > 0.
double EndFitness(const Vec2& p, const Vec2& q, double radius_px);

/// (6.13): the better product over both orientations, in [0, 1].
/// Properties: (1) reversing either line changes nothing; (2) 1 only for equal lines.
double LineFitness(const Segment2& drawn, const Segment2& projected, double radius_px);

}  // namespace parti::sketch
