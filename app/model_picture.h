// The picture of the model behind ink and panels: made beside the thread that draws, shown when it
// is there, and asked which shape lies under a pixel.
// Joins the preparer of scenes (scene_preparer.h) and the painter (render/scene_painter.h).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/scene_preparer.h"
#include "base/camera.h"
#include "render/canvas.h"
#include "render/gl_context.h"
#include "render/scene_painter.h"

namespace parti::app {

/// Used by the thread that draws.
class ModelPicture {
 public:
  /// `shared` shares textures with the canvas's context. errors  kGraphics.
  static Result<std::unique_ptr<ModelPicture>> Create(std::unique_ptr<render::GlContext> shared);

  /// The model of this state is to be seen; nothing is done where it is already.
  void SetState(std::shared_ptr<const SessionState> state);
  /// From here; coarsely while the camera moves.
  void Look(const Camera& camera, bool moving);

  /// Shows on the canvas what has been painted since, or the last picture as the camera would see
  /// it. Call it when an fd is readable, and after Look. The canvas's context is current.
  void Update(render::Canvas* canvas);

  /// The shape whose picture is at a pixel of the camera looked through, in `shown_state()`.
  std::optional<ShapeRef> ShapeUnder(const Vec2& px) const;
  /// The state whose model the newest picture shows; null before the first.
  const std::shared_ptr<const SessionState>& shown_state() const { return shown_.state; }

  /// Of the newest model that a scene has been made of.
  const render::Bounds& bounds() const { return prepared_.bounds; }

  /// Readable when Update has something to do.
  std::vector<int> fds() const;
  /// Whether a picture of what was asked for last is still to come.
  bool busy() const;

 private:
  ModelPicture() = default;
  void Ask();

  ScenePreparer preparer_;
  WakeFd painted_;  // woken by each picture
  std::unique_ptr<render::ScenePainter> painter_;
  std::shared_ptr<const SessionState> asked_;
  PreparedScene prepared_;  // the newest, asked of the painter
  PreparedScene shown_;     // whose picture is on the canvas
  std::shared_ptr<const render::PaintedPicture> painted_picture_;
  Camera camera_, shown_for_;
  bool moving_ = false;
};

}  // namespace parti::app
