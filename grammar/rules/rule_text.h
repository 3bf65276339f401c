// Rule files: text to a checked RuleSet and back (docs/language.md).
// Responsible neither for running rules (rule_derivation.h) nor for reading files: that is given.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// The file that `import p : "path"` in the file `importing` means, and its text. The same file has
/// the same name each time. errors  kFile  there is none.
using RuleImporter =
    std::function<Result<RuleFile>(const std::string& path, const std::string& importing)>;

/// How a text is read.
struct RuleOptions {
  RuleImporter importer = {};  ///< empty: imports are errors
  std::string style = {};      ///< "" or "Default": none
  bool skip_unknown = false;   ///< operations and annotations that we don't have become nothing
  std::string start = {};      ///< a symbol that must have a rule without parameters; "" none
};

/// Files that a text may import, in all and one by the other.
inline constexpr size_t kMostImports = 200;
inline constexpr int kDeepestImport = 16;
/// Reads and checks a rule file and what it imports: names, types, arguments against the operation
/// table, in the file itself and in each of its styles.
/// returns  the declarations of the style that was asked for; `skipped` of it tells what was
///          unknown and became nothing.
/// errors  all at once, sorted by place, the first 50: kBadText, kUnknownName (with "did you
///         mean"), kBadArguments, kBadNumber, kFile, kLimitReached (nesting, size, imports). What
///         is unknown is told once with the count of its places.
/// cost  linear in the texts, times their styles; bounded in depth whatever the text.
tl::expected<RuleSet, std::vector<Error>> ParseRules(std::string_view text, std::string_view file,
                                                     const RuleOptions& options = {});

/// The first file of the set as CGA, with the values of the style that was asked for; imports are
/// written as such. Property: ParseRules reads it back as an equal value, given the same importer.
std::string TextOf(const RuleSet& rules);
/// "case h > 20: 2 else: h * 3", in a rule or function that has these parameters.
std::string TextOf(const RuleSet& rules, const Expression& expression,
                   std::span<const RuleParameter> parameters = {});

/// What `version` in rules written for CityEngine says: the first that has all that we write.
inline constexpr std::string_view kCgaVersion = "2019.0";

}  // namespace parti::grammar
