// The lines of a sketch in the world, each with what was drawn (Jesus 2018, 6.4.2).
// Views may differ from line to line: a sketch survives moving the camera.
#pragma once

#include <vector>

#include "base/camera.h"
#include "base/math.h"

namespace parti::grammar {
struct Operation;
}

namespace parti::sketch {

/// One edge of one sampled operation that a drawn line may stand for, or the part of it that is
/// drawn.
struct LiftCandidate {
  Segment3 world;                                 ///< m
  double fitness = 0;                             ///< (6.13), (0, 1]
  const grammar::Operation* operation = nullptr;  ///< whose edge it is
  int free_ends = 0;                              ///< drawn ends that lie along it, 0 to 2
};

/// A line of the sketch in the world, and the screen line that it was lifted from. One view can't
/// tell depth, so the runners-up are kept until the whole sketch decides between them.
struct WorldLine {
  Segment3 world;                           ///< m; the fittest candidate
  Segment2 drawn;                           ///< px, as drawn, in the view it was drawn in
  double fitness = 0;                       ///< (6.13), (0, 1]
  Camera camera;                            ///< the view it was drawn in
  std::vector<LiftCandidate> alternatives;  ///< fittest first, `world` among them; may be empty
};

/// Lines accumulate here, stroke by stroke, and survive view changes (6.4.2).
struct Configuration {
  std::vector<WorldLine> lines;
};

/// What a line may be in the world: its alternatives, or `world` alone where it has none.
std::vector<LiftCandidate> ReadingsOf(const WorldLine& line);

/// A line of the world as a perfect pen would draw it; for tests and for lines made by code.
/// The part in front of the eye; a line behind it keeps a drawn line of no length.
WorldLine DrawnPerfectly(const Segment3& world, const Camera& camera);

}  // namespace parti::sketch
