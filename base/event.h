// What input devices send, as values: the one currency between input/ and app/.
// Positions are on the device's surface in millimetres; mapping them into a view is the app's.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "base/math.h"

namespace parti {

/// What a surface is taken for whose device does not say its size, mm: a medium pen tablet, 16:10.
inline constexpr Vec2 kUsualSize_mm{216, 135};

/// What is known of a pen tablet, touch screen, mouse or keyboard.
struct DeviceFacts {
  std::string name;
  uint32_t vendor = 0;
  uint32_t product = 0;
  /// Active area; absent where the device does not say: its positions are then of kUsualSize_mm.
  std::optional<Vec2> size_mm;
  bool has_pen = false;
  bool has_touch = false;
  bool has_pressure = false;
  bool has_tilt = false;
  bool has_distance = false;
  bool has_eraser = false;
  bool has_pointer = false;  ///< a mouse: its events are PenEvents of tool kMouse and ScrollEvents
  bool has_keys = false;  ///< a keyboard to type on; KeyEvents come from devices of few keys, too
  bool has_display = false;  ///< the surface is a screen: what is pointed at lies under the tip
  /// Set for devices that point into the view itself (mice, pens and fingers of a window system):
  /// their millimetres times this are view pixels from the view's top left. Without it the surface
  /// is the device's own, and mapping it into the view is the app's.
  std::optional<double> view_px_per_mm;

  bool operator==(const DeviceFacts&) const = default;
};

/// A device came or went. `device` numbers devices within one source, from 0, never reused.
struct DeviceEvent {
  enum class Kind { kAdded, kRemoved };
  Kind kind = Kind::kAdded;
  double t_s = 0;
  int device = 0;
  DeviceFacts facts;

  bool operator==(const DeviceEvent&) const = default;
};

/// Which end or kind of pen: tablets tell them apart.
enum class PenTool : uint8_t { kPen, kEraser, kBrush, kPencil, kAirbrush, kMouse };

/// One pen report. The axes are the state after it, whatever it was sent for.
///
/// A mouse reports likewise, with tool kMouse: its left button is kDown and kUp, the others kButton
/// with their evdev codes (BTN_RIGHT, BTN_MIDDLE …), and moving is kMotion, pressed or not.
struct PenEvent {
  enum class Kind : uint8_t { kProximityIn, kProximityOut, kDown, kUp, kMotion, kButton };
  Kind kind = Kind::kMotion;
  PenTool tool = PenTool::kPen;
  int device = 0;
  double t_s = 0;                  ///< s, of the source's clock; never decreasing
  Vec2 position_mm{0, 0};          ///< from the top left of the surface, y down
  std::optional<double> pressure;  ///< [0, 1]
  std::optional<double> distance;  ///< [0, 1], 0 at the surface
  std::optional<Vec2> tilt_deg;    ///< x: to the right, y: towards the user
  uint32_t button = 0;             ///< kButton: the evdev code (BTN_STYLUS, BTN_STYLUS2 …)
  bool pressed = false;            ///< kButton

  bool operator==(const PenEvent&) const = default;
};

/// One report about one finger.
struct TouchEvent {
  enum class Kind : uint8_t { kDown, kMotion, kUp, kCancel };
  Kind kind = Kind::kMotion;
  int device = 0;
  int finger = 0;  ///< the same from kDown to kUp or kCancel
  double t_s = 0;
  Vec2 position_mm{0, 0};  ///< of the last report, in kUp and kCancel

  bool operator==(const TouchEvent&) const = default;
};

/// A key went down or up.
struct KeyEvent {
  int device = 0;
  double t_s = 0;
  /// evdev KEY_*. A letter's is that of the key which has it in the user's layout: KEY_Z is the key
  /// that types z (input/key_codes.h).
  uint32_t code = 0;
  bool pressed = false;
  std::string text = {};  ///< UTF-8: what the press types; empty for keys that type nothing
  bool repeat = false;    ///< a press that was not made anew: the key is still held

  bool operator==(const KeyEvent&) const = default;
};

/// A wheel was turned, or two fingers moved on a touchpad.
struct ScrollEvent {
  int device = 0;
  double t_s = 0;
  Vec2 position_mm{0, 0};  ///< of the pointer, as in PenEvent
  Vec2 steps{0, 0};        ///< notches, or parts of them; x to the right, y towards the user

  bool operator==(const ScrollEvent&) const = default;
};

using InputEvent = std::variant<DeviceEvent, PenEvent, TouchEvent, KeyEvent, ScrollEvent>;

}  // namespace parti
