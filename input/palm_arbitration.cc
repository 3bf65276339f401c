#include "input/palm_arbitration.h"

#include <algorithm>
#include <cmath>

namespace parti::input {

Passage PalmArbitration::Feed(const InputEvent& event) {
  if (const auto* pen = std::get_if<PenEvent>(&event)) return Feed(*pen);
  if (const auto* touch = std::get_if<TouchEvent>(&event)) return Feed(*touch);
  if (const auto* device = std::get_if<DeviceEvent>(&event)) return Feed(*device);
  return {};
}

Passage PalmArbitration::Feed(const DeviceEvent& event) {
  Passage passage{.cancelled = Cancel(event.device, event.t_s)};
  std::erase_if(fingers_, [&](const Finger& f) { return f.device == event.device; });
  Leave(event.device, event.t_s);
  return passage;
}

void PalmArbitration::Leave(int device, double now_s) {
  const auto gone = [&](const NearPen& pen) { return pen.device == device; };
  if (std::erase_if(pens_, gone) > 0) pen_left_s_ = now_s;
}

Passage PalmArbitration::Feed(const PenEvent& event) {
  if (event.tool == PenTool::kMouse) return {};
  if (event.kind == PenEvent::Kind::kProximityOut) {
    Leave(event.device, event.t_s);
    return {};
  }
  NotePen(event);
  if (!PenIsNear(event.t_s)) return {};
  return {.cancelled = Cancel(std::nullopt, event.t_s)};
}

void PalmArbitration::NotePen(const PenEvent& event) {
  auto pen = std::find_if(pens_.begin(), pens_.end(),
                          [&](const NearPen& p) { return p.device == event.device; });
  const bool came = pen == pens_.end();
  if (came) pen = pens_.insert(pens_.end(), {.device = event.device});
  if (event.kind == PenEvent::Kind::kDown) pen->down = true;
  if (event.kind == PenEvent::Kind::kUp || event.kind == PenEvent::Kind::kProximityIn) {
    pen->down = false;
  }
  const bool stays = event.kind == PenEvent::Kind::kMotion &&
                     glm::distance(event.position_mm, pen->rest_mm) <= params_.laid_down_mm;
  if (stays && !came) return;
  pen->rest_mm = event.position_mm;
  pen->moved_s = event.t_s;
}

Passage PalmArbitration::Feed(const TouchEvent& event) {
  auto finger = std::find_if(fingers_.begin(), fingers_.end(), [&](const Finger& f) {
    return f.device == event.device && f.finger == event.finger;
  });
  if (event.kind == TouchEvent::Kind::kDown) {
    Passage passage{.passes = !PenIsNear(event.t_s)};
    if (finger != fingers_.end()) {  // its up got lost
      if (!finger->swallowed) {
        passage.cancelled = {{TouchEvent::Kind::kCancel, event.device, event.finger, event.t_s,
                              finger->position_mm}};
      }
      fingers_.erase(finger);
    }
    fingers_.push_back({event.device, event.finger, !passage.passes, event.position_mm});
    return passage;
  }
  if (finger == fingers_.end()) return {.passes = false};
  const Passage passage{.passes = !finger->swallowed};
  finger->position_mm = event.position_mm;
  if (event.kind != TouchEvent::Kind::kMotion) fingers_.erase(finger);
  return passage;
}

bool PalmArbitration::Blocks(const NearPen& pen, double now_s) const {
  return pen.down || !(now_s - pen.moved_s > params_.laid_down_s);
}

bool PalmArbitration::PenIsNear(double now_s) const {
  if (pen_left_s_ && now_s - *pen_left_s_ < params_.grace_s) return true;
  return std::any_of(pens_.begin(), pens_.end(),
                     [&](const NearPen& pen) { return Blocks(pen, now_s); });
}

std::vector<TouchEvent> PalmArbitration::Cancel(std::optional<int> device, double now_s) {
  std::vector<TouchEvent> cancelled;
  for (Finger& finger : fingers_) {
    if (finger.swallowed || (device && *device != finger.device)) continue;
    finger.swallowed = true;
    cancelled.push_back(
        {TouchEvent::Kind::kCancel, finger.device, finger.finger, now_s, finger.position_mm});
  }
  return cancelled;
}

}  // namespace parti::input
