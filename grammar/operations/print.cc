// print(value): a line for whoever writes the rules.
// Keeping and showing it is rules/rule_notes.h's: the item stays as it is.
#include <array>

#include "grammar/operations/row_parts.h"

namespace parti::grammar {
namespace {

const std::array<Parameter, 1> kParameters = {{{
    .name = "value",
    .kind = ParameterKind::kValue,
    .default_value = std::string("here"),
    .doc = "what to write",
}}};

}  // namespace

constinit const Operation kPrint = {
    .name = "print",
    .word = "Print",
    .doc =
        "Writes a value to standard error, with its rule and its place in the file, in the "
        "order of the shapes; the first 1,000 of a lot.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kAllItemTypes,
    .gives = kAllItemTypes,
    .in_place = true,
    .sampled = false,
    .notes = true,
    .apply = Unchanged,
};

}  // namespace parti::grammar
