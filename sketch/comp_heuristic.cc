// comp: a volume that is drawn on along its edges is taken apart (Jesus 2018, 6.5.4; errata 23).
#include <algorithm>

#include "grammar/operation.h"
#include "sketch/actions.h"
#include "sketch/heuristic_geometry.h"
#include "sketch/heuristics.h"
#include "sketch/made_edges.h"

namespace parti::sketch {
namespace {

bool Coincides(const Segment3& line, const Segment3& edge, double near_m) {
  const auto near = [&](const Vec3& p, const Vec3& q) { return glm::distance(p, q) <= near_m; };
  return (near(line.a, edge.a) && near(line.b, edge.b)) ||
         (near(line.a, edge.b) && near(line.b, edge.a));
}

bool LiesOn(const Segment3& line, const Segment3& edge, double near_m) {
  const Vec3 along = edge.b - edge.a;
  const auto near = [&](const Vec3& p) {
    const double t = std::clamp(glm::dot(p - edge.a, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::distance(p, edge.a + along * t) <= near_m;
  };
  return near(line.a) && near(line.b);
}

bool IsEdge(const WorldLine& line, const std::vector<Segment3>& edges, double near_m, bool partly) {
  const std::vector<LiftCandidate> readings = ReadingsOf(line);
  return std::any_of(readings.begin(), readings.end(), [&](const LiftCandidate& reading) {
    return std::any_of(edges.begin(), edges.end(), [&](const Segment3& edge) {
      return Coincides(reading.world, edge, near_m) ||
             (partly && LiesOn(reading.world, edge, near_m));
    });
  });
}

}  // namespace

std::vector<Hypothesis> CompHeuristic(const Configuration& configuration, const grammar::Item& item,
                                      const HeuristicParameters& parameters) {
  const grammar::Operation* comp = grammar::FindOperation("comp");
  if (!comp || item.type != grammar::ItemType::kVolume || configuration.lines.empty()) return {};
  const std::vector<Segment3> edges = grammar::EdgesOf(item);
  const double near_m = parameters.near_relative * DiagonalOf(item);
  const auto is_edge = [&](const WorldLine& line) {
    return IsEdge(line, edges, near_m, parameters.partly);
  };
  const bool traces = parameters.partly ? std::ranges::any_of(configuration.lines, is_edge)
                                        : std::ranges::all_of(configuration.lines, is_edge);
  if (!traces) return {};
  using Kind = grammar::Selector::Kind;
  Hypothesis alike{CompAction(*comp, {Kind::kAll})};
  alike.price = parameters.alike_faces;
  return {{CompAction(*comp, {Kind::kSide, Kind::kTop})}, std::move(alike)};
}

}  // namespace parti::sketch
