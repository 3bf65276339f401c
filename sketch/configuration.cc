#include "sketch/configuration.h"

namespace parti::sketch {

std::vector<LiftCandidate> ReadingsOf(const WorldLine& line) {
  if (!line.alternatives.empty()) return line.alternatives;
  return {{line.world, line.fitness, nullptr}};
}

WorldLine DrawnPerfectly(const Segment3& world, const Camera& camera) {
  WorldLine line;
  line.world = world;
  line.drawn = View(camera).Project(world).value_or(Segment2{});
  line.fitness = 1;
  line.camera = camera;
  return line;
}

}  // namespace parti::sketch
