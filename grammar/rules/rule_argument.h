// What an operation of a rule is told, as the operation table wants it.
// Whether it is within the row's range is operation.h's Check.
#pragma once

#include "grammar/operation.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// The value of a rule's argument as an argument of this parameter; a value of another type is
/// turned into it (conversions.h), an axis that is none stays the parameter's default.
Argument ArgumentFrom(const Parameter& parameter, const RuleArgument& argument, const Value& value);

}  // namespace parti::grammar
