// extrude: a line that leaves a planar item along its normal (Jesus 2018, 6.5.1).
#include <algorithm>

#include "grammar/operation.h"
#include "sketch/actions.h"
#include "sketch/agreement.h"
#include "sketch/heuristic_geometry.h"
#include "sketch/heuristics.h"
#include "sketch/made_edges.h"

namespace parti::sketch {
namespace {

struct Base {
  const grammar::Item* item;
  std::vector<OutlineEdge> outline;
  double near_m;
  Angle angle;
};

bool AtVertex(const Base& base, const Vec3& local) {
  return std::any_of(base.outline.begin(), base.outline.end(), [&](const OutlineEdge& edge) {
    return glm::distance(Vec3(edge.a, 0), local) <= base.near_m;
  });
}

bool ParallelToOutline(const Base& base, const Vec3& direction) {
  return std::any_of(base.outline.begin(), base.outline.end(), [&](const OutlineEdge& edge) {
    return Parallel(Vec3(glm::normalize(edge.b - edge.a), 0), direction, base.angle);
  });
}

// Signed height of the line over the item; 0 where the line is neither a riser nor a parallel.
double HeightOf(const Segment3& world, const Base& base) {
  const Segment3 line{base.item->scope.ToLocal(world.a), base.item->scope.ToLocal(world.b)};
  const Vec3 direction = DirectionOf(line);
  if (Parallel(direction, Vec3(0, 0, 1), base.angle)) {
    if (AtVertex(base, line.a)) return line.b.z;
    if (AtVertex(base, line.b)) return line.a.z;
    return 0;
  }
  return ParallelToOutline(base, direction) ? (line.a.z + line.b.z) / 2 : 0;
}

std::vector<ValueReading> HeightsOf(const WorldLine& line, const Base& base) {
  std::vector<ValueReading> heights;
  for (const LiftCandidate& reading : ReadingsOf(line)) {
    const double height = HeightOf(reading.world, base);
    // Nearer to the plane than this the line lies in it, and says nothing about the distance.
    if (std::abs(height) > 0.1 * base.near_m) heights.push_back({height, reading.fitness});
  }
  return heights;
}

}  // namespace

std::vector<Hypothesis> ExtrudeHeuristic(const Configuration& configuration,
                                         const grammar::Item& item,
                                         const HeuristicParameters& parameters) {
  const grammar::Operation* extrude = grammar::FindOperation("extrude");
  if (!extrude || item.type != grammar::ItemType::kPlanar) return {};
  const double near_m = parameters.near_relative * DiagonalOf(item);
  const Base base{&item, OutlineOf(item), near_m, Angle::Degrees(parameters.angle_deg)};
  std::vector<std::vector<ValueReading>> heights;
  for (const WorldLine& line : configuration.lines) heights.push_back(HeightsOf(line, base));
  if (parameters.partly) std::erase_if(heights, [](const auto& h) { return h.empty(); });
  std::vector<Hypothesis> hypotheses;
  for (const double height : AgreedValues(heights, near_m, parameters.most_starts)) {
    Hypothesis hypothesis{ActionOfLength(*extrude, height)};
    if (height < 0) hypothesis.price = parameters.inward_extrude;
    hypotheses.push_back(std::move(hypothesis));
  }
  return hypotheses;
}

}  // namespace parti::sketch
