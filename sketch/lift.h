// A drawn line to lines in the world: the candidates that project near it (Jesus 2018, 6.4.2).
// Not responsible for what the line means: several readings are kept (hypothesis.h decides).
#pragma once

#include "base/error.h"
#include "sketch/candidates.h"
#include "sketch/configuration.h"

namespace parti::sketch {

/// The fittest candidate, and for every operation the fittest few that lie apart from each other.
/// A candidate is moved along its family, between two samples, to where it fits best, so that what
/// is lifted isn't tied to the sampling.
///
/// drawn    px, in the view that `candidates` were projected with; of positive length.
/// errors   kNoFit  no candidate within reach of the line.
/// Properties: (1) the projection of `world` lies near `drawn`, within the radius of (6.12);
///             (2) reversing the drawn line lifts the same line.
Result<WorldLine> Lift(const Segment2& drawn, const Candidates& candidates, const Camera& camera,
                       const LiftParameters& parameters = {});

}  // namespace parti::sketch
