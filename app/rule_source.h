// All that a model by rules is derived from, besides its lots, as a value: texts, settings, layers.
// What a document keeps, so that it derives again wherever it is opened.
// Reading the texts is grammar/rules/rule_text.h's; trees on top of the rules are the model's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "grammar/rules/layer_edits.h"
#include "grammar/rules/rule_settings.h"

namespace parti::app {

/// A value.
struct RuleSource {
  std::vector<grammar::RuleFile> files;  ///< the one that was asked for, then its imports
  std::string style;
  bool skip_unknown = false;
  grammar::LayerEdits layers;
  grammar::RuleSettings settings;
};

using ParsedRules = tl::expected<grammar::RuleSet, std::vector<Error>>;

/// Reads a file and what it imports, beside the file that imports it or in the folders above
/// (grammar::PathsFor); source->files become all of them. The settings are checked when a lot is
/// derived. errors  kFile;  those of grammar::ParseRules and WithLayers, all of them.
ParsedRules ReadRules(const std::string& path, RuleSource* source);

/// The rules of a source that was read before: no file is looked at.
/// errors  as ReadRules'.
ParsedRules RulesOf(const RuleSource& source);

/// The same with the settings that a text can hold put into it: attributes' values as theirs, the
/// start as @StartRule. What it can't hold, the seed and limits, is left out.
/// errors  as ReadRules', and those of grammar::AttributeValue.
ParsedRules RulesToWrite(const RuleSource& source);

/// {"off":["Facade.door"],"rules":[["Facade.door","Gate"]],"order":[["Facade",["door","floors"]]]},
/// on one line; what is empty is left out.
std::string TextOf(const grammar::LayerEdits& layers);
/// errors  kBadText  also what else stands there. Property: (1) LayerEditsFrom(TextOf(l)) is l.
Result<grammar::LayerEdits> LayerEditsFrom(std::string_view text);

/// {"files":[{"name","text"}],"start",…}; what has its usual value is left out.
std::string TextOf(const RuleSource& source);
/// errors  kBadText. Property: (1) RuleSourceFrom(TextOf(s)) is s.
Result<RuleSource> RuleSourceFrom(std::string_view text);

}  // namespace parti::app
