// color("#rrggbb"), color("firebrick"), color(r, g, b): the color of a shape and of all that is
// made from it.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "grammar/color_text.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

uint32_t Byte(const Argument& part) {
  return static_cast<uint32_t>(std::lround(std::clamp(std::get<double>(part), 0.0, 1.0) * 255));
}

WrittenColor ColorOf(const Action& action) {
  const std::vector<Argument>& parts = action.arguments;
  if (std::get<double>(parts[1]) < 0) {
    return ColorFrom(std::get<std::string>(parts[0])).value_or(WrittenColor{});
  }
  return {ColorOrNone(Byte(parts[1]) << 16 | Byte(parts[2]) << 8 | Byte(parts[3])), std::nullopt};
}

void SetOpacity(double opacity, Item* item) {
  const bool is_opaque = !item->paint || !item->paint->material;
  if (opacity >= 1 && is_opaque) return;
  Paint paint = item->paint ? *item->paint : Paint();
  Material material = paint.material ? *paint.material : Material();
  material.opacity = std::clamp(opacity, 0.0, 1.0);
  paint.material = std::make_shared<const Material>(std::move(material));
  item->paint = std::make_shared<const Paint>(std::move(paint));
}

/// Check has seen that a text is a color.
Result<std::vector<Product>> ApplyColor(const Item& item, const Action& action) {
  const WrittenColor color = ColorOf(action);
  Item colored = item;
  colored.color_rgb = color.rgb;
  const double written = std::get<double>(action.arguments[4]);
  if (color.opacity || written >= 0) SetOpacity(color.opacity.value_or(written), &colored);
  return std::vector<Product>{{std::move(colored), -1}};
}

Parameter Part(std::string_view name) {
  return {.name = name,
          .kind = ParameterKind::kFactor,
          .low = 0,
          .high = 1,
          .default_value = -1.0,
          .required = false,
          .doc = "in place of the text"};
}

const std::array<Parameter, 5> kParameters = {
    Parameter{.name = "color",
              .kind = ParameterKind::kColor,
              .default_value = std::string("#c8beb4"),
              .required = false,
              .doc = "\"#rrggbb\", with opacity \"#rrggbboo\", or a name that CSS knows"},
    Part("red"), Part("green"), Part("blue"),
    Parameter{.name = "opacity",
              .kind = ParameterKind::kFactor,
              .low = 0,
              .high = 1,
              .default_value = -1.0,
              .required = false,
              .doc = "0: clear; left out: as it was"}};

}  // namespace

constinit const Operation kColor = {
    .name = "color",
    .word = "Color",
    .doc = "Sets the color of a shape and of all that is made from it afterwards.",
    .source = "CGA; Jesus 2018, 4.2",
    .parameters = kParameters,
    .takes = kMovable,
    .gives = kMovable,
    .in_place = true,
    .apply = ApplyColor,
};

}  // namespace parti::grammar
