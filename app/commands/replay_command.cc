// `parti replay DRAWING`: plays a recorded drawing through the whole pipeline, offscreen.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/commands/commands.h"
#include "app/document.h"
#include "app/output.h"
#include "app/picture.h"
#include "app/replay.h"
#include "base/json.h"
#include "base/text_file.h"

namespace parti::app {
namespace {

struct Options {
  std::string drawing;
  std::string png, save, frames;
  std::vector<std::string> exports;
  bool json = false;
};

size_t CountNodes(const std::vector<grammar::SelectionActionNode>& nodes) {
  size_t count = nodes.size();
  for (const auto& node : nodes) count += CountNodes(node.children);
  return count;
}

Json StepsOf(const SessionState& state) {
  Json steps = Json::array();
  for (const auto& step : state.steps) {
    steps.push_back({{"strokes", step->strokes},
                     {"target", step->target},
                     {"operations", step->ranked},
                     {"chosen", step->chosen}});
  }
  return steps;
}

Json Summary(const Session& session, const ReplayReport& report) {
  const Model& model = session.state().model;
  size_t nodes = 0, shapes = 0;
  for (const auto& tree : model.trees()) nodes += CountNodes(tree.nodes);
  for (const auto& derivation : model.derived) shapes += derivation->tree.size();
  Json unread = Json::array();
  for (const Error& error : report.unread) unread.push_back(error.message);
  return {{"strokes", report.strokes},
          {"segments", report.segments},
          {"nodes", nodes},
          {"shapes", shapes},
          {"terminals", VisibleShapes(model).size()},
          {"unread", unread},
          {"steps", StepsOf(session.state())}};
}

/// Writes every output that was asked for; a failing one does not keep the others from being made.
int WriteOutputs(const Options& options, const Session& session) {
  int status = kDone;
  const auto note = [&](const Result<void>& done) {
    if (!done) status = Report(done.error());
  };
  if (!options.png.empty()) note(WritePicture(session.state(), options.png));
  for (const std::string& path : options.exports)
    note(ExportModel(session.state().model, session.state().camera, path));
  if (!options.save.empty()) note(SaveDocument(DocumentOf(session), options.save));
  return status;
}

int Replay(const Options& options) {
  const auto fine = CheckEndings(options.exports, options.png, options.save);
  if (!fine) return Report(fine.error());
  const auto text = ReadFile(options.drawing);
  if (!text) return Report(text.error());
  const input::DrawingReading reading = input::ReadDrawing(*text, options.drawing);

  Session session({.keep_steps = true});
  ReplayReport report;
  std::unique_ptr<FrameWriter> frames;
  if (!options.frames.empty()) {
    frames = std::make_unique<FrameWriter>(options.frames);
    report.before_command = [&](const Command& c) { return frames->BeforeCommand(session, c); };
  }
  int status = kDone;
  if (const auto played = Replay(reading.drawing, &session, &report); !played) {
    status = Report(played.error());
  }
  if (frames) {
    if (const auto done = frames->Finish(session); !done) status = Report(done.error());
  }
  for (const Error& error : report.unread) Report(error);
  // What came before the damage is played and written all the same; the exit status tells.
  if (reading.damage) status = Report(*reading.damage);
  if (session.state().model.lots().empty()) {
    return Report({ErrorCode::kNothingMade, fmt::format("{} builds nothing", options.drawing),
                   "a drawing begins with a lot: after 0: lot rect(20,14)"});
  }
  if (WriteOutputs(options, session) != kDone) status = kFailed;
  if (options.json && PrintAnswer(Summary(session, report).dump() + '\n') != kDone)
    status = kFailed;
  return status;
}

}  // namespace

void AddReplayCommand(CLI::App& app, Run* run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("replay", "Play a recorded drawing, offscreen");
  command->footer(
      "Example:\n  parti replay assets/drawings/house.pen --png house.png --save house.parti");
  command->add_option("DRAWING", options->drawing, "a .pen file, or - for standard input")
      ->required();
  command->add_option("--png", options->png, "write a picture of the building");
  command->add_option("--export", options->exports,
                      "write the model, by the ending: " + ExportEndings());
  command->add_option("--save", options->save, "write the document (.parti)");
  command->add_option("--frames", options->frames,
                      "write a picture of each sketch and of what it became into this folder");
  command->add_flag("--json", options->json, "print what was read and built as one JSON object");
  command->callback([options, run] { *run = [options] { return Replay(*options); }; });
}

}  // namespace parti::app
