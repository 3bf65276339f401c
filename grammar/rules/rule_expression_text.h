// Values of rules as text, in a form that reads back as the same tree.
// Bodies are rule_body_text.h's, declarations rule_writer.cc's.
#pragma once

#include <span>
#include <string>

#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// Where a case or a chance may stand only in parentheses.
enum class Place : uint8_t { kValue, kOperand };

/// With as few parentheses as read back as the same tree.
std::string ExpressionText(const RuleSet& rules, std::span<const RuleParameter> parameters,
                           const Expression& expression, Place place);

/// "3", "true", "\"a\"".
std::string ConstantText(const Value& value);
/// "70%: "
std::string WeightText(const RuleSet& rules, std::span<const RuleParameter> parameters,
                       const Expression& weight);

}  // namespace parti::grammar
