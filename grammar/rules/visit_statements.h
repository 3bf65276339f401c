// Goes through all statements of a body of rules, at any depth.
// What is looked for in them is the caller's.
#pragma once

#include <functional>

#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// Calls `visit` for every statement of a body and of what it has inside, in the order of the text:
/// a statement before those in its braces, repeated groups and all alternatives included.
void VisitStatements(const Body& body, const std::function<void(const Statement&)>& visit);

}  // namespace parti::grammar
