// roofHip, roofGable, roofPyramid, roofShed: lines that rise over a lying outline and meet above
// it. Gives their height; which edges a roof has is the rows' own business. Rarer than a mass with
// a flat roof: read where whole edges of the common operations leave lines unexplained.
#include <algorithm>
#include <array>

#include "grammar/operation.h"
#include "sketch/actions.h"
#include "sketch/agreement.h"
#include "sketch/heuristic_geometry.h"
#include "sketch/heuristics.h"
#include "sketch/made_edges.h"

namespace parti::sketch {
namespace {

// The top of each reading of the line as an edge of this roof, over the item's plane.
std::vector<ValueReading> TopsOf(const WorldLine& line, const grammar::Operation& roof,
                                 const grammar::Item& item, double near_m) {
  std::vector<ValueReading> tops;
  for (const LiftCandidate& reading : ReadingsOf(line)) {
    if (reading.operation != &roof) continue;
    const double top =
        std::max(item.scope.ToLocal(reading.world.a).z, item.scope.ToLocal(reading.world.b).z);
    if (top > 0.1 * near_m) tops.push_back({top, reading.fitness});
  }
  return tops;
}

constexpr std::array<std::string_view, 4> kRoofs = {"roofHip", "roofGable", "roofPyramid",
                                                    "roofShed"};

}  // namespace

std::vector<Hypothesis> RoofHeuristic(const Configuration& configuration, const grammar::Item& item,
                                      const HeuristicParameters& parameters) {
  std::vector<Hypothesis> hypotheses;
  if (!parameters.partly || item.type != grammar::ItemType::kPlanar || !LooksUp(item)) {
    return hypotheses;
  }
  const double near_m = parameters.near_relative * DiagonalOf(item);
  for (const std::string_view name : kRoofs) {
    const grammar::Operation* roof = grammar::FindOperation(name);
    if (!roof) continue;
    std::vector<std::vector<ValueReading>> tops;
    for (const WorldLine& line : configuration.lines) {
      tops.push_back(TopsOf(line, *roof, item, near_m));
    }
    std::erase_if(tops, [](const auto& t) { return t.empty(); });
    for (const double height_m : AgreedValues(tops, near_m / 2, parameters.most_starts)) {
      Hypothesis hypothesis{RoofAction(*roof, height_m)};
      hypothesis.price = parameters.roof;
      hypothesis.turned = {0};  // overhangs and the number of an edge are not drawn
      hypotheses.push_back(std::move(hypothesis));
    }
  }
  return hypotheses;
}

}  // namespace parti::sketch
