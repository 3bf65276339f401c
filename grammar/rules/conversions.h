// Values of the rule language as numbers, truths and texts: CGA's float(), bool() and str().
// Which type an expression has is the checker's to know.
#pragma once

#include <cstddef>
#include <string>

#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// Texts that rules make are no longer than this, in bytes: doubled forty times, one would fill any
/// memory.
inline constexpr size_t kLongestText = 1 << 20;

/// As str() and + write it: numbers in the shortest form that reads back, true, false, texts as
/// they are.
std::string TextOf(const Value& value);
/// true is 1; a text is the number that it begins with, 0 without one.
double NumberOf(const Value& value);
/// 0, "" and "false" are false; everything else is true.
bool TruthOf(const Value& value);

}  // namespace parti::grammar
