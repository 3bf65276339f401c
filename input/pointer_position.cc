#include "input/pointer_position.h"

namespace parti::input {

void PointerPosition::SetView(const Vec2& size_px, double scale) {
  if (!IsFinite(size_px) || !(size_px.x > 0 && size_px.y > 0)) return;
  if (!std::isfinite(scale) || !(scale > 0)) return;
  const Vec2 part = position_px_ / size_px_;
  size_px_ = size_px;
  scale_ = scale;
  MoveTo(part);
}

void PointerPosition::MoveBy(const Vec2& delta) { Place(position_px_ + delta * scale_); }

void PointerPosition::MoveTo(const Vec2& part) { Place(part * size_px_); }

void PointerPosition::Place(const Vec2& position_px) {
  if (!IsFinite(position_px)) return;
  position_px_ = glm::clamp(position_px, Vec2(0, 0), size_px_);
}

}  // namespace parti::input
