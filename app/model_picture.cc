#include "app/model_picture.h"

#include "app/picking.h"

namespace parti::app {

Result<std::unique_ptr<ModelPicture>> ModelPicture::Create(
    std::unique_ptr<render::GlContext> shared) {
  auto picture = std::unique_ptr<ModelPicture>(new ModelPicture);
  auto painter = render::ScenePainter::Start(std::move(shared),
                                             [made = picture.get()] { made->painted_.Wake(); });
  if (!painter) return Fail(painter);
  picture->painter_ = std::move(*painter);
  return picture;
}

void ModelPicture::SetState(std::shared_ptr<const SessionState> state) {
  if (asked_ && SameModel(*asked_, *state)) return;
  asked_ = std::move(state);
  preparer_.Ask(asked_);
}

void ModelPicture::Look(const Camera& camera, bool moving) {
  if (camera == camera_ && moving == moving_) return;
  camera_ = camera;
  moving_ = moving;
  Ask();
}

void ModelPicture::Ask() {
  if (prepared_.scene) painter_->Request({prepared_.scene, camera_, moving_});
}

void ModelPicture::Update(render::Canvas* canvas) {
  painted_.Clear();
  if (preparer_.ready().Clear()) {
    const auto newest = preparer_.newest();
    if (newest && newest->scene != prepared_.scene) {
      prepared_ = *newest;
      Ask();
    }
  }
  const auto painted = painter_->newest();
  if (!painted) return;
  if (painted->scene == prepared_.scene) shown_ = prepared_;
  if (painted == painted_picture_ && camera_ == shown_for_) return;
  painted_picture_ = painted;
  shown_for_ = camera_;
  canvas->SetPicture(render::ToCanvas(painted, camera_));
}

std::optional<ShapeRef> ModelPicture::ShapeUnder(const Vec2& px) const {
  if (!painted_picture_ || painted_picture_->scene != shown_.scene || !shown_.state) {
    return std::nullopt;
  }
  return RefOfId(shown_.state->model, painted_picture_->IdAt(px));
}

std::vector<int> ModelPicture::fds() const { return {preparer_.ready().fd(), painted_.fd()}; }

bool ModelPicture::busy() const {
  const bool is_old = asked_ && (!prepared_.state || !SameModel(*prepared_.state, *asked_));
  const bool has_all = painted_picture_ && painted_picture_->scene == prepared_.scene &&
                       painted_picture_->camera == camera_ && !painted_picture_->coarse;
  return is_old || painter_->busy() || (prepared_.scene && !has_all);
}

}  // namespace parti::app
