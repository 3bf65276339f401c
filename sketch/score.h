// How well a projected candidate line fits a drawn one (Jesus 2018, 6.4.2).
// Equations (6.12) and (6.13), with errata 17a and 20.
#pragma once

#include "base/math.h"

namespace parti::sketch {

/// Squared distances of the ends, in the better of both orientations (errata 19) [px^2].
double SquaredEndDistance(const Segment2& drawn, const Segment2& projected);

/// (6.12): 1 where the points agree, 1/e at radius_px (errata 17a). radius_px > 0.
double EndFitness(const Vec2& p, const Vec2& q, double radius_px);

/// (6.13): the better product over both orientations, in [0, 1].
/// Properties: (1) reversing either line changes nothing; (2) 1 only for equal lines.
double LineFitness(const Segment2& drawn, const Segment2& projected, double radius_px);

}  // namespace parti::sketch
