// What names, types and operations of written rules mean: syntax to a RuleSet.
// Responsible neither for reading text (rule_syntax.h) nor for other files (rule_modules.h).
#pragma once

#include <deque>
#include <string_view>

#include "grammar/rules/rule_errors.h"
#include "grammar/rules/rule_modules.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// The declarations of all modules that hold in a style of the first (the others have their
/// imports' styles), resolved: attributes, functions and rules of the first module come first.
/// Imported attributes take the value of the importing file's attribute of the same name, or what
/// the import says (CGA). Files, imports, styles and trees are the caller's to add.
///
/// Types are inferred: walking all declarations until nothing new is learnt (at most kMostPasses
/// times), first from how parameters are used, then from what they are called with; then once more
/// to report. What nothing is known of is a number.
/// errors  to `errors`: kUnknownName, kBadArguments, kBadNumber, kBadText  a name given twice, a
///         value of another type, an attribute whose value needs itself.
RuleSet CheckRules(const std::deque<RuleModule>& modules, std::string_view style,
                   RuleErrors* errors);

inline constexpr int kMostPasses = 16;

}  // namespace parti::grammar
