// roofPyramid(angle): every edge to one point.
#include <array>

#include "grammar/front_edge.h"
#include "grammar/operations/roof_parts.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyRoofPyramid(const Item& item, const Action& action) {
  return RoofOver(item, PyramidRoof(PolygonOf(item), PitchOf(action), FrontEdge(item)));
}

const std::array<Parameter, 2> kParameters = {PitchKindParameter(), PitchParameter(30)};

}  // namespace

constinit const Operation kRoofPyramid = {
    .name = "roofPyramid",
    .word = "RoofPyramid",
    .doc =
        "Builds a pyramid over a planar shape; over one that no single point sees all of, a hip "
        "roof. The angle is that of the front.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kVolume),
    .in_place = false,
    .apply = ApplyRoofPyramid,
};

}  // namespace parti::grammar
