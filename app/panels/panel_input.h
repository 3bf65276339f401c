// What reaches panels of a pointer and a keyboard, as values.
// Which device it came from, and gestures with several fingers, are input/'s.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "base/event.h"

namespace parti::app {

/// A pen, the mouse or one finger. Panels know one pointer: while a pen is near, fingers are not
/// sent.
struct PanelPointer {
  Vec2 px{0, 0};      ///< in the view
  bool down = false;  ///< the tip, the left button, the finger
  bool operator==(const PanelPointer&) const = default;
};

/// No pointer is over the view: the pen went away, the finger was lifted, the mouse left. A press
/// that was begun is given up.
struct PanelPointerGone {
  bool operator==(const PanelPointerGone&) const = default;
};

/// A wheel or two fingers on a touch pad.
struct PanelScroll {
  Vec2 steps{0, 0};  ///< notches; x to the right, y towards the user
  bool operator==(const PanelScroll&) const = default;
};

using PanelEvent = std::variant<PanelPointer, PanelPointerGone, PanelScroll, KeyEvent>;

/// What happened since the last frame, in order.
struct PanelInput {
  double now_s = 0;  ///< of one clock that never goes back
  std::vector<PanelEvent> events;
};

}  // namespace parti::app
