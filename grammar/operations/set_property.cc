// set_property("fixed_geometry", false): whether a 2D shape that others cover is dropped or cut.
#include <array>
#include <string_view>

#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplySetProperty(const Item& item, const Action& action) {
  Item changed = item;
  changed.fixed_geometry = std::get<bool>(action.arguments[1]);
  return std::vector<Product>{{std::move(changed), -1}};
}

constexpr std::array<std::string_view, 1> kNames = {"fixed_geometry"};

const std::array<Parameter, 2> kParameters = {{
    {
        .name = "name",
        .kind = ParameterKind::kText,
        .default_value = std::string(kNames[0]),
        .doc = "the only property there is",
        .words = kNames,
    },
    {
        .name = "value",
        .kind = ParameterKind::kBool,
        .default_value = false,
        .doc = "true: a 2D shape that another one covers in part is dropped; false: what is left "
               "of it stays",
    },
}};

}  // namespace

constinit const Operation kSetProperty = {
    .name = "set_property",
    .word = "SetProperty",
    .doc =
        "Sets a property of a shape, and of the 2D shapes that are made from it afterwards. Fixed "
        "geometry is what they begin with.",
    .source = "Jesus 2018, (4.14), Listing 4.5; errata 6",
    .parameters = kParameters,
    .takes = kAllItemTypes,
    .gives = kAllItemTypes,
    .in_place = true,
    .sampled = false,
    .apply = ApplySetProperty,
};

}  // namespace parti::grammar
