// `parti render FILE --png OUT`: a picture of a document or a text.
#include <cstdio>
#include <memory>

#include "app/commands/commands.h"
#include "app/file_ending.h"
#include "app/open_model.h"
#include "app/picture.h"

namespace parti::app {
namespace {

struct Options {
  ModelOptions model;
  std::string png;
  std::string view;
  std::string size = "1600x1000";
};

Result<Vec2> SizeFrom(const std::string& text) {
  double width = 0, height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lfx%lf%c", &width, &height, &rest) != 2) {
    return Fail(ErrorCode::kBadNumber, "'" + text + "' is not a size",
                "for example: --size 1600x1000");
  }
  return Vec2(width, height);
}

Result<Camera> CameraFor(const Options& options, const OpenedModel& opened) {
  const auto size = SizeFrom(options.size);
  if (!size) return Fail(size);
  if (!options.view.empty() && options.view != "auto" && options.view != "last") {
    return Fail(ErrorCode::kUnknownName, "there is no view '" + options.view + "'",
                opened.view ? "views are last and auto" : "the view of a text is auto");
  }
  if (options.view == "last" && !opened.view) {
    return Fail(ErrorCode::kUnknownName, "a text has no last view", "the view of a text is auto");
  }
  Camera camera =
      options.view == "auto" || !opened.view ? AutoViewOf(opened.model, *size) : *opened.view;
  camera.width_px = size->x;
  camera.height_px = size->y;
  if (const auto valid = Validate(camera); !valid) return Fail(valid);
  return camera;
}

int Render(const Options& options) {
  if (const auto fine = CheckEnding(options.png, ".png"); !fine) return Report(fine.error());
  auto opened = OpenModel(options.model);
  if (!opened) return ReportAll(opened.error());
  const auto camera = CameraFor(options, *opened);
  if (!camera) return Report(camera.error());
  SessionState state;
  state.model = std::move(opened->model);
  state.camera = *camera;
  const auto done = WritePicture(state, options.png);
  return done ? kDone : Report(done.error());
}

}  // namespace

void AddRenderCommand(CLI::App& app, Run* run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("render", "Draw a picture");
  command->footer("Example:\n  parti render house.parti --png house.png --view auto");
  AddModelOptions(command, &options->model);
  command->add_option("--png", options->png, "the picture to write")->required();
  command->add_option("--view", options->view,
                      "last: as the document was saved; auto: all of it, from the south east");
  command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels (1600x1000)");
  command->callback([=] { *run = [=] { return Render(*options); }; });
}

}  // namespace parti::app
