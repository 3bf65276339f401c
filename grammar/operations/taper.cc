// taper(height, top): a pyramid, or one cut off.
#include <array>

#include "grammar/operations/roof_parts.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyTaper(const Item& item, const Action& action) {
  return RoofOver(item, Taper(PolygonOf(item), NumberAt(action, 0), NumberAt(action, 1)));
}

const std::array<Parameter, 2> kParameters = {
    {{.name = "height",
      .kind = ParameterKind::kLength,
      .low = -1e4,
      .high = 1e4,
      .default_value = 3.0,
      .doc = "along the outward normal; negative goes inward"},
     {.name = "top",
      .kind = ParameterKind::kFactor,
      .low = 0,
      .high = 0.999,
      .default_value = 0.0,
      .required = false,
      .doc = "how wide the top is, as a share of the shape; 0 is a point"}}};

}  // namespace

constinit const Operation kTaper = {
    .name = "taper",
    .word = "Taper",
    .doc = "Draws a planar shape out to a point over its centroid, or to a smaller top.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kVolume),
    .in_place = false,
    .sampled = false,
    .apply = ApplyTaper,
};

}  // namespace parti::grammar
