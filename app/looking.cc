#include "app/looking.h"

#include <cmath>

namespace parti::app {

using input::DragPhase;
using input::PenAct;

void Looking::Set(const Camera& camera) {
  camera_ = camera;
  how_ = How::kNot;
}

void Looking::Hold(bool held) {
  held_ = held;
  if (held) how_ = How::kNot;
}

bool Looking::Begin(How how, const Vec2& px, const TouchedPoint& touched) {
  if (held_ || how_ != How::kNot) return false;
  how_ = how;
  from_ = camera_;
  from_px_ = px;
  touched_ = touched(camera_, px);
  return false;
}

bool Looking::Follow(DragPhase phase, const Camera& moved) {
  if (phase == DragPhase::kEnd || phase == DragPhase::kCancel) how_ = How::kNot;
  const Camera before = camera_;
  camera_ = phase == DragPhase::kCancel ? from_ : moved;
  return !(camera_ == before);
}

bool Looking::Take(const input::OrbitGesture& gesture, const TouchedPoint& touched) {
  if (gesture.phase == DragPhase::kBegin) return Begin(How::kOrbit, gesture.from_px, touched);
  if (how_ != How::kOrbit) return false;
  return Follow(gesture.phase, OrbitAbout(from_, touched_, gesture.to_px - gesture.from_px));
}

bool Looking::Take(const input::PanZoomGesture& gesture, const TouchedPoint& touched) {
  if (gesture.phase == DragPhase::kBegin) return Begin(How::kPanZoom, gesture.from_px, touched);
  if (how_ != How::kPanZoom) return false;
  return Follow(gesture.phase, PanZoom(from_, touched_, gesture.to_px, gesture.scale));
}

bool Looking::Take(const DragAct& drag, const TouchedPoint& touched) {
  if (drag.phase == DragPhase::kBegin) return Begin(How::kDrag, drag.px, touched);
  if (how_ != How::kDrag) return false;
  const Vec2 delta = drag.px - from_px_;
  if (drag.act == PenAct::kOrbit) return Follow(drag.phase, OrbitAbout(from_, touched_, delta));
  if (drag.act == PenAct::kPan) return Follow(drag.phase, PanZoom(from_, touched_, drag.px, 1));
  const double scale = std::exp2(-delta.y / kDoubling_px);
  return Follow(drag.phase, PanZoom(from_, touched_, from_px_, scale));
}

bool Looking::Take(const WheelAct& wheel, const TouchedPoint& touched) {
  if (held_ || moving()) return false;
  const Camera before = camera_;
  const Vec3 point = touched(camera_, wheel.px);
  if (wheel.what == PenAct::kZoom) {
    camera_ = PanZoom(camera_, point, wheel.px, std::pow(kWheelFactor, -wheel.steps.y));
  } else if (wheel.what == PenAct::kPan) {
    constexpr double kStep_px = 40;  // a notch, as browsers scroll
    camera_ = PanZoom(camera_, point, wheel.px - wheel.steps * kStep_px, 1);
  }
  return !(camera_ == before);
}

}  // namespace parti::app
