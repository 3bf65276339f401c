// roofHip(angle, overhang): a plane from every edge.
#include <array>

#include "grammar/operations/roof_parts.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyRoofHip(const Item& item, const Action& action) {
  return RoofOver(item, HipRoof(PolygonOf(item), PitchOf(action), NumberAt(action, 2)));
}

const std::array<Parameter, 3> kParameters = {
    PitchKindParameter(), PitchParameter(30),
    OverhangParameter("overhang", "of the eaves, measured down the roof")};

}  // namespace

constinit const Operation kRoofHip = {
    .name = "roofHip",
    .word = "RoofHip",
    .doc = "Builds a hip roof over a planar shape: a plane rises from every edge.",
    .source = "CGA; Aichholzer et al. 1995",
    .parameters = kParameters,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kVolume),
    .in_place = false,
    .apply = ApplyRoofHip,
};

}  // namespace parti::grammar
