#include "app/picture.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "app/auto_view.h"
#include "app/meaning.h"
#include "app/scene_from_model.h"

namespace parti::app {
namespace {

Result<render::Image> DrawnBy(render::OffscreenRenderer* renderer, const SessionState& state) {
  if (state.model.lots().empty()) {
    return Fail(ErrorCode::kNothingMade, "there is nothing to show yet", "begin with a lot");
  }
  return renderer->Draw(SceneOf(state), state.camera);
}

}  // namespace

Camera AutoViewOf(const Model& model, const Vec2& size_px) {
  render::Scene scene;
  for (const auto& derivation : model.derived) AddModel(derivation->tree, &scene);
  return AutoView(render::BoundsOf(scene, false), size_px.x, size_px.y);
}

render::Scene SceneOf(const SessionState& state) {
  render::Scene scene;
  uint32_t first_id = 1;
  for (const auto& derivation : state.model.derived) {
    AddModel(derivation->tree, &scene, first_id);
    first_id += derivation->tree.size();
  }
  // A suggestion that this item can't take after all is only left out of the picture.
  if (const auto meaning = MeaningOf(state, 0)) {
    AddLiftedLines(meaning->lines, &scene);
    AddSuggestion(meaning->edges, &scene);
  }
  for (const auto& drawn : state.sketch.strokes) {
    if (drawn->camera == state.camera) AddStroke(drawn->stroke, &scene);
  }
  return scene;
}

Result<render::Image> PictureOf(const SessionState& state) {
  auto renderer = render::OffscreenRenderer::Create();
  if (!renderer) return Fail(renderer);
  return DrawnBy(renderer->get(), state);
}

Result<void> WritePicture(const SessionState& state, const std::string& path) {
  const auto image = PictureOf(state);
  if (!image) return Fail(image);
  return render::WritePng(*image, path);
}

Result<void> FrameWriter::BeforeCommand(const Session& session, const Command& command) {
  const bool pick = std::holds_alternative<Pick>(command);
  const bool looks_elsewhere = std::holds_alternative<SetView>(command);
  if ((pick || looks_elsewhere) && made_is_due_ && session.state().sketch.strokes.empty()) {
    if (const auto done = Finish(session); !done) return done;
  }
  if (!pick) return {};
  ++picked_;
  made_is_due_ = true;
  return Write(session.state(), "sketch");
}

Result<void> FrameWriter::Finish(const Session& session) {
  if (!made_is_due_) return {};
  made_is_due_ = false;
  return Write(session.state(), "made");
}

Result<void> FrameWriter::Write(const SessionState& state, const char* what) {
  if (!renderer_) {
    std::error_code failed;
    std::filesystem::create_directories(folder_, failed);
    if (failed) {
      return Fail(ErrorCode::kFile, fmt::format("can't make {}: {}", folder_, failed.message()));
    }
    auto renderer = render::OffscreenRenderer::Create();
    if (!renderer) return Fail(renderer);
    renderer_ = std::move(*renderer);
  }
  const auto image = DrawnBy(renderer_.get(), state);
  if (!image) return Fail(image);
  return render::WritePng(*image, fmt::format("{}/{:02}-{}.png", folder_, picked_, what));
}

}  // namespace parti::app
