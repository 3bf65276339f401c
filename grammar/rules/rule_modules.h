// A rule file, what it imports, and which declarations of theirs hold in a style.
// Not responsible for what the declarations mean (rule_check.h).
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/rules/rule_errors.h"
#include "grammar/rules/rule_syntax.h"
#include "grammar/rules/rule_text.h"

namespace parti::grammar {

/// One file in one place: a file that is imported twice is two modules.
struct RuleModule {
  WrittenRules rules;
  std::string prefix;                     ///< of its names: "" or "roof."
  const RuleModule* importer = nullptr;   ///< null: the file that was asked for
  const WrittenImport* import = nullptr;  ///< of the importer; null where that is
  uint32_t file = 0;
  std::vector<std::string> lost;  ///< "roof.": prefixes of imports that could not be read
};

/// Reads a file and all that it imports; the first is the file itself, each stands behind its
/// importer. They point at each other.
/// errors  to `errors`: those of ReadRules; kFile  a file that can't be read, or that imports
///         itself; kLimitReached.
std::deque<RuleModule> ReadModules(std::string_view text, std::string_view file,
                                   const RuleImporter& importer, RuleErrors* errors);

/// The declarations that hold in a style: the file's own in their order, each in the form that the
/// last style of the chain of bases gives it, then what the styles add. Null without such a style.
/// "" and "Default" are the file's own.
std::vector<const WrittenDeclaration*> DeclarationsIn(const WrittenRules& rules,
                                                      std::string_view style);

/// Styles whose base does not exist or that are their own base, and two of one name.
void CheckStyles(const WrittenRules& rules, RuleErrors* errors);

}  // namespace parti::grammar
