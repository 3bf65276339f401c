#include "tests/support/evdev_from_touches.h"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace parti::tests {
namespace {

/// Writes the events of all fingers in the kernel's protocol B.
class Driver {
 public:
  explicit Driver(EvdevRecording* screen) : screen_(screen) {}

  void Take(const TouchEvent& event) {
    t_us_ = std::llround(event.t_s * 1e6);
    const bool lifts =
        event.kind == TouchEvent::Kind::kUp || event.kind == TouchEvent::Kind::kCancel;
    if (event.kind == TouchEvent::Kind::kDown) return Touch(event);
    const auto slot = slots_.find({event.device, event.finger});
    if (slot == slots_.end()) return;
    Select(slot->second);
    if (!lifts) return Place(event, slot->second);
    slots_.erase(slot);
    Send(EV_ABS, ABS_MT_TRACKING_ID, -1);
    if (slots_.empty()) Send(EV_KEY, BTN_TOUCH, 0);
    Send(EV_SYN, SYN_REPORT, 0);
  }

 private:
  void Touch(const TouchEvent& event) {
    const auto slot = FreeSlot();
    if (!slot) return;
    const bool first = slots_.empty();
    slots_[{event.device, event.finger}] = *slot;
    Select(*slot);
    Send(EV_ABS, ABS_MT_TRACKING_ID, next_contact_++);
    if (first) Send(EV_KEY, BTN_TOUCH, 1);
    Place(event, *slot);
  }

  void Place(const TouchEvent& event, int slot) {
    const auto& x = screen_->axes.at(ABS_MT_POSITION_X);
    const auto& y = screen_->axes.at(ABS_MT_POSITION_Y);
    const int units_x = Units(x, event.position_mm.x);
    const int units_y = Units(y, event.position_mm.y);
    Send(EV_ABS, ABS_MT_POSITION_X, units_x);
    Send(EV_ABS, ABS_MT_POSITION_Y, units_y);
    if (slot == 0) {
      Send(EV_ABS, ABS_X, units_x);
      Send(EV_ABS, ABS_Y, units_y);
    }
    Send(EV_SYN, SYN_REPORT, 0);
  }

  static int Units(const EvdevAxis& axis, double mm) {
    const auto units = axis.minimum + static_cast<int>(std::lround(mm * axis.resolution));
    return std::clamp(units, axis.minimum, axis.maximum);
  }

  std::optional<int> FreeSlot() const {
    const auto taken = [&](int slot) {
      return std::any_of(slots_.begin(), slots_.end(),
                         [&](const auto& finger) { return finger.second == slot; });
    };
    for (int slot = 0; slot <= screen_->axes.at(ABS_MT_SLOT).maximum; ++slot) {
      if (!taken(slot)) return slot;
    }
    return std::nullopt;
  }

  void Select(int slot) {
    if (slot != selected_) Send(EV_ABS, ABS_MT_SLOT, slot);
    selected_ = slot;
  }

  void Send(uint16_t type, uint16_t code, int32_t value) {
    screen_->events.push_back({t_us_, type, code, value});
  }

  EvdevRecording* screen_;
  std::map<std::pair<int, int>, int> slots_;  // by device and finger
  int selected_ = -1;                         // whatever an earlier drawing left
  int next_contact_ = 1;
  int64_t t_us_ = 0;
};

}  // namespace

Result<EvdevRecording> EvdevFromTouches(const input::Drawing& drawing, EvdevRecording screen) {
  Driver driver(&screen);
  for (const InputEvent& event : drawing.events) {
    if (const auto* touch = std::get_if<TouchEvent>(&event)) driver.Take(*touch);
  }
  if (screen.events.empty()) return Fail(ErrorCode::kNothingMade, "the drawing has no touches");
  return screen;
}

}  // namespace parti::tests
