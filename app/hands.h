// What hands do, in pixels of the view: pens, fingers, mice and keys of any device become drags,
// hovering, gestures, and the one pointer that panels know. Joins input/'s state machines: palms
// are rejected, drags told apart by tip and buttons, fingers read as gestures.
// Not responsible for what a drag does to the drawing or the camera (application.h).
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <variant>
#include <vector>

#include "app/panels/panel_input.h"
#include "app/tablet_mapping.h"
#include "base/camera.h"
#include "base/event.h"
#include "input/gestures.h"
#include "input/palm_arbitration.h"
#include "input/pen_bindings.h"

namespace parti::app {

/// One report of a pen, mouse or drawing finger that drags. kCancel: it was not meant.
struct DragAct {
  input::DragPhase phase = input::DragPhase::kBegin;
  input::PenAct act = input::PenAct::kDraw;
  int device = 0;
  Vec2 px{0, 0};
  double t_s = 0;
  std::optional<double> pressure = {};
  double px_per_mm = 4;  ///< of the device in the view, > 0

  bool operator==(const DragAct&) const = default;
};

/// A pen or mouse is over the drawing without touching it.
struct HoverAct {
  Vec2 px{0, 0};
  input::PenAct would = input::PenAct::kNone;  ///< what its tip would do

  bool operator==(const HoverAct&) const = default;
};

/// Nothing hovers over the drawing any more.
struct HoverEndAct {
  bool operator==(const HoverEndAct&) const = default;
};

/// A wheel was turned over the drawing.
struct WheelAct {
  input::PenAct what = input::PenAct::kZoom;
  Vec2 px{0, 0};
  Vec2 steps{0, 0};

  bool operator==(const WheelAct&) const = default;
};

/// Something for the panels; keys come to them first.
struct PanelAct {
  PanelEvent event;
};

using Act = std::variant<DragAct, HoverAct, HoverEndAct, WheelAct, PanelAct, input::OrbitGesture,
                         input::PanZoomGesture, input::TapGesture>;

/// What one desk looks like to all its devices.
struct Desk {
  bool left_handed = false;
  std::vector<OutputPlace> outputs = {};  ///< that are plugged in; empty: nobody knows

  bool operator==(const Desk&) const = default;
};

/// Whether a panel lies under a pixel; asked when something comes down or hovers there.
using OverPanel = std::function<bool(const Vec2& px)>;

/// Value-typed but for the question asked of the panels. What comes down on a panel is the panel's
/// until it lifts; what comes down on the drawing stays the drawing's, wherever it goes.
/// One thing drags over the drawing at a time: what comes down meanwhile does nothing until it
/// lifts. Only a pen goes before what is none, a mouse that was bumped or a touchpad that was
/// tapped: their drag ends with its coming down, and what it has drawn so far counts.
/// Properties  (1) drags and gestures have one kBegin, then kMoves, then one kEnd or kCancel, and
///                 drags follow one another;
///             (2) a panel sees one pointer: a second one that comes down meanwhile is dropped;
///             (3) a device that goes ends its drag (kEnd: what is drawn so far counts) and leaves
///                 its panel (PanelPointerGone: the button is not pressed).
class Hands {
 public:
  /// The size of the view; new mappings hold from the next report on.
  void SetView(const Camera& camera, Desk desk);
  void SetBindings(input::BindingTable table) { bindings_.SetTable(std::move(table)); }
  void SetFingerDraws(bool draws) { gestures_.SetFingerDraws(draws); }
  /// What drags do that would draw: kDraw but where a tool has been chosen.
  void SetMode(input::PenAct mode) { mode_ = mode; }

  /// Positions that are not finite are taken for the last one of their device.
  std::vector<Act> Feed(const InputEvent& event, const OverPanel& over_panel);

  /// Everything is lifted: the view is hidden or closed. What is drawn so far counts; presses on
  /// panels don't.
  std::vector<Act> LiftAll();

  bool pen_present() const;  ///< a device with a pen is there
  bool has_keys() const;     ///< a keyboard is there
  bool dragging() const { return drag_.has_value(); }

 private:
  struct Device {
    DeviceFacts facts;
    TabletMapping mapping;
    Vec2 last_px{0, 0};
  };
  struct Contact {
    int device = 0;
    int finger = -1;  // -1: a pen or mouse
    bool operator==(const Contact&) const = default;
  };

  TabletMapping MappingOf(const DeviceFacts& facts) const;
  Device& DeviceOf(int number);
  Vec2 PixelOf(int device, const Vec2& position_mm);
  void Meet(const DeviceEvent& event, std::vector<Act>* acts);
  void Forget(int device);
  void FeedPen(const PenEvent& event, const OverPanel& over_panel, std::vector<Act>* acts);
  void FeedDrag(const input::PenDrag& drag, const OverPanel& over_panel, std::vector<Act>* acts);
  void Hover(const PenEvent& event, const OverPanel& over_panel, std::vector<Act>* acts);
  void FeedTouch(const TouchEvent& event, const OverPanel& over_panel, std::vector<Act>* acts);
  void TakeGesture(const input::Gesture& gesture, std::vector<Act>* acts);
  void Drag(const DragAct& act, std::vector<Act>* acts);
  void BeginDrag(const DragAct& act, std::vector<Act>* acts);
  void EndDrag(std::vector<Act>* acts);
  bool Drags(int device) const { return drag_ && drag_->device == device; }
  bool OnPanel(const Contact& contact) const { return on_panel_ == contact; }
  void EndHover(std::vector<Act>* acts);

  Camera camera_;
  Desk desk_;
  std::map<int, Device> devices_;
  input::PalmArbitration palms_;
  input::Gestures gestures_;
  input::PenBindings bindings_;
  input::PenAct mode_ = input::PenAct::kDraw;
  std::optional<Contact> on_panel_;  // the contact that is the panels' pointer
  std::vector<Contact> dropped_;     // came down on a panel that was taken
  std::optional<DragAct> drag_;      // that goes on over the drawing: its last report
  bool hovering_ = false;            // over the drawing
  bool pointing_ = false;            // panels have been told of a pointer
};

}  // namespace parti::app
