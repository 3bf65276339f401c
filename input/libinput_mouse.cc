// Mice, wheels and keys of libinput_values.h.
#include <linux/input-event-codes.h>

#include "input/libinput_values.h"

namespace parti::input {
namespace {

constexpr double kUnitsPerNotch = 120;  // of wheels, in libinput's "v120"
constexpr double kPixelsPerNotch = 15;  // of fingers on touchpads: libinput's degrees of a wheel

double Seconds(uint64_t microseconds) { return static_cast<double>(microseconds) / 1e6; }

PenEvent MouseEvent(PenEvent::Kind kind, int device, uint64_t time_us,
                    const PointerPosition& pointer) {
  PenEvent value;
  value.kind = kind;
  value.tool = PenTool::kMouse;
  value.device = device;
  value.t_s = Seconds(time_us);
  value.position_mm = pointer.position_mm();
  return value;
}

PenEvent ButtonEvent(libinput_event_pointer* mouse, int device, const PointerPosition& pointer) {
  const bool pressed =
      libinput_event_pointer_get_button_state(mouse) == LIBINPUT_BUTTON_STATE_PRESSED;
  const uint32_t button = libinput_event_pointer_get_button(mouse);
  const uint64_t time_us = libinput_event_pointer_get_time_usec(mouse);
  if (button == BTN_LEFT) {
    return MouseEvent(pressed ? PenEvent::Kind::kDown : PenEvent::Kind::kUp, device, time_us,
                      pointer);
  }
  PenEvent value = MouseEvent(PenEvent::Kind::kButton, device, time_us, pointer);
  value.button = button;
  value.pressed = pressed;
  return value;
}

}  // namespace

std::optional<PenEvent> MouseEventOf(libinput_event* event, int device, PointerPosition* pointer) {
  const libinput_event_type type = libinput_event_get_type(event);
  if (type < LIBINPUT_EVENT_POINTER_MOTION || type > LIBINPUT_EVENT_POINTER_BUTTON) {
    return std::nullopt;
  }
  libinput_event_pointer* mouse = libinput_event_get_pointer_event(event);
  if (type == LIBINPUT_EVENT_POINTER_BUTTON) return ButtonEvent(mouse, device, *pointer);
  if (type == LIBINPUT_EVENT_POINTER_MOTION) {
    pointer->MoveBy({libinput_event_pointer_get_dx(mouse), libinput_event_pointer_get_dy(mouse)});
  } else {
    pointer->MoveTo({libinput_event_pointer_get_absolute_x_transformed(mouse, 1),
                     libinput_event_pointer_get_absolute_y_transformed(mouse, 1)});
  }
  return MouseEvent(PenEvent::Kind::kMotion, device, libinput_event_pointer_get_time_usec(mouse),
                    *pointer);
}

std::optional<ScrollEvent> ScrollEventOf(libinput_event* event, int device,
                                         const PointerPosition& pointer) {
  const libinput_event_type type = libinput_event_get_type(event);
  const bool wheel = type == LIBINPUT_EVENT_POINTER_SCROLL_WHEEL;
  if (!wheel && type != LIBINPUT_EVENT_POINTER_SCROLL_FINGER &&
      type != LIBINPUT_EVENT_POINTER_SCROLL_CONTINUOUS) {
    return std::nullopt;  // POINTER_AXIS says the same once more, for old programs
  }
  libinput_event_pointer* mouse = libinput_event_get_pointer_event(event);
  const auto steps = [&](libinput_pointer_axis axis) {
    if (libinput_event_pointer_has_axis(mouse, axis) == 0) return 0.0;
    return wheel ? libinput_event_pointer_get_scroll_value_v120(mouse, axis) / kUnitsPerNotch
                 : libinput_event_pointer_get_scroll_value(mouse, axis) / kPixelsPerNotch;
  };
  ScrollEvent value;
  value.device = device;
  value.t_s = Seconds(libinput_event_pointer_get_time_usec(mouse));
  value.position_mm = pointer.position_mm();
  value.steps = {steps(LIBINPUT_POINTER_AXIS_SCROLL_HORIZONTAL),
                 steps(LIBINPUT_POINTER_AXIS_SCROLL_VERTICAL)};
  if (value.steps == Vec2(0, 0)) return std::nullopt;  // fingers left the touchpad
  return value;
}

std::optional<KeyEvent> KeyEventOf(libinput_event* event, int device) {
  if (libinput_event_get_type(event) != LIBINPUT_EVENT_KEYBOARD_KEY) return std::nullopt;
  libinput_event_keyboard* key = libinput_event_get_keyboard_event(event);
  KeyEvent value;
  value.device = device;
  value.t_s = Seconds(libinput_event_keyboard_get_time_usec(key));
  value.code = libinput_event_keyboard_get_key(key);
  value.pressed = libinput_event_keyboard_get_key_state(key) == LIBINPUT_KEY_STATE_PRESSED;
  return value;
}

}  // namespace parti::input
