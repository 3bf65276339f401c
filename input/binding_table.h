// What the ends and buttons of pens and mice do, as one table that users may change, with a text
// form for settings. Not responsible for watching buttons (pen_bindings.h) or for fingers
// (gestures.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace parti::input {

/// What a drag or a wheel is for.
enum class PenAct : uint8_t { kNone, kDraw, kErase, kSelect, kOrbit, kPan, kZoom };

/// What moves.
enum class PenSource : uint8_t { kPen, kEraser, kMouse, kWheel };

/// Keys that are held; combined as bits.
inline constexpr uint8_t kShift = 1, kCtrl = 2, kAlt = 4;

/// One row. For pens and erasers `button` is one that is held when the tip comes down, 0: any or
/// none; for mice it is the button that is pressed (BTN_LEFT …); for the wheel it is 0.
struct Binding {
  PenSource source = PenSource::kPen;
  uint32_t button = 0;    ///< evdev's BTN_…
  uint8_t modifiers = 0;  ///< kShift | kCtrl | kAlt: at least these are held
  PenAct act = PenAct::kNone;

  bool operator==(const Binding&) const = default;
};

/// The rows; which of them stands first matters only between rows of equal conditions.
using BindingTable = std::vector<Binding>;

/// Pens draw, their eraser end and lower button erase, the upper button selects. A mouse's left
/// button draws, with ctrl erases, with shift selects; the middle button pans, with or without
/// shift; the right button orbits; the wheel zooms, with shift pans.
BindingTable DefaultBindings();

/// What is held when something begins.
struct Held {
  std::vector<uint32_t> buttons = {};  ///< of the device
  uint8_t modifiers = 0;
};

/// The act of the row that fits with the most conditions (buttons and modifiers); kNone if no row
/// does. `pressed` is the mouse's button, and 0 for everything else.
PenAct ActFor(const BindingTable& table, PenSource source, uint32_t pressed, const Held& held);

/// "pen=draw pen+lower=erase shift+mouse+left=select": rows with blanks between them.
/// Property  ReadBindings(BindingsText(t)) == t for every table of known buttons and modifiers.
std::string BindingsText(const BindingTable& table);

/// errors  kBadText  a word that is not known, with what is; a row given twice.
Result<BindingTable> ReadBindings(std::string_view text);

}  // namespace parti::input
