// roofShed(angle, index): one plane over everything.
#include <array>
#include <cmath>

#include "grammar/front_edge.h"
#include "grammar/operations/roof_parts.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyRoofShed(const Item& item, const Action& action) {
  const Polygon polygon = PolygonOf(item);
  const double index = NumberAt(action, 2);
  const auto count = static_cast<double>(polygon.outer.size());
  const size_t edge = index < 0 ? FrontEdge(item) : static_cast<size_t>(std::fmod(index, count));
  return RoofOver(item, ShedRoof(polygon, PitchOf(action), edge));
}

const std::array<Parameter, 3> kParameters = {
    PitchKindParameter(), PitchParameter(15),
    Parameter{.name = "index",
              .kind = ParameterKind::kFactor,
              .low = -1,
              .high = 1e6,
              .default_value = -1.0,
              .required = false,
              .doc = "of the edge that stays low, from 0; -1: the front"}};

}  // namespace

constinit const Operation kRoofShed = {
    .name = "roofShed",
    .word = "RoofShed",
    .doc = "Builds a shed roof over a planar shape: one plane that rises from an edge.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kVolume),
    .in_place = false,
    .apply = ApplyRoofShed,
};

}  // namespace parti::grammar
