// Bodies of rules as text, broken over lines where they are long.
// Declarations are rule_writer.cc's, values rule_expression_text.h's.
#pragma once

#include <cstddef>
#include <string>

#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// The body of a rule. Its first line starts at `column`; further lines are indented by `indent`
/// blanks. Starts with a line feed where cases are broken over lines; "" for an empty one.
std::string BodyText(const RuleSet& rules, const Rule& rule, size_t column, size_t indent);

}  // namespace parti::grammar
