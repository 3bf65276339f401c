// offset: lines parallel to the outline of a planar item (Jesus 2018, 6.5.2; errata 22).
#include <algorithm>

#include "grammar/operation.h"
#include "sketch/actions.h"
#include "sketch/agreement.h"
#include "sketch/heuristic_geometry.h"
#include "sketch/heuristics.h"
#include "sketch/made_edges.h"

namespace parti::sketch {
namespace {

struct Outline {
  const grammar::Item* item;
  std::vector<OutlineEdge> edges;
  double near_m;
  Angle angle;
};

bool Near(const Vec2& p, const Vec2& q, double near_m) { return glm::distance(p, q) <= near_m; }

// Parallel to the edge, its ends on the bisectors through the edge's ends.
void ReadAsParallel(const Segment2& line, double fitness, const OutlineEdge& edge,
                    const Outline& outline, std::vector<ValueReading>* readings) {
  const Vec2 direction = glm::normalize(line.b - line.a), along = glm::normalize(edge.b - edge.a);
  if (!Parallel(Vec3(direction, 0), Vec3(along, 0), outline.angle)) return;
  const double inward = glm::dot((line.a + line.b) / 2.0 - edge.a, edge.inward);
  const Vec2 a = edge.a + edge.mitre_a * inward, b = edge.b + edge.mitre_b * inward;
  const bool same = Near(line.a, a, outline.near_m) && Near(line.b, b, outline.near_m);
  const bool flipped = Near(line.a, b, outline.near_m) && Near(line.b, a, outline.near_m);
  if (same || flipped) readings->push_back({inward, fitness});
}

// Along the bisector of the corner at the edge's start; the further end tells the distance.
void ReadAsMitre(const Segment2& line, double fitness, const OutlineEdge& edge,
                 const Outline& outline, std::vector<ValueReading>* readings) {
  const Vec2 direction = glm::normalize(line.b - line.a), mitre = glm::normalize(edge.mitre_a);
  if (!Parallel(Vec3(direction, 0), Vec3(mitre, 0), outline.angle)) return;
  const bool starts_here = glm::distance(line.a, edge.a) < glm::distance(line.b, edge.a);
  const Vec2 start = starts_here ? line.a : line.b, end = starts_here ? line.b : line.a;
  if (std::abs(Cross(mitre, start - edge.a)) > outline.near_m ||
      std::abs(Cross(mitre, end - edge.a)) > outline.near_m) {
    return;
  }
  readings->push_back({glm::dot(end - edge.a, edge.inward), fitness});
}

std::vector<ValueReading> DistancesOf(const WorldLine& line, const Outline& outline) {
  std::vector<ValueReading> readings;
  for (const LiftCandidate& reading : ReadingsOf(line)) {
    const Vec3 a = outline.item->scope.ToLocal(reading.world.a);
    const Vec3 b = outline.item->scope.ToLocal(reading.world.b);
    if (std::max(std::abs(a.z), std::abs(b.z)) > outline.near_m) continue;
    const Segment2 local{Vec2(a.x, a.y), Vec2(b.x, b.y)};
    if (glm::distance(local.a, local.b) <= 0) continue;
    for (const OutlineEdge& edge : outline.edges) {
      ReadAsParallel(local, reading.fitness, edge, outline, &readings);
      ReadAsMitre(local, reading.fitness, edge, outline, &readings);
    }
  }
  // A line on the outline itself is where it was: no offset.
  std::erase_if(readings,
                [&](const ValueReading& r) { return std::abs(r.value) < 0.1 * outline.near_m; });
  return readings;
}

}  // namespace

std::vector<Hypothesis> OffsetHeuristic(const Configuration& configuration,
                                        const grammar::Item& item,
                                        const HeuristicParameters& parameters) {
  const grammar::Operation* offset = grammar::FindOperation("offset");
  if (!offset || item.type != grammar::ItemType::kPlanar) return {};
  const double near_m = parameters.near_relative * DiagonalOf(item);
  const Outline outline{&item, OutlineOf(item), near_m, Angle::Degrees(parameters.angle_deg)};
  std::vector<std::vector<ValueReading>> distances;
  for (const WorldLine& line : configuration.lines) {
    distances.push_back(DistancesOf(line, outline));
  }
  if (parameters.partly) std::erase_if(distances, [](const auto& d) { return d.empty(); });
  std::vector<Hypothesis> hypotheses;
  for (const double inward : AgreedValues(distances, near_m / 2, parameters.most_starts)) {
    Hypothesis hypothesis{OffsetAction(*offset, -inward)};  // CGA's sign: negative is inward
    if (inward < 0) hypothesis.price = parameters.outward_offset;
    hypotheses.push_back(std::move(hypothesis));
  }
  return hypotheses;
}

}  // namespace parti::sketch
