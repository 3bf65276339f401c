#include "app/open_model.h"

#include <fmt/format.h>

#include "app/commands/commands.h"
#include "app/document.h"
#include "app/model_file.h"

namespace parti::app {
namespace {

using Failed = tl::unexpected<std::vector<Error>>;

tl::expected<OpenedModel, std::vector<Error>> FromDocument(const std::string& path) {
  const auto document = OpenDocument(path);
  if (!document) return Failed({document.error()});
  const SessionRecord& present = PresentOf(*document);
  auto model = Derived(present.ground, present.rules, nullptr, grammar::Unfit::kSkip);
  if (!model) return Failed({model.error()});
  return OpenedModel{std::move(*model), present.camera};
}

}  // namespace

void AddModelOptions(CLI::App* command, ModelOptions* options) {
  command->add_option("FILE", options->file, "a .parti document, or a .cga text")->required();
  command->add_option(
      "--lot", options->lot,
      fmt::format("for a text ({}): rect(WIDTH,DEPTH), poly(x,z x,z …), or a GeoJSON "
                  "(in metres), CityJSON or rings JSONL file",
                  kUsualLot));
}

tl::expected<OpenedModel, std::vector<Error>> OpenModel(const ModelOptions& options) {
  if (LooksLikeDocument(options.file)) {
    if (!options.lot.empty()) {
      return Failed({Error{ErrorCode::kBadArguments, "a document has its own lots",
                           "leave --lot out, or give a .cga text"}});
    }
    return FromDocument(options.file);
  }
  auto file =
      options.lot.empty() ? ReadModelFile(options.file) : ReadModelFile(options.file, options.lot);
  if (!file) return Failed(std::move(file.error()));
  auto model = BuiltOn(std::move(file->lots), std::move(file->trees));
  if (!model) return Failed({model.error()});
  return OpenedModel{std::move(*model), std::nullopt};
}

int ReportAll(const std::vector<Error>& errors) {
  for (const Error& error : errors) Report(error);
  return kFailed;
}

}  // namespace parti::app
