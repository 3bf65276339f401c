// Pen or palm: keeps the touches of a hand that draws from becoming gestures.
// Not responsible for what touches mean (gestures.h), nor for how large a contact is, which few
// devices tell. libinput arbitrates between devices that it knows to be one screen; this also does
// so for all others, for X11, and for recorded streams.
#pragma once

#include <optional>
#include <vector>

#include "base/event.h"

namespace parti::input {

/// The numbers of palm arbitration.
struct PalmArbitrationParams {
  /// How long new touches count as the drawing hand's after the pen has left, s, [0, 1]. Hands
  /// follow their pen within a quarter of a second; libinput takes 0.09 s for built-in screens.
  double grace_s = 0.25;
  /// A pen that hovers for so long within `laid_down_mm` was laid down, s, [1, 60], and locks
  /// fingers out no longer: otherwise a pen left on its tablet would do so for ever, and so would
  /// one whose going was not told, as on X11. A palm that lands under a pen held still for longer
  /// is cancelled as soon as the pen moves.
  double laid_down_s = 3;
  /// How far a pen that lies still may seem to move, mm, [0, 5]: the noise of hover positions.
  double laid_down_mm = 0.5;
};

/// What becomes of one event.
struct Passage {
  bool passes = true;                      ///< false: it is a palm's, and said nothing
  std::vector<TouchEvent> cancelled = {};  ///< kCancel of touches that were let through: handle
                                           ///< these before the event

  bool operator==(const Passage&) const = default;
};

/// Value-typed state machine over the events of all devices; any stream is taken.
///
/// A pen (any tool but a mouse) near any tablet cancels all touches that are down, those that began
/// before it came as well, and new touches are swallowed from down to up while it is near and for
/// a grace time after it went. A pen goes by kProximityOut or with its device; any other event of
/// it says that it is near. A touch screen that is removed cancels its touches.
/// Properties  (1) what passes of each finger is kDown, kMotion …, kUp or kCancel, in that order,
///                 if it is so before (kMotion and kUp of touches that never came down are dropped
///                 here);
///             (2) no kDown of a finger passes while a pen draws.
/// Cost: linear in the fingers that are down and the pens that are near.
class PalmArbitration {
 public:
  explicit PalmArbitration(const PalmArbitrationParams& params = {}) : params_(params) {}

  /// The next event of the stream.
  Passage Feed(const InputEvent& event);

  /// Whether a pen is near enough at a time for touches to be taken for a palm's.
  bool PenIsNear(double now_s) const;

 private:
  struct NearPen {
    int device = 0;
    bool down = false;
    Vec2 rest_mm{0, 0};  // where it has stayed …
    double moved_s = 0;  // … since it last moved
  };
  struct Finger {
    int device = 0;
    int finger = 0;
    bool swallowed = false;
    Vec2 position_mm{0, 0};
  };

  Passage Feed(const DeviceEvent& event);
  Passage Feed(const PenEvent& event);
  Passage Feed(const TouchEvent& event);
  void NotePen(const PenEvent& event);
  void Leave(int device, double now_s);
  bool Blocks(const NearPen& pen, double now_s) const;
  /// Cancels the touches that passed, of one device or of all.
  std::vector<TouchEvent> Cancel(std::optional<int> device, double now_s);

  PalmArbitrationParams params_;
  std::vector<NearPen> pens_;
  std::vector<Finger> fingers_;
  std::optional<double> pen_left_s_;
};

}  // namespace parti::input
