// FILE of the command line: a document, or a text of rules with its lots, made into a model.
// Not responsible for reading either (document.h, rule_source.h).
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/session_state.h"
#include "grammar/rules/rule_notes.h"

namespace parti::app {

/// What a text is derived on when no lot is given.
inline constexpr std::string_view kUsualLot = "rect(20,20)";

/// What follows FILE on every command that takes one: a text's lots, start, attributes, layers.
struct ModelOptions {
  std::string file;
  std::string lot;  ///< LOT of docs/interfaces.md; "" for the usual one
  std::string start;
  std::string style;
  std::string layers_off;         ///< "Facade.door,Facade.floors"
  std::vector<std::string> sets;  ///< "NAME=VALUE"
  uint64_t seed = 0;
  bool skip_unknown = false;
  bool skip_bad_lots = false;
  int threads = 0;
  grammar::RuleLimits limits;
};

/// Adds FILE and its options to a command.
void AddModelOptions(CLI::App* command, ModelOptions* options);

/// A model, and how it was last looked at.
struct OpenedModel {
  Model model;
  std::optional<Camera> view;            ///< that a document was saved with
  std::vector<grammar::LotNotes> notes;  ///< what rules report and print, one for each lot
};

/// What --skip-unknown and --skip-bad-lots left out is said on stderr, and then what rules print,
/// also where they fail after it. errors  those of OpenDocument, ReadRules, UseLots and Derived,
/// all that were found;
///         kBadArguments  options of a text given for a document, which has its own; a --set that
///         is not NAME=VALUE.
tl::expected<OpenedModel, std::vector<Error>> OpenModel(const ModelOptions& options,
                                                        const grammar::RuleThreads& threads = {});

/// Says on stderr what was unknown and became nothing.
void ReportSkipped(const grammar::RuleSet& rules);

/// Prints each; returns kFailed.
int ReportAll(const std::vector<Error>& errors);

}  // namespace parti::app
