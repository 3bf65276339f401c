#include "input/gestures.h"

#include <algorithm>
#include <cmath>

namespace parti::input {
namespace {

constexpr double kFarthest_px = 1e7;  // beyond it a position is a device's mistake
constexpr int kMostTapping = 3;
constexpr size_t kMostFingers = 32;  // further ones are not looked at
constexpr size_t kMostHeldBack =
    1000;  // reports of a finger that rests: 8 s; later ones are merged

bool IsPlaced(const ViewTouch& t) {
  return std::abs(t.position_px.x) <= kFarthest_px && std::abs(t.position_px.y) <= kFarthest_px &&
         IsFinite(t.touch.position_mm) && t.px_per_mm > 0;
}

PenEvent PenOf(const TouchEvent& touch, PenEvent::Kind kind) {
  PenEvent event;
  event.kind = kind;
  event.device = touch.device;
  event.t_s = touch.t_s;
  event.position_mm = touch.position_mm;
  return event;
}

}  // namespace

std::vector<Gesture> Gestures::Feed(const ViewTouch& touch) {
  switch (touch.touch.kind) {
    case TouchEvent::Kind::kDown:
      return IsPlaced(touch) ? Down(touch) : Gestured{};
    case TouchEvent::Kind::kMotion:
      return IsPlaced(touch) ? Move(touch) : Gestured{};
    case TouchEvent::Kind::kUp:
    case TouchEvent::Kind::kCancel:
      return Lift(touch);
  }
  return {};
}

Gestures::Gestured Gestures::Down(const ViewTouch& touch) {
  Gestured out;
  if (Find(touch.touch) != now_.fingers.end()) {  // its up got lost
    ViewTouch lost = touch;
    lost.touch.kind = TouchEvent::Kind::kCancel;
    out = Lift(lost);
  }
  if (now_.fingers.size() >= kMostFingers) return out;
  if (now_.fingers.empty()) {
    now_.first_down_s = touch.touch.t_s;
    now_.draws = finger_draws_;
    now_.held_back = {PenOf(touch.touch, PenEvent::Kind::kDown)};
  }
  now_.fingers.push_back(
      {touch.touch.device, touch.touch.finger, touch.position_px, touch.position_px});
  now_.most_fingers = std::max(now_.most_fingers, static_cast<int>(now_.fingers.size()));
  now_.downs_px += touch.position_px;
  if (now_.state != State::kWaiting || now_.lifting) now_.may_tap = false;
  if (now_.state == State::kOrbiting) {
    const bool soon = touch.touch.t_s - now_.orbit_began_s < params_.late_finger_s;
    out.emplace_back(Orbit(soon ? DragPhase::kCancel : DragPhase::kEnd));
  }
  const bool free = now_.state != State::kPanning && now_.state != State::kDrawing;
  if (free && now_.fingers.size() == 2) BecomePair(touch.px_per_mm);
  return out;
}

void Gestures::BecomePair(double px_per_mm) {
  const Vec2 a = now_.fingers[0].now_px, b = now_.fingers[1].now_px;
  now_.state = State::kWaiting;
  now_.lifting = false;
  now_.from_px = (a + b) * 0.5;
  now_.nearest_px = params_.nearest_mm * px_per_mm;
  now_.from_distance_px = std::max(now_.nearest_px, glm::distance(a, b));
}

Gestures::Gestured Gestures::Move(const ViewTouch& touch) {
  const auto finger = Find(touch.touch);
  if (finger == now_.fingers.end()) return {};
  finger->now_px = touch.position_px;
  if (glm::distance(finger->now_px, finger->down_px) > params_.slop_mm * touch.px_per_mm) {
    finger->moved = true;
    now_.may_tap = false;
  }
  const auto place = finger - now_.fingers.begin();
  switch (now_.state) {
    case State::kOrbiting:
      return {Orbit(DragPhase::kMove)};
    case State::kPanning:
      if (place < 2) return {PanZoom(DragPhase::kMove)};
      return {};
    case State::kDrawing:
      if (place == 0) return Drawn(touch, DragPhase::kMove);
      return {};
    case State::kSpent:
      return {};
    case State::kWaiting:
      break;
  }
  if (now_.most_fingers == 1) return BeginOne(touch);
  if (!finger->moved || now_.lifting || now_.fingers.size() != 2) return {};
  now_.state = State::kPanning;
  return {PanZoom(DragPhase::kBegin)};
}

Gestures::Gestured Gestures::BeginOne(const ViewTouch& touch) {
  if (now_.draws) {
    if (now_.held_back.size() >= kMostHeldBack) now_.held_back.pop_back();
    now_.held_back.push_back(PenOf(touch.touch, PenEvent::Kind::kMotion));
  }
  const bool settled = touch.touch.t_s - now_.first_down_s >= params_.settle_s;
  if (!settled || !now_.fingers.front().moved) return {};
  if (!now_.draws) {
    now_.state = State::kOrbiting;
    now_.orbit_began_s = touch.touch.t_s;
    now_.from_px = touch.position_px;
    return {Orbit(DragPhase::kBegin)};
  }
  now_.state = State::kDrawing;
  Gestured out;
  for (const PenEvent& event : now_.held_back) {
    const bool first = event.kind == PenEvent::Kind::kDown;
    out.emplace_back(FingerDraw{first ? DragPhase::kBegin : DragPhase::kMove, event});
  }
  now_.held_back.clear();
  return out;
}

Gestures::Gestured Gestures::Lift(const ViewTouch& touch) {
  const auto finger = Find(touch.touch);
  if (finger == now_.fingers.end()) return {};
  const bool cancelled = touch.touch.kind == TouchEvent::Kind::kCancel;
  const DragPhase phase = cancelled ? DragPhase::kCancel : DragPhase::kEnd;
  const auto place = finger - now_.fingers.begin();
  Gestured out;
  if (now_.state == State::kOrbiting) out = {Orbit(phase)};
  if (now_.state == State::kPanning && place < 2) out = {PanZoom(phase)};
  if (now_.state == State::kDrawing && place == 0) out = Drawn(touch, phase);
  if (!out.empty()) now_.state = State::kSpent;
  if (cancelled) now_.may_tap = false;
  now_.fingers.erase(finger);
  now_.lifting = true;
  if (!now_.fingers.empty()) return out;
  if (now_.state == State::kWaiting) out = LastWaitingLifts(touch);
  now_ = {};
  return out;
}

Gestures::Gestured Gestures::LastWaitingLifts(const ViewTouch& touch) const {
  if (touch.touch.kind == TouchEvent::Kind::kCancel) return {};
  if (now_.draws && now_.most_fingers == 1) {  // a dot, or a line that was done in no time
    Gestured out;
    for (const PenEvent& event : now_.held_back) {
      out.emplace_back(FingerDraw{out.empty() ? DragPhase::kBegin : DragPhase::kMove, event});
    }
    out.emplace_back(FingerDraw{DragPhase::kEnd, PenOf(touch.touch, PenEvent::Kind::kUp)});
    return out;
  }
  const bool quick = touch.touch.t_s - now_.first_down_s <= params_.tap_s;
  if (!now_.may_tap || !quick || now_.most_fingers > kMostTapping) return {};
  return {TapGesture{now_.most_fingers, now_.downs_px / double(now_.most_fingers)}};
}

Gestures::Gestured Gestures::Drawn(const ViewTouch& touch, DragPhase phase) const {
  PenEvent::Kind kind = PenEvent::Kind::kMotion;
  if (phase == DragPhase::kEnd) kind = PenEvent::Kind::kUp;
  if (phase == DragPhase::kCancel) kind = PenEvent::Kind::kProximityOut;
  return {FingerDraw{phase, PenOf(touch.touch, kind)}};
}

OrbitGesture Gestures::Orbit(DragPhase phase) const {
  return {phase, now_.from_px, now_.fingers.front().now_px};
}

PanZoomGesture Gestures::PanZoom(DragPhase phase) const {
  const Vec2 a = now_.fingers[0].now_px, b = now_.fingers[1].now_px;
  const double distance_px = std::max(now_.nearest_px, glm::distance(a, b));
  return {phase, now_.from_px, (a + b) * 0.5, distance_px / now_.from_distance_px};
}

std::vector<Gestures::Finger>::iterator Gestures::Find(const TouchEvent& touch) {
  return std::find_if(now_.fingers.begin(), now_.fingers.end(), [&](const Finger& f) {
    return f.device == touch.device && f.finger == touch.finger;
  });
}

}  // namespace parti::input
