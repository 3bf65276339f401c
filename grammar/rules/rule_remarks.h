// What rules say that is allowed, and surely not meant: for who checks them (`parti check`).
// What is wrong is the checker's to tell (rule_check.h); derivation knows nothing of either.
#pragma once

#include <vector>

#include "base/error.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// No more are told.
inline constexpr size_t kMostRemarks = 50;

/// Operations that act on a shape which nothing keeps: "A --> [ B ] color(\"#f00\")", where the
/// body has made B and leaves what is in hand behind, and "[ extrude(3) ] B", whose bracket ends
/// without a symbol. Of operations in a row the first is named. Tags, names, notes (print, report)
/// and set() are never told, nor what follows NIL.
/// returns  in the order of the rules, each with its place and what to do; code kNothingMade.
std::vector<Error> RemarksOn(const RuleSet& rules);

}  // namespace parti::grammar
