// Pictures of a session: the building, the sketch on it and what the sketch may mean.
// How scenes are made and drawn is scene_from_model.h's and render/'s.
#pragma once

#include <memory>
#include <string>

#include "app/session.h"
#include "render/offscreen.h"

namespace parti::app {

/// What a picture has where nobody asks for another size.
inline constexpr Vec2 kPictureSize_px{1600, 1000};

/// A view that shows all of a model.
Camera AutoViewOf(const Model& model, const Vec2& size_px);

/// The model, the strokes not yet picked for that were drawn in this view, their lifted lines, and
/// the wire frame of the first suggestion.
render::Scene SceneOf(const SessionState& state);

/// errors  kNothingMade  the model has no lot;  kGraphics.
Result<render::Image> PictureOf(const SessionState& state);

/// errors  those of PictureOf; kFile.
Result<void> WritePicture(const SessionState& state, const std::string& path);

/// Pictures of a replay, step by step: FOLDER/01-sketch.png before each pick, and
/// FOLDER/01-made.png before the pen or the view goes on.
class FrameWriter {
 public:
  explicit FrameWriter(std::string folder) : folder_(std::move(folder)) {}

  /// Called before each command of a replay; `session` is what it will act on.
  Result<void> BeforeCommand(const Session& session, const Command& command);
  /// Called at the end, for the last result.
  Result<void> Finish(const Session& session);

 private:
  Result<void> Write(const SessionState& state, const char* what);

  std::string folder_;
  std::unique_ptr<render::OffscreenRenderer> renderer_;
  int picked_ = 0;
  bool made_is_due_ = false;
};

}  // namespace parti::app
