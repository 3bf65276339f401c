// `parti derive RULES.cga`: what rules make of lots, written in any form, as docs/interfaces.md
// says.
#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/document.h"
#include "app/model_mesh.h"
#include "app/open_model.h"
#include "app/output.h"
#include "app/picture.h"
#include "app/report_file.h"

namespace parti::app {
namespace {

struct Options {
  ModelOptions model;
  std::vector<std::string> exports;
  std::string png;
  std::string save;
  std::string reports;
  bool stats = false;
};

double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// One state, seen as `render --view auto` shows it.
Result<void> Save(const Model& model, const std::string& path) {
  SessionRecord record;
  record.ground = model.ground;
  record.rules = model.rules;
  record.camera = AutoViewOf(model, kPictureSize_px);
  Document document;
  document.states.push_back(std::move(record));
  return SaveDocument(document, path);
}

Result<void> WriteAll(const Options& options, const OpenedModel& opened) {
  const Model& model = opened.model;
  for (const std::string& path : options.exports) {
    if (const auto done = ExportModel(model, std::nullopt, path); !done) return done;
  }
  if (!options.png.empty()) {
    SessionState state;
    state.model = model;
    state.camera = AutoViewOf(model, kPictureSize_px);
    if (const auto done = WritePicture(state, options.png); !done) return done;
  }
  if (!options.reports.empty()) {
    if (const auto done = WriteReports(opened.notes, options.reports); !done) return done;
  }
  return options.save.empty() ? Result<void>() : Save(model, options.save);
}

uint64_t PeakBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<uint64_t>(usage.ru_maxrss) * 1024;
}

struct Times {
  double derive_s = 0, normalise_s = 0, export_s = 0;
};

int PrintStats(const OpenedModel& opened, const Times& times) {
  const Model& model = opened.model;
  const uint64_t peak_bytes = PeakBytes();  // before triangles are made to be counted
  size_t shapes = 0, terminals = 0;
  std::vector<const grammar::ShapeTree*> trees;
  for (const auto& derivation : model.derived) {
    trees.push_back(&derivation->tree);
    shapes += derivation->tree.size();
    terminals += derivation->tree.Leaves().size();
  }
  nlohmann::ordered_json stats{{"shapes", shapes},
                               {"terminals", terminals},
                               {"triangles", TriangleCount(trees)},
                               {"derive_ms", 1e3 * times.derive_s},
                               {"normalise_ms", 1e3 * times.normalise_s},
                               {"export_ms", 1e3 * times.export_s},
                               {"peak_bytes", peak_bytes}};
  if (nlohmann::ordered_json reports = JsonOf(opened.notes); !reports.empty()) {
    stats["reports"] = std::move(reports);
  }
  return PrintAnswer(TextOf(stats) + '\n');
}

int Derive(const Options& options) {
  const auto fine = CheckEndings(options.exports, options.png, options.save);
  if (!fine) return Report(fine.error());
  Times times;
  std::atomic<double> normalise_s = 0;
  const double start = Now();
  const auto opened = OpenModel(options.model, {0, nullptr, Now, &normalise_s, nullptr});
  if (!opened) return ReportAll(opened.error());
  const double derived = Now();
  times.derive_s = derived - start;
  times.normalise_s = normalise_s;
  const auto done = WriteAll(options, *opened);
  times.export_s = Now() - derived;
  if (!done) return Report(done.error());
  return options.stats ? PrintStats(*opened, times) : kDone;
}

}  // namespace

void AddDeriveCommand(CLI::App& app, Run* run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("derive", "Build what rules say on lots");
  command->footer(
      "Example:\n"
      "  parti derive house.cga --start Lot --lot 'rect(12,9)' --set floors=3 --export house.glb");
  AddModelOptions(command, &options->model);
  command
      ->add_option("--export", options->exports,
                   "a file to write, by its ending: " + ExportEndings())
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--png", options->png, "a picture to write");
  command->add_option("--save", options->save, "a .parti document to write");
  command
      ->add_option("--reports", options->reports,
                   "what rules report, as a table: " + ReportEndings())
      ->check([](const std::string& path) { return ReportEndingError(path); });
  command->add_flag("--stats", options->stats, "one JSON object on standard output");
  command->callback([=] { *run = [=] { return Derive(*options); }; });
}

}  // namespace parti::app
