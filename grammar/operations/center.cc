// center(axes): the middle of a shape led back to where it was before t, r and s.
#include <array>

#include "grammar/item_place.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyCenter(const Item& item, const Action& action) {
  if (!item.anchor) return std::vector<Product>{{item, -1}};
  const auto& axes = std::get<std::string>(action.arguments[0]);
  Scope named = NamedScope(item);
  const Vec3 way = *item.anchor - named.ToWorld(named.size * 0.5);
  for (const char axis : axes) {
    const Vec3& direction = named.axis(axis - 'x');
    named.origin += direction * glm::dot(way, direction);
  }
  return std::vector<Product>{{Placed(item, named), -1}};
}

constexpr std::array<std::string_view, 7> kAxes = {"x", "y", "z", "xy", "xz", "yz", "xyz"};

const std::array<Parameter, 1> kParameters = {{{
    .name = "axes",
    .kind = ParameterKind::kWord,
    .default_value = std::string("xyz"),
    .doc = "of the scope, along which it moves",
    .words = kAxes,
}}};

}  // namespace

constinit const Operation kCenter = {
    .name = "center",
    .word = "Center",
    .doc = "Moves a shape so that its middle is where it was before t, r and s.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kMovable,
    .gives = kMovable,
    .in_place = true,
    .apply = ApplyCenter,
};

}  // namespace parti::grammar
