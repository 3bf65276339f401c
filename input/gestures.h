// What fingers mean: orbit, pan and zoom, taps, and drawing where there is no pen. A pure state
// machine over touches. Not responsible for palms (palm_arbitration.h: feed what passes it), for
// moving cameras (app/camera_moves.h), or for what a tap does.
#pragma once

#include <variant>
#include <vector>

#include "base/event.h"
#include "input/drag_phase.h"

namespace parti::input {

/// The numbers of gestures. Lengths are the finger's, on the screen's glass.
struct GestureParams {
  /// A finger that stays within this still taps, mm, [0.5, 10]. Fingertips roll by 1 to 2 mm.
  double slop_mm = 2.5;
  /// How long all fingers of a tap may take from the first down to the last up, s, [0.1, 1]. Quick
  /// taps take 0.1 s, three fingers 0.15 s, careful hands 0.3 s.
  double tap_s = 0.35;
  /// One finger alone does nothing for so long, s, [0, 0.3]: the fingers of a pinch land up to
  /// 0.05 s apart.
  double settle_s = 0.06;
  /// A second finger within this time of an orbit's begin takes the orbit back, s, [0, 1].
  double late_finger_s = 0.15;
  /// Fingers nearer than this are taken to be so far apart, mm, [1, 20]: zooming never explodes.
  double nearest_mm = 8;

  bool operator==(const GestureParams&) const = default;
};

/// A touch and where it is in the view.
struct ViewTouch {
  TouchEvent touch;
  Vec2 position_px{0, 0};  ///< as app::TabletMapping says
  double px_per_mm = 4;    ///< > 0
};

/// One finger moves: turn the camera by how far it went. What it moved before the gesture was
/// certain is left out, so nothing jumps.
struct OrbitGesture {
  DragPhase phase = DragPhase::kBegin;
  Vec2 from_px{0, 0};  ///< where the gesture began
  Vec2 to_px{0, 0};    ///< where the finger is

  bool operator==(const OrbitGesture&) const = default;
};

/// Two fingers move: what was between them at `from_px` when they came is to be at `to_px`, `scale`
/// times as large. Counted from the gesture's begin, so nothing drifts; an app keeps the camera
/// that it had then.
struct PanZoomGesture {
  DragPhase phase = DragPhase::kBegin;
  Vec2 from_px{0, 0};  ///< the middle of the two fingers when the second had come
  Vec2 to_px{0, 0};    ///< the middle now
  double scale = 1;    ///< distance of the fingers now, over that when the second had come; > 0

  bool operator==(const PanZoomGesture&) const = default;
};

/// Fingers came and went at once, without moving.
struct TapGesture {
  int fingers = 1;         ///< 1 to 3
  Vec2 position_px{0, 0};  ///< the middle of where they came down

  bool operator==(const TapGesture&) const = default;
};

/// In "finger draws" mode: a report of the finger as a pen's. kCancel: the stroke was not meant, it
/// is to be forgotten; its event is a kProximityOut.
struct FingerDraw {
  DragPhase phase = DragPhase::kBegin;
  PenEvent event;  ///< kDown, kMotion …, kUp, with the touch's device, position and time

  bool operator==(const FingerDraw&) const = default;
};

using Gesture = std::variant<OrbitGesture, PanZoomGesture, TapGesture, FingerDraw>;

/// Value-typed; feed it the touches of all devices in order. Any stream is taken: ups without
/// downs, repeated downs, positions that are not finite (skipped), times that stand still.
///
/// One finger orbits as soon as it has moved by the slop and the settling time is over; a second
/// one that comes soon after takes the orbit back, a later one ends it. Two fingers pan and zoom
/// until one of them lifts; the other then does nothing until it lifts too, or a second one joins
/// it again. Further fingers neither help nor disturb what goes on. Two or three fingers that come
/// and go within the tap's time and slop are a tap. Where the finger draws, it does so in place of
/// orbiting and of one-finger taps (a dot), and further fingers don't disturb it.
/// Properties  (1) each gesture has one kBegin, then kMoves, then one kEnd or kCancel, and none
///                 begins before the one before it is over;
///             (2) when no finger is down, no gesture is going on, and the machine is as new;
///             (3) scale is finite and > 0;
///             (4) a kCancel of a touch never makes a tap, and cancels the gesture of its finger.
class Gestures {
 public:
  explicit Gestures(const GestureParams& params = {}) : params_(params) {}

  /// Whether one finger draws; takes hold with the next finger that comes to an empty screen.
  void SetFingerDraws(bool draws) { finger_draws_ = draws; }
  bool finger_draws() const { return finger_draws_; }

  /// What the next touch makes. Usually one gesture or none, rarely more (a kEnd and a kBegin, or
  /// the held-back beginning of a drawn line).
  std::vector<Gesture> Feed(const ViewTouch& touch);

  bool operator==(const Gestures&) const = default;

 private:
  enum class State : uint8_t { kWaiting, kOrbiting, kPanning, kDrawing, kSpent };
  struct Finger {
    int device = 0;
    int finger = 0;
    Vec2 down_px{0, 0};
    Vec2 now_px{0, 0};
    bool moved = false;  // beyond the slop

    bool operator==(const Finger&) const = default;
  };
  /// From the first finger that comes to an empty screen until the last one has left it.
  struct Progress {
    State state = State::kWaiting;
    std::vector<Finger> fingers;  // in the order in which they came; the first one or two lead
    bool may_tap = true;
    bool lifting = false;  // a finger has left, and none has joined since: nothing begins
    bool draws = false;    // one finger draws
    int most_fingers = 0;
    double first_down_s = 0;
    double orbit_began_s = 0;
    Vec2 from_px{0, 0};  // of the gesture that goes on
    double from_distance_px = 1;
    double nearest_px = 1;
    Vec2 downs_px{0, 0};              // sum of where the fingers came down
    std::vector<PenEvent> held_back;  // of a finger that may come to draw

    bool operator==(const Progress&) const = default;
  };
  using Gestured = std::vector<Gesture>;

  Gestured Down(const ViewTouch& touch);
  Gestured Move(const ViewTouch& touch);
  Gestured Lift(const ViewTouch& touch);
  Gestured LastWaitingLifts(const ViewTouch& touch) const;
  Gestured BeginOne(const ViewTouch& touch);
  Gestured Drawn(const ViewTouch& touch, DragPhase phase) const;
  void BecomePair(double px_per_mm);
  OrbitGesture Orbit(DragPhase phase) const;
  PanZoomGesture PanZoom(DragPhase phase) const;
  std::vector<Finger>::iterator Find(const TouchEvent& touch);

  GestureParams params_;
  bool finger_draws_ = false;
  Progress now_;
};

}  // namespace parti::input
