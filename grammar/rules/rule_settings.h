// What a derivation by rules is told besides the rules: where it starts, attributes, seed, limits.
// Layers are layer_edits.h's; lots and threads are the caller's.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "grammar/rules/rule_set.h"

namespace parti::grammar {

class NoteBook;

/// Where a derivation gives up with an error instead of filling the memory or running for ever.
struct RuleLimits {
  uint32_t depth = 250;         ///< levels of rules, one below the other; the usual ones need 20
  uint32_t shapes = 2'000'000;  ///< of one lot: about 600 MB
  uint64_t steps = 0;           ///< statements and expressions of one lot; 0: any number
  double seconds = 0;           ///< for each lot; 0: as long as it takes
  bool operator==(const RuleLimits&) const = default;
};

/// A value, so that a document can keep it.
struct RuleSettings {
  std::string start;  ///< the lot's symbol; "": the rule with @StartRule, else "Lot"
  /// Values of attributes as text, "12" or "true", in place of those in the rules; the last counts.
  std::vector<std::pair<std::string, std::string>> attributes;
  uint64_t seed = 0;
  RuleLimits limits;
  bool operator==(const RuleSettings&) const = default;
};

/// The start symbol that settings and rules agree on.
/// errors  kUnknownName  no rule without parameters has it; the hint names one that is meant.
Result<std::string> StartSymbol(const RuleSet& rules, const RuleSettings& settings);

/// A value for an attribute, of its type: which one it is, and its value.
struct GivenValue {
  size_t index = 0;  ///< of RuleSet::attributes
  Value value;
};
/// errors  kUnknownName  no such attribute;  kBadArguments  a constant, or a value of another type.
Result<GivenValue> AttributeValue(const RuleSet& rules, const std::string& name,
                                  const std::string& text);

/// Whether a person may give the attribute this value: within @Range, unless that says
/// restricted=false, and one of @Enum. What set() and styles in rules give is not asked.
/// errors  kBadNumber, kBadArguments  naming the attribute and what it may be.
Result<void> CheckAllowed(const Attribute& attribute, const Value& value);

/// The values of the rule set's attributes for a lot: those of the settings, else those that are
/// given for this lot, else what their expressions give, each computed once. Draws by chance come
/// from the seed, the number of the lot and the attribute's name. What they print goes to `notes`,
/// which may be null.
/// errors  those of AttributeValue;  kLimitReached  attributes that depend on each other, or
///         functions without end.
Result<std::vector<Value>> AttributesFor(const RuleSet& rules, const RuleSettings& settings,
                                         const Item& lot, uint32_t lot_number,
                                         NoteBook* notes = nullptr,
                                         std::span<const GivenValue> given = {});

}  // namespace parti::grammar
