// report("key", value): a value for the tables that whoever derives makes of all of them.
// Keeping it is rules/rule_notes.h's, adding up rules/report_table.h's: the item stays as it is.
#include <array>

#include "grammar/operations/row_parts.h"

namespace parti::grammar {
namespace {

const std::array<Parameter, 2> kParameters = {{
    {
        .name = "key",
        .kind = ParameterKind::kText,
        .default_value = std::string("report"),
        .doc = "what the value belongs to; dots group keys: \"windows.open\"",
    },
    {
        .name = "value",
        .kind = ParameterKind::kValue,
        .default_value = 1.0,
        .doc = "numbers are added up, texts and true or false are counted",
    },
}};

}  // namespace

constinit const Operation kReport = {
    .name = "report",
    .word = "Report",
    .doc =
        "Adds a value to those of its key, once wherever it runs, also where the shape comes to "
        "nothing. `parti derive --reports FILE` writes what they come to.",
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
