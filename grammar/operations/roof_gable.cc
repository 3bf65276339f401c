// roofGable(angle, overhangX, overhangY, even, index): a hip roof with upright ends.
#include <array>

#include "grammar/operations/roof_parts.h"

namespace parti::grammar {
namespace {

constexpr double kNoEdge = -1;

/// The direction out of the edge of that number, counted round and round; else the shape's front.
Vec2 EaveIn(const Item& item, const Polygon& polygon, double edge) {
  if (!(edge >= 0)) return FrontIn(item);
  const size_t n = polygon.outer.size();
  const size_t i = static_cast<size_t>(edge) % n;
  const Vec2 along = polygon.outer[(i + 1) % n] - polygon.outer[i];
  return glm::normalize(Vec2(along.y, -along.x));
}

Result<std::vector<Product>> ApplyRoofGable(const Item& item, const Action& action) {
  const GableOverhang overhang{NumberAt(action, 2), NumberAt(action, 3)};
  const Polygon polygon = PolygonOf(item);
  const Vec2 eave = EaveIn(item, polygon, NumberAt(action, 5));
  return RoofOver(item, GableRoof(polygon, PitchOf(action), overhang, eave));
}

const std::array<Parameter, 6> kParameters = {
    PitchKindParameter(),
    PitchParameter(30),
    OverhangParameter("overhangX", "of the eaves, measured down the roof"),
    OverhangParameter("overhangY", "of the gables"),
    Parameter{
        .name = "even",
        .kind = ParameterKind::kBool,
        .default_value = false,
        .required = false,
        .doc = "CGA's switch to level the ridge where planes have to bend: they never do here"},
    Parameter{.name = "index",
              .kind = ParameterKind::kFactor,
              .low = kNoEdge,
              .high = 1e6,
              .default_value = kNoEdge,
              .required = false,
              .doc = "the edge under an eave where two could be, as on a square; -1: the front"}};

}  // namespace

constinit const Operation kRoofGable = {
    .name = "roofGable",
    .word = "RoofGable",
    .doc =
        "Builds a gable roof over a planar shape: a hip roof whose triangular ends stand upright.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kVolume),
    .in_place = false,
    .apply = ApplyRoofGable,
};

}  // namespace parti::grammar
