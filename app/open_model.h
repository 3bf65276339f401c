// FILE of the command line: a document, or a text of rules with its lot, made into a model.
// Not responsible for reading either (document.h, model_file.h).
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/session_state.h"

namespace parti::app {

/// What follows FILE on every command that takes one.
struct ModelOptions {
  std::string file;
  std::string lot;  ///< LOT of docs/interfaces.md; "" for the usual one
};

/// Adds FILE and --lot to a command.
void AddModelOptions(CLI::App* command, ModelOptions* options);

/// A model, and how it was last looked at.
struct OpenedModel {
  Model model;
  std::optional<Camera> view;  ///< that a document was saved with
};

/// errors  those of OpenDocument, ReadModelFile and BuiltOn, all that were found;  kBadArguments  a
///         lot given for a document, which has its own.
tl::expected<OpenedModel, std::vector<Error>> OpenModel(const ModelOptions& options);

/// Prints each; returns kFailed.
int ReportAll(const std::vector<Error>& errors);

}  // namespace parti::app
