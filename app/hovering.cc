#include "app/hovering.h"

#include <utility>

namespace parti::app {
namespace {

/// Whether two snaps are marked in the same way.
bool LooksAlike(const std::optional<Snap>& a, const std::optional<Snap>& b) {
  if (!a || !b) return !a && !b;
  if (a->kind != b->kind) return false;
  if (a->kind == Snap::Kind::kCorner) return a->point == b->point;
  return a->kind == Snap::Kind::kFace || (a->edge.a == b->edge.a && a->edge.b == b->edge.b);
}

}  // namespace

bool Hovering::At(const Vec2& px, const ModelPicture& picture, const Camera& camera, double scale) {
  const auto shape = picture.ShapeUnder(px);
  std::optional<Snap> snap;
  if (shape) {
    snap = SnapAt(picture.shown_state()->model, *shape, camera, px, kReach_px * scale);
  }
  const bool differs = !(shape == shape_) || !LooksAlike(snap, snap_);
  shape_ = shape;
  snap_ = std::move(snap);
  return differs;
}

bool Hovering::End() {
  snap_.reset();
  return std::exchange(shape_, std::nullopt).has_value();
}

void Hovering::AddMarks(const ModelPicture& picture, const View& view,
                        std::vector<render::Mark>* marks) const {
  const auto& state = picture.shown_state();
  if (shape_ && state && shape_->lot < state->model.derived.size() &&
      shape_->shape < state->model.derived[shape_->lot]->tree.size()) {
    Project({HoverOf(state->model, *shape_)}, view, marks);
  }
  if (snap_) AddSnap(*snap_, view, marks);
}

}  // namespace parti::app
