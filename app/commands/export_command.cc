// `parti export FILE OUT`: converts a document or a text into a model, a picture or rules.
#include <memory>

#include "app/commands/commands.h"
#include "app/open_model.h"
#include "app/output.h"

namespace parti::app {
namespace {

int Export(const ModelOptions& options, const std::string& out) {
  if (const auto known = CheckExportEnding(out); !known) return Report(known.error());
  const auto opened = OpenModel(options);
  if (!opened) return ReportAll(opened.error());
  const auto done = ExportModel(opened->model, opened->view, out);
  return done ? kDone : Report(done.error());
}

}  // namespace

void AddExportCommand(CLI::App& app, Run* run) {
  auto options = std::make_shared<ModelOptions>();
  auto out = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("export", "Convert to a model, a picture or rules");
  command->footer("Example:\n  parti export house.parti house.glb");
  AddModelOptions(command, options.get());
  command->add_option("OUT", *out, "the file to write, by its ending: " + ExportEndings())
      ->required();
  command->callback([=] { *run = [=] { return Export(*options, *out); }; });
}

}  // namespace parti::app
