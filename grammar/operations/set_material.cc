// setMaterial(property, value): CGA's material attributes that exports keep.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "grammar/color_text.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

constexpr std::array<std::string_view, 6> kProperties = {"opacity", "metallic", "roughness",
                                                         "color.r", "color.g",  "color.b"};

/// One of the three bytes of 0xRRGGBB set to a part of 255; white where there was no color.
uint32_t WithPart(uint32_t rgb, int shift, double value) {
  const auto byte = static_cast<uint32_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255));
  return ColorOrNone(((rgb == 0 ? 0xffffffu : rgb) & ~(0xffu << shift)) | byte << shift);
}

Result<std::vector<Product>> ApplySetMaterial(const Item& item, const Action& action) {
  const auto& property = std::get<std::string>(action.arguments[0]);
  const double value = std::get<double>(action.arguments[1]);
  Item changed = item;
  if (property.starts_with("color.")) {
    const int shift = property[6] == 'r' ? 16 : property[6] == 'g' ? 8 : 0;
    changed.color_rgb = WithPart(item.color_rgb, shift, value);
    return std::vector<Product>{{std::move(changed), -1}};
  }
  Paint paint = item.paint ? *item.paint : Paint();
  Material material = paint.material ? *paint.material : Material();
  double* const number = property == "opacity"    ? &material.opacity
                         : property == "metallic" ? &material.metallic
                                                  : &material.roughness;
  *number = std::clamp(value, 0.0, 1.0);
  paint.material = std::make_shared<const Material>(std::move(material));
  changed.paint = std::make_shared<const Paint>(std::move(paint));
  return std::vector<Product>{{std::move(changed), -1}};
}

const std::array<Parameter, 2> kParameters = {Parameter{.name = "property",
                                                        .kind = ParameterKind::kWord,
                                                        .default_value = std::string("opacity"),
                                                        .doc = "which of a material's numbers",
                                                        .words = kProperties},
                                              Parameter{.name = "value",
                                                        .kind = ParameterKind::kFactor,
                                                        .low = 0,
                                                        .high = 1,
                                                        .default_value = 1.0,
                                                        .doc = "from none to all of it"}};

}  // namespace

constinit const Operation kSetMaterial = {
    .name = "setMaterial",
    .word = "SetMaterial",
    .doc =
        "Sets a number of the material of a shape and of all that is made from it; CGA writes "
        "set(material.opacity, 0.5).",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .apply = ApplySetMaterial,
};

}  // namespace parti::grammar
