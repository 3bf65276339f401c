#include "input/x11_pointer.h"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <cmath>

namespace parti::input {
namespace {

using Kind = X11PointerReport::Kind;

/// X's number of a button as evdev's code; both drivers of pens number them alike.
uint32_t ButtonCode(PenTool tool, int button) {
  const bool mouse = tool == PenTool::kMouse;
  if (button == 2) return mouse ? BTN_MIDDLE : BTN_STYLUS;
  if (button == 3) return mouse ? BTN_RIGHT : BTN_STYLUS2;
  if (button == 8 && !mouse) return BTN_STYLUS3;
  return static_cast<uint32_t>(BTN_SIDE + std::max(button - 8, 0));
}

/// What buttons 4 to 7 scroll, in notches.
std::optional<Vec2> WheelButton(int button) {
  if (button == 4) return Vec2(0, -1);
  if (button == 5) return Vec2(0, 1);
  if (button == 6) return Vec2(-1, 0);
  if (button == 7) return Vec2(1, 0);
  return std::nullopt;
}

bool Scrolls(X11Role role) { return role == X11Role::kScrollX || role == X11Role::kScrollY; }

}  // namespace

std::optional<ScrollEvent> X11PadScroll(const X11PointerReport& report, int device,
                                        double px_per_mm) {
  const auto steps = WheelButton(report.button);
  if (report.kind != Kind::kPress || !steps || !IsFinite(report.position_px)) return std::nullopt;
  return ScrollEvent{device, report.t_s, report.position_px / px_per_mm, *steps};
}

std::optional<double> X11Pointer::Fraction(X11Role role) const {
  for (const X11Axis& axis : facts_.axes) {
    if (axis.role != role) continue;
    return std::clamp((axis.value.value_or(axis.low) - axis.low) / (axis.high - axis.low), 0.0,
                      1.0);
  }
  return std::nullopt;
}

std::optional<double> X11Pointer::Tilt_deg(X11Role role) const {
  // Every driver seen so far counts degrees (the ranges are +-64 or +-90); what counts more finely
  // is taken for 64 degrees to either side.
  constexpr double kMostDegrees = 180, kUsualRange = 64;
  for (const X11Axis& axis : facts_.axes) {
    if (axis.role != role) continue;
    const double value = axis.value.value_or(0);
    return axis.high <= kMostDegrees ? value : value / axis.high * kUsualRange;
  }
  return std::nullopt;
}

bool X11Pointer::HasScroll() const {
  return std::any_of(facts_.axes.begin(), facts_.axes.end(),
                     [](const X11Axis& axis) { return Scrolls(axis.role); });
}

PenEvent X11Pointer::Make(PenEvent::Kind kind, double t_s) const {
  PenEvent event;
  event.kind = kind;
  event.tool = facts_.tool;
  event.device = facts_.device;
  event.t_s = t_s;
  event.position_mm = position_mm_;
  event.pressure = Fraction(X11Role::kPressure);
  event.distance = Fraction(X11Role::kDistance);
  const auto x = Tilt_deg(X11Role::kTiltX), y = Tilt_deg(X11Role::kTiltY);
  if (x && y) event.tilt_deg = Vec2(*x, *y);
  return event;
}

void X11Pointer::TakeValues(const X11PointerReport& report, Vec2* steps) {
  for (const auto& [number, value] : report.values) {
    if (!std::isfinite(value)) continue;
    for (X11Axis& axis : facts_.axes) {
      if (axis.number != number) continue;
      if (Scrolls(axis.role) && axis.value) {
        const double turned = (value - *axis.value) / axis.step;
        (axis.role == X11Role::kScrollX ? steps->x : steps->y) += turned;
      }
      axis.value = value;
    }
  }
}

void X11Pointer::Press(const X11PointerReport& report, std::vector<InputEvent>* out) {
  const bool pressed = report.kind == Kind::kPress;
  if (const auto steps = WheelButton(report.button)) {
    // Pressed and released once a notch; a wheel with valuators has told it already.
    if (pressed && !HasScroll()) {
      out->emplace_back(ScrollEvent{facts_.device, report.t_s, position_mm_, *steps});
    }
    return;
  }
  if (report.button == 1) return Touch(pressed, report.t_s, out);
  std::erase(held_, report.button);
  if (pressed) held_.push_back(report.button);
  // What a stroke does is settled by what is held when it begins.
  if (facts_.buttons_with_tip && !pressed) Touch(false, report.t_s, out);
  out->emplace_back(SideButton(report.button, pressed, report.t_s));
  if (facts_.buttons_with_tip && pressed) Touch(true, report.t_s, out);
}

void X11Pointer::Touch(bool touches, double t_s, std::vector<InputEvent>* out) {
  if (touches == down_) return;
  down_ = touches;
  out->emplace_back(Make(touches ? PenEvent::Kind::kDown : PenEvent::Kind::kUp, t_s));
}

uint32_t X11Pointer::CodeOf(int button) const {
  const bool exchanged = facts_.buttons_with_tip && (button == 2 || button == 3);
  return ButtonCode(facts_.tool, exchanged ? 5 - button : button);
}

PenEvent X11Pointer::SideButton(int button, bool pressed, double t_s) const {
  PenEvent event = Make(PenEvent::Kind::kButton, t_s);
  event.button = CodeOf(button);
  event.pressed = pressed;
  return event;
}

void X11Pointer::ComeNear(const X11PointerReport& report, std::vector<InputEvent>* out) {
  if (near_) return;
  near_ = true;
  out->emplace_back(Make(PenEvent::Kind::kProximityIn, report.t_s));
  // A mouse's buttons begin drags: those that began elsewhere are not ours.
  if (facts_.tool == PenTool::kMouse) return;
  if (report.held) {
    held_ = *report.held;
    std::erase_if(held_, [](int button) { return button == 1 || WheelButton(button); });
  }
  for (const int button : held_) out->emplace_back(SideButton(button, true, report.t_s));
}

std::vector<InputEvent> X11Pointer::Feed(const X11PointerReport& report) {
  std::vector<InputEvent> out;
  if (report.emulated) return out;
  const bool leaving = report.kind == Kind::kLeave || report.kind == Kind::kProximityOut;
  // A stroke goes on beyond the window's edge: X holds the pointer for us while it is down.
  if (report.kind == Kind::kLeave && down_) return out;
  if (leaving) return Leave(report.t_s);
  if (IsFinite(report.position_px)) position_mm_ = report.position_px / px_per_mm_;
  Vec2 steps(0, 0);
  TakeValues(report, &steps);
  ComeNear(report, &out);
  if (report.kind == Kind::kMotion) {
    if (steps != Vec2(0, 0)) {
      out.emplace_back(ScrollEvent{facts_.device, report.t_s, position_mm_, steps});
    } else {
      out.emplace_back(Make(PenEvent::Kind::kMotion, report.t_s));
    }
  } else if (report.kind == Kind::kPress || report.kind == Kind::kRelease) {
    Press(report, &out);
  }
  return out;
}

std::vector<InputEvent> X11Pointer::Leave(double t_s) {
  std::vector<InputEvent> out;
  if (down_) out.emplace_back(Make(PenEvent::Kind::kUp, t_s));
  down_ = false;
  if (near_) out.emplace_back(Make(PenEvent::Kind::kProximityOut, t_s));
  near_ = false;
  return out;
}

void X11Pointer::SetScroll(const std::vector<std::pair<int, double>>& values) {
  for (const auto& [number, value] : values) {
    for (X11Axis& axis : facts_.axes) {
      if (axis.number == number && Scrolls(axis.role)) axis.value = value;
    }
  }
}

}  // namespace parti::input
