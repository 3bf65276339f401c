// What each drag of a pen or mouse is for: the table of bindings applied to a stream of events.
// Not responsible for strokes (strokes_from_events.h), fingers (gestures.h), or for what a panel
// under the pointer wants of it.
#pragma once

#include <optional>
#include <vector>

#include "base/event.h"
#include "input/binding_table.h"
#include "input/drag_phase.h"
#include "input/pen_contacts.h"

namespace parti::input {

/// One report of a drag: its beginning, a move, its end.
struct PenDrag {
  DragPhase phase = DragPhase::kBegin;
  PenAct act = PenAct::kNone;  ///< the same from kBegin to the end; never kNone
  PenEvent event;              ///< that made it; where a device went in mid-drag, its last report

  bool operator==(const PenDrag&) const = default;
};

/// Value-typed state machine: feed it every event in order; any stream is taken.
///
/// What a drag does is settled when it begins: for pens by the end that touches and the buttons
/// held, for mice by the button pressed, for both by shift, ctrl and alt of any keyboard. Each
/// device drags one thing at a time: further buttons do nothing until it is done. A drag ends with
/// its stroke (see PenContacts) or its button, and with its device; it is never cancelled here.
/// Properties  (1) kBegin, then kMoves, then kEnd, of one act, for each device;
///             (2) with the default table, drags of pens are the strokes that PenContacts sees.
/// Cost: linear in the devices; nothing is allocated but for the result.
class PenBindings {
 public:
  explicit PenBindings(BindingTable table = DefaultBindings()) : table_(std::move(table)) {}

  const BindingTable& table() const { return table_; }

  /// Takes hold with the next drag.
  void SetTable(BindingTable table) { table_ = std::move(table); }

  /// What the next event means; rarely two (an end that got lost, and the next beginning).
  std::vector<PenDrag> Feed(const InputEvent& event);

  /// What a device's tip (a mouse's left button) would do if it came down now; for cursors.
  PenAct WouldDo(int device) const;

  /// What turning the wheel does now: kZoom, kPan or kNone.
  PenAct WheelDoes() const;

  /// What a device's drag does that goes on, if one does.
  std::optional<PenAct> Doing(int device) const;

 private:
  struct Device {
    int device = 0;
    PenEvent last = {};               // its last report
    std::vector<uint32_t> held = {};  // buttons, in the order pressed
    PenAct act = PenAct::kNone;       // of the drag that goes on
    uint32_t drag_button = 0;         // that it lasts as long as; 0: as long as the stroke
  };

  std::vector<PenDrag> Feed(const PenEvent& event, const ContactChange& contact);
  void FeedButton(const PenEvent& event, Device* device, std::vector<PenDrag>* out);
  void Begin(const PenEvent& event, uint32_t button, Device* device, std::vector<PenDrag>* out);
  void NoteKey(const KeyEvent& event);
  uint8_t Modifiers() const;
  Device& Entry(const PenEvent& event);
  Device* Find(int device);
  const Device* Find(int device) const;

  struct HeldKey {
    int device = 0;
    uint32_t code = 0;
  };

  BindingTable table_;
  PenContacts contacts_;
  std::vector<Device> devices_;
  std::vector<HeldKey> keys_;  // modifiers only
};

}  // namespace parti::input
