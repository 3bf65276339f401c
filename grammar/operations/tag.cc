// tag("name"): marks a shape for queries. The tree keeps the tag; the item stays as it is.
#include <array>

#include "grammar/operations/row_parts.h"

namespace parti::grammar {
namespace {

const std::array<Parameter, 1> kParameters = {{{
    .name = "tag",
    .kind = ParameterKind::kText,
    .default_value = std::string("tag"),
    .doc = "what queries find as #tag",
}}};

}  // namespace

constinit const Operation kTag = {
    .name = "tag",
    .word = "Tag",
    .doc = "Marks a shape, so that queries find it as #tag.",
    .source = "Jesus 2018, 5.2",
    .parameters = kParameters,
    .takes = kAllItemTypes,
    .gives = kAllItemTypes,
    .in_place = true,
    .apply = Unchanged,
};

}  // namespace parti::grammar
