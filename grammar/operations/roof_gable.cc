// roofGable(angle, overhangX, overhangY): a hip roof with upright ends.
#include <array>

#include "grammar/operations/roof_parts.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyRoofGable(const Item& item, const Action& action) {
  const GableOverhang overhang{NumberAt(action, 2), NumberAt(action, 3)};
  return RoofOver(item, GableRoof(PolygonOf(item), PitchOf(action), overhang, FrontIn(item)));
}

const std::array<Parameter, 4> kParameters = {
    PitchKindParameter(), PitchParameter(30),
    OverhangParameter("overhangX", "of the eaves, measured down the roof"),
    OverhangParameter("overhangY", "of the gables")};

}  // namespace

constinit const Operation kRoofGable = {
    .name = "roofGable",
    .word = "RoofGable",
    .doc =
        "Builds a gable roof over a planar shape: a hip roof whose triangular ends stand upright.",
    .source = "CGA",
    .parameters = kParameters,
    .braces = Braces::kNone,
    .selectors = {},
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kVolume),
    .in_place = false,
    .sampled = false,
    .apply = ApplyRoofGable,
};

}  // namespace parti::grammar
