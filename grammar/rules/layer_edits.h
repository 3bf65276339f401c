// Layers switched off, put in another order, or given another rule from outside, by their composite
// name: "Facade.door" is the layer "door" of layers() in the rule Facade (Jesus 2018, 4.2.3). What
// layers are is layers/'s; the text of the rules stays as it is.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// A value, so that a document can keep it. Of two entries for one layer the later counts.
struct LayerEdits {
  std::vector<std::string> off;                            ///< "Facade.door"
  std::vector<std::pair<std::string, std::string>> rules;  ///< "Facade.door" gets another symbol
  /// "Facade" and names of its layers from the deepest up; those not named come after these, in
  /// their own order.
  std::vector<std::pair<std::string, std::vector<std::string>>> order;
  bool operator==(const LayerEdits&) const = default;
};

/// "Facade.door".
std::string LayerName(const std::string& rule, const std::string& layer);

/// "Facade.floors", "Facade.door" … of all rules, in the order of the text.
std::vector<std::string> LayerNames(const RuleSet& rules);

/// `known` are the LayerNames of the rules.
/// errors  kUnknownName  no rule has such a layer; the hint names one that is meant.
Result<void> CheckLayer(const std::string& name, const std::vector<std::string>& known);

/// The rules with their layers as the edits say, wherever a rule lays them out. layers() of which
/// nothing is left is left out.
/// errors  kUnknownName  no rule has such a layer (the hint names one that is meant), or no symbol
///         with that name has a rule without parameters.
Result<RuleSet> WithLayers(RuleSet rules, const LayerEdits& edits);

}  // namespace parti::grammar
