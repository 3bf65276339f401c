// color("#rrggbb"): the color in which a shape, and what is made from it, is drawn.
#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

/// Check has seen that the text is "#rrggbb".
Result<std::vector<Product>> ApplyColor(const Item& item, const Action& action) {
  const auto& text = std::get<std::string>(action.arguments[0]);
  Item colored = item;
  // 0 means that no color was given: black is the darkest blue there is.
  std::from_chars(text.data() + 1, text.data() + text.size(), colored.color_rgb, 16);
  colored.color_rgb = std::max(colored.color_rgb, 1u);
  return std::vector<Product>{{std::move(colored), -1}};
}

const std::array<Parameter, 1> kParameters = {{{
    .name = "color",
    .kind = ParameterKind::kColor,
    .default_value = std::string("#c8beb4"),
    .doc = "red, green and blue as hexadecimal digits, #rrggbb",
}}};

}  // namespace

constinit const Operation kColor = {
    .name = "color",
    .word = "Color",
    .doc = "Sets the color of a shape and of all that is made from it afterwards.",
    .source = "Jesus 2018, 4.2",
    .parameters = kParameters,
    .braces = Braces::kNone,
    .selectors = {},
    .takes = Types(ItemType::kVolume, ItemType::kPlanar),
    .gives = Types(ItemType::kVolume, ItemType::kPlanar),
    .in_place = true,
    .apply = ApplyColor,
};

}  // namespace parti::grammar
