#include "grammar/rules/rule_argument.h"

#include "grammar/rules/conversions.h"

namespace parti::grammar {
namespace {

Argument AxisFrom(const std::string& name, const Argument& otherwise) {
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    if (NameOf(axis) == name) return axis;
  }
  return otherwise;
}

}  // namespace

Argument ArgumentFrom(const Parameter& parameter, const RuleArgument& argument,
                      const Value& value) {
  switch (parameter.kind) {
    case ParameterKind::kLength:
    case ParameterKind::kAngle:
    case ParameterKind::kFactor:
      return NumberOf(value);
    case ParameterKind::kAxis:
      return AxisFrom(TextOf(value), parameter.default_value);
    case ParameterKind::kBool:
      return TruthOf(value);
    case ParameterKind::kSize:
      return Size{argument.size, NumberOf(value)};
    case ParameterKind::kValue:
      return std::visit([](const auto& any) { return Argument(any); }, value);
    case ParameterKind::kText:
    case ParameterKind::kColor:
    case ParameterKind::kWord:
      break;
  }
  return TextOf(value);
}

}  // namespace parti::grammar
