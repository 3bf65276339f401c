// A synthetic hand: device events of a pen that a person might have moved along given lines.
// The kinematic theory of rapid human movements (Plamondon 1995; sigma-lognormal form, O'Reilly and
// Plamondon 2009): each aimed movement has a lognormal speed profile, and the next one starts
// before the last has ended, which slows and rounds the corners. On top of it: endpoint scatter,
// bowing, physiological tremor, pen-down and pen-up hooks, pressure, a tablet that samples at 200
// Hz with jittered clocks. docs/pen-model.md gives the sources of the numbers.
#pragma once

#include <vector>

#include "base/event.h"
#include "base/random.h"

namespace parti::tests {

/// The person and the tablet. Lengths in mm on the surface, times in s.
struct PenModelParameters {
  double sigma = 0.28;       ///< lognormal shape of a movement's speed, [0.1, 0.5]
  double duration_s = 0.55;  ///< of a movement of reference_mm
  double reference_mm = 60;
  double duration_exponent = 0.35;  ///< isochrony: T = duration_s * (length / reference)^exponent
  double overlap = 0.2;             ///< share of a movement already covered by the next
  double scatter_mm = 0.25;         ///< deviation of an aimed point, plus
  double scatter_ratio = 0.004;     ///< this share of the movement's length
  double bow_ratio = 0.006;         ///< deviation of a movement's sagitta, share of its length
  double tremor_mm = 0.06;          ///< deviation of the tremor
  double tremor_low_hz = 8, tremor_high_hz = 12;
  double hook_probability = 0.35;  ///< at pen down, and half of it at pen up
  double hook_mm = 0.8;            ///< mean length of a hook
  double pressure = 0.52;          ///< plateau, [0, 1]
  double sample_s = 0.005;
  double jitter_s = 0.0006;   ///< deviation of a report's clock
  double units_per_mm = 200;  ///< resolution of the tablet
  double pressure_levels = 4096;
};

/// The events of one stroke that aims at `path` [mm], n >= 2 points: proximity in, an approach,
/// pen down, motions, pen up, proximity out. `start_s` is the time of the first event; returns the
/// events in time order. Positions lie on the tablet's grid and inside `size_mm`.
std::vector<PenEvent> DrawStroke(const std::vector<Vec2>& path, const Vec2& size_mm, double start_s,
                                 const PenModelParameters& parameters, Random* random);

}  // namespace parti::tests
