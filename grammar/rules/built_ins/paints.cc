// geometry.du, geometry.uMin, material.opacity …: what a shape wears, and how images run over it.
#include "grammar/color_text.h"
#include "grammar/rules/built_ins/tables.h"
#include "grammar/texture_extent.h"

namespace parti::grammar::built_ins {
namespace {

constexpr std::array<std::string_view, 2> kSpaces = {"unitSpace", "uvSpace"};
constexpr std::array<std::optional<ValueType>, 2> kSetAndSpace = {kNumber, kText};

Box2 ExtentOf(const Item& item) { return TextureExtent(item, TextureMapOf(item)); }

/// From the least to the largest coordinate: in images, or along the shape in metres.
template <int kAxis>
Value Run(Values values, const Situation& situation) {
  const TextureMap map = TextureMapOf(*situation.item);
  const Box2 box = TextureExtent(*situation.item, map);
  const double extent = box.high[kAxis] - box.low[kAxis];
  if (values.size() > 1 && TextOf(values[1]) == kSpaces[1]) return extent;
  const double rate_1_m = glm::length(kAxis == 0 ? map.u : map.v);
  return rate_1_m > 0 ? extent / rate_1_m : 0.0;
}

template <int kAxis, bool kHigh>
Value Bound(Values, const Situation& situation) {
  const Box2 box = ExtentOf(*situation.item);
  return kHigh ? box.high[kAxis] : box.low[kAxis];
}

const Material* MaterialOf(const Situation& situation) {
  const Item& item = *situation.item;
  return item.paint && item.paint->material ? item.paint->material.get() : nullptr;
}

template <int kShift>
Value ColorPart(Values, const Situation& situation) {
  uint32_t rgb = situation.item->color_rgb;
  if (rgb == 0 && MaterialOf(situation) != nullptr) rgb = MaterialOf(situation)->color_rgb;
  if (rgb == 0) return 1.0;
  return static_cast<double>(rgb >> kShift & 0xff) / 255;
}

template <double Material::*kNumberOf>
Value NumberOfMaterial(Values, const Situation& situation) {
  const Material* material = MaterialOf(situation);
  return material != nullptr ? material->*kNumberOf : Material().*kNumberOf;
}

constexpr BuiltIn kRows[] = {
    {"geometry.du", kSetAndSpace, kNumber,
     "how far the image's u runs over the shape: unitSpace, in metres; uvSpace, in images", Run<0>,
     kSpaces},
    {"geometry.dv", kSetAndSpace, kNumber, "the same for v", Run<1>, kSpaces},
    {"geometry.uMin", {}, kNumber, "the least texture coordinate u", Bound<0, false>},
    {"geometry.uMax", {}, kNumber, "the largest", Bound<0, true>},
    {"geometry.vMin", {}, kNumber, "the least v", Bound<1, false>},
    {"geometry.vMax", {}, kNumber, "the largest", Bound<1, true>},
    {"material.color.r",
     {},
     kNumber,
     "the red of its color, 0 to 1; white without one",
     ColorPart<16>},
    {"material.color.g", {}, kNumber, "the green", ColorPart<8>},
    {"material.color.b", {}, kNumber, "the blue", ColorPart<0>},
    {"material.opacity", {}, kNumber, "0: clear, 1: opaque", NumberOfMaterial<&Material::opacity>},
    {"material.metallic",
     {},
     kNumber,
     "0: not a metal, 1: bare metal",
     NumberOfMaterial<&Material::metallic>},
    {"material.roughness",
     {},
     kNumber,
     "0: a mirror, 1: chalk",
     NumberOfMaterial<&Material::roughness>},
};

}  // namespace

std::span<const BuiltIn> Paints() { return kRows; }

}  // namespace parti::grammar::built_ins
