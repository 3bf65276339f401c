#include "input/pen_bindings.h"

#include <linux/input-event-codes.h>

#include <algorithm>

namespace parti::input {
namespace {

PenSource SourceOf(PenTool tool) {
  if (tool == PenTool::kMouse) return PenSource::kMouse;
  return tool == PenTool::kEraser ? PenSource::kEraser : PenSource::kPen;
}

uint8_t ModifierOf(uint32_t code) {
  switch (code) {
    case KEY_LEFTSHIFT:
    case KEY_RIGHTSHIFT:
      return kShift;
    case KEY_LEFTCTRL:
    case KEY_RIGHTCTRL:
      return kCtrl;
    case KEY_LEFTALT:
    case KEY_RIGHTALT:
      return kAlt;
    default:
      return 0;
  }
}

void End(PenEvent event, PenAct* act, std::vector<PenDrag>* out) {
  if (*act != PenAct::kNone) out->push_back({DragPhase::kEnd, *act, event});
  *act = PenAct::kNone;
}

/// The button whose press a mouse's tip is: a stroke of a mouse is a drag of its left button.
uint32_t TipButton(PenTool tool) { return tool == PenTool::kMouse ? BTN_LEFT : 0; }

}  // namespace

std::vector<PenDrag> PenBindings::Feed(const InputEvent& event) {
  const ContactChange contact = contacts_.Feed(event);
  if (const auto* pen = std::get_if<PenEvent>(&event)) return Feed(*pen, contact);
  if (const auto* key = std::get_if<KeyEvent>(&event)) NoteKey(*key);
  const auto* change = std::get_if<DeviceEvent>(&event);
  if (!change) return {};
  std::vector<PenDrag> out;
  std::erase_if(keys_, [&](const HeldKey& key) { return key.device == change->device; });
  if (Device* gone = Find(change->device)) {
    gone->last.t_s = change->t_s;
    End(gone->last, &gone->act, &out);
  }
  std::erase_if(devices_, [&](const Device& device) { return device.device == change->device; });
  return out;
}

std::vector<PenDrag> PenBindings::Feed(const PenEvent& event, const ContactChange& contact) {
  std::vector<PenDrag> out;
  Device& device = Entry(event);
  if (contact.ended && device.drag_button == 0) End(event, &device.act, &out);
  if (event.kind == PenEvent::Kind::kProximityIn || event.kind == PenEvent::Kind::kProximityOut) {
    End(event, &device.act, &out);  // of a mouse on a tablet
    device.held.clear();
  }
  if (contact.began) Begin(event, 0, &device, &out);
  if (event.kind == PenEvent::Kind::kButton) FeedButton(event, &device, &out);
  if (event.kind == PenEvent::Kind::kMotion && device.act != PenAct::kNone) {
    out.push_back({DragPhase::kMove, device.act, event});
  }
  device.last = event;
  return out;
}

void PenBindings::FeedButton(const PenEvent& event, Device* device, std::vector<PenDrag>* out) {
  std::erase(device->held, event.button);
  if (event.pressed) device->held.push_back(event.button);
  if (event.tool != PenTool::kMouse || event.button == 0) return;
  if (event.pressed) {
    Begin(event, event.button, device, out);
  } else if (device->drag_button == event.button) {
    End(event, &device->act, out);
  }
}

void PenBindings::Begin(const PenEvent& event, uint32_t button, Device* device,
                        std::vector<PenDrag>* out) {
  if (device->act != PenAct::kNone) return;
  const uint32_t pressed = button != 0 ? button : TipButton(event.tool);
  device->act = ActFor(table_, SourceOf(event.tool), pressed, {device->held, Modifiers()});
  device->drag_button = button;
  if (device->act != PenAct::kNone) out->push_back({DragPhase::kBegin, device->act, event});
}

PenAct PenBindings::WouldDo(int number) const {
  const Device* device = Find(number);
  const PenTool tool = device ? device->last.tool : PenTool::kPen;
  return ActFor(table_, SourceOf(tool), TipButton(tool),
                {device ? device->held : std::vector<uint32_t>(), Modifiers()});
}

PenAct PenBindings::WheelDoes() const {
  return ActFor(table_, PenSource::kWheel, 0, {{}, Modifiers()});
}

std::optional<PenAct> PenBindings::Doing(int number) const {
  const Device* device = Find(number);
  if (!device || device->act == PenAct::kNone) return std::nullopt;
  return device->act;
}

void PenBindings::NoteKey(const KeyEvent& event) {
  if (ModifierOf(event.code) == 0) return;
  std::erase_if(keys_, [&](const HeldKey& key) {
    return key.device == event.device && key.code == event.code;
  });
  if (event.pressed) keys_.push_back({event.device, event.code});
}

uint8_t PenBindings::Modifiers() const {
  uint8_t modifiers = 0;
  for (const HeldKey& key : keys_) {
    modifiers = static_cast<uint8_t>(modifiers | ModifierOf(key.code));
  }
  return modifiers;
}

PenBindings::Device& PenBindings::Entry(const PenEvent& event) {
  if (Device* known = Find(event.device)) return *known;
  devices_.push_back({.device = event.device, .last = event});
  return devices_.back();
}

PenBindings::Device* PenBindings::Find(int number) {
  const auto known = std::find_if(devices_.begin(), devices_.end(),
                                  [&](const Device& d) { return d.device == number; });
  return known == devices_.end() ? nullptr : &*known;
}

const PenBindings::Device* PenBindings::Find(int number) const {
  const auto known = std::find_if(devices_.begin(), devices_.end(),
                                  [&](const Device& d) { return d.device == number; });
  return known == devices_.end() ? nullptr : &*known;
}

}  // namespace parti::input
