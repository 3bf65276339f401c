// symbol("Name"): gives a shape another symbol. The tree keeps it; the item stays as it is.
#include <array>

#include "grammar/operations/row_parts.h"

namespace parti::grammar {
namespace {

const std::array<Parameter, 1> kParameters = {{{
    .name = "symbol",
    .kind = ParameterKind::kText,
    .default_value = std::string("Shape"),
    .doc = "the shape's new symbol, which queries find as .Symbol",
}}};

}  // namespace

constinit const Operation kSymbol = {
    .name = "symbol",
    .word = "Symbol",
    .doc = "Gives a shape another symbol.",
    .source = "Jesus 2018, 5.2",
    .parameters = kParameters,
    .takes = kAllItemTypes,
    .gives = kAllItemTypes,
    .in_place = true,
    .apply = Unchanged,
};

}  // namespace parti::grammar
