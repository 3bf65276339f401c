// str(3), float("3.5"), bool("true"): from one type to another.
#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

constexpr std::array<std::optional<ValueType>, 1> kOne = {std::nullopt};

Value ToNumber(Values values, const Situation&) { return NumberOf(values[0]); }

constexpr BuiltIn kRows[] = {
    {"float", kOne, kNumber, "the number that a text begins with; 1 for true", ToNumber},
    {"num", kOne, kNumber, "the same as float", ToNumber},
    {"str", kOne, kText, "a number or truth as text",
     [](Values values, const Situation&) -> Value { return TextOf(values[0]); }},
    {"bool", kOne, kBool, "false for 0, \"\" and \"false\"",
     [](Values values, const Situation&) -> Value { return TruthOf(values[0]); }},
    {"print",
     kOne,
     kNumber,
     "what it is given, which is printed as the operation print does",
     [](Values values, const Situation&) -> Value { return values[0]; },
     {},
     /*prints=*/true},
};

}  // namespace

std::span<const BuiltIn> Conversions() { return kRows; }

}  // namespace parti::grammar::built_ins
