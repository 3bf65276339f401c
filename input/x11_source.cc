#include "input/x11_source.h"

#include <X11/Xlib.h>
#include <X11/extensions/XInput.h>
#include <X11/extensions/XInput2.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>

namespace parti::input {
namespace {

double Now() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9;
}

/// Valuators of a report: those of the mask, in order.
std::vector<std::pair<int, double>> ValuesOf(const XIValuatorState& state) {
  std::vector<std::pair<int, double>> values;
  const double* value = state.values;
  for (int number = 0; number < state.mask_len * 8; ++number) {
    if (XIMaskIsSet(state.mask, number)) values.emplace_back(number, *value++);
  }
  return values;
}

std::vector<int> ButtonsOf(const XIButtonState& state) {
  std::vector<int> buttons;
  for (int number = 1; number < state.mask_len * 8; ++number) {
    if (XIMaskIsSet(state.mask, number)) buttons.push_back(number);
  }
  return buttons;
}

X11PointerReport::Kind KindOf(int type) {
  if (type == XI_ButtonPress) return X11PointerReport::Kind::kPress;
  if (type == XI_ButtonRelease) return X11PointerReport::Kind::kRelease;
  return X11PointerReport::Kind::kMotion;
}

void Append(std::vector<InputEvent>* out, std::vector<InputEvent> more) {
  std::move(more.begin(), more.end(), std::back_inserter(*out));
}

}  // namespace

Result<std::unique_ptr<X11Source>> X11Source::Create(_XDisplay* display, unsigned long window,
                                                     double px_per_mm) {
  int opcode = 0, event = 0, error = 0, major = 2, minor = 2;
  if (!XQueryExtension(display, "XInputExtension", &opcode, &event, &error) ||
      XIQueryVersion(display, &major, &minor) != Success || major * 100 + minor < 202) {
    return Fail(ErrorCode::kDevice, "the X server has no XInput 2.2, which tells pens and fingers",
                "update the X server");
  }
  return std::unique_ptr<X11Source>(new X11Source(display, window, px_per_mm, opcode));
}

X11Source::X11Source(_XDisplay* display, unsigned long window, double px_per_mm, int opcode)
    : display_(display),
      window_(window),
      px_per_mm_(px_per_mm),
      opcode_(opcode),
      keyboard_(display) {
  Select();
}

void X11Source::Select() {
  // Of the masters: their events name the slave, and slaves that come later are in them too.
  std::array<unsigned char, XIMaskLen(XI_LASTEVENT)> of_masters{}, of_all{};
  for (const int type : {XI_ButtonPress, XI_ButtonRelease, XI_Motion, XI_KeyPress, XI_KeyRelease,
                         XI_Enter, XI_Leave, XI_TouchBegin, XI_TouchUpdate, XI_TouchEnd}) {
    XISetMask(of_masters.data(), type);
  }
  XISetMask(of_all.data(), XI_HierarchyChanged);
  XIEventMask masters{XIAllMasterDevices, static_cast<int>(of_masters.size()), of_masters.data()};
  XIEventMask all{XIAllDevices, static_cast<int>(of_all.size()), of_all.data()};
  XISelectEvents(display_, window_, &masters, 1);
  XISelectEvents(display_, DefaultRootWindow(display_), &all, 1);
}

double X11Source::Time(unsigned long time_ms) {
  return clock_.ToSeconds(static_cast<uint32_t>(time_ms), Now());
}

/// Of the old XInput: the new one has no word for a pen that goes away.
void X11Source::WatchProximity(int id) {
  XDevice* device = XOpenDevice(display_, static_cast<XID>(id));
  if (!device) return;
  int type = 0;
  XEventClass of_class = 0;
  ProximityOut(device, type, of_class);
  if (of_class != 0) {
    XSelectExtensionEvent(display_, window_, &of_class, 1);
    proximity_out_ = type;
  }
  // The selection lasts; closing would only forget what Xlib knows of the device.
  XFree(device);
}

void X11Source::Add(const X11Device& device, double t_s, std::vector<InputEvent>* out) {
  const int number = next_number_++;
  devices_[device.id] = {number, device.facts};
  if (device.facts.has_pen || device.facts.has_pointer) {
    pointers_.erase(device.id);
    pointers_.emplace(
        device.id,
        X11Pointer({number, device.tool, device.axes, device.buttons_with_tip}, px_per_mm_));
  }
  if (device.facts.has_pen) WatchProximity(device.id);
  out->emplace_back(DeviceEvent{DeviceEvent::Kind::kAdded, t_s, number, device.facts});
}

void X11Source::Remove(int id, double t_s, std::vector<InputEvent>* out) {
  const auto gone = devices_.find(id);
  if (gone == devices_.end()) return;
  const auto [number, facts] = gone->second;
  std::erase_if(held_, [n = number](const Held& key) { return key.device == n; });
  devices_.erase(gone);
  pointers_.erase(id);
  touches_.erase(id);
  out->emplace_back(DeviceEvent{DeviceEvent::Kind::kRemoved, t_s, number, facts});
}

void X11Source::Refresh(double t_s, std::vector<InputEvent>* out) {
  const std::vector<X11Device> now = ReadX11Devices(display_, px_per_mm_);
  const auto is_there = [&](int id) {
    return std::any_of(now.begin(), now.end(), [&](const auto& device) { return device.id == id; });
  };
  std::vector<int> gone;
  for (const auto& [id, device] : devices_) {
    if (!is_there(id)) gone.push_back(id);
  }
  for (const int id : gone) Remove(id, t_s, out);
  for (const X11Device& device : now) {
    if (!devices_.contains(device.id)) Add(device, t_s, out);
  }
}

std::vector<InputEvent> X11Source::Begin() {
  std::vector<InputEvent> out;
  Refresh(Now(), &out);
  return out;
}

void X11Source::LeaveOthers(int id, double t_s, std::vector<InputEvent>* out) {
  for (auto& [other, pointer] : pointers_) {
    if (other != id && !pointer.is_down()) Append(out, pointer.Leave(t_s));
  }
}

std::map<int, X11Pointer>::iterator X11Source::AnyMouse() {
  return std::find_if(pointers_.begin(), pointers_.end(),
                      [](const auto& pointer) { return pointer.second.tool() == PenTool::kMouse; });
}

/// Programs that move the pointer do so in the name of the master; any mouse can stand for it.
std::map<int, X11Pointer>::iterator X11Source::FindPointer(int id, int master) {
  return id == master ? AnyMouse() : pointers_.find(id);
}

void X11Source::TakePointer(const void* data, std::vector<InputEvent>* out) {
  const auto& event = *static_cast<const XIDeviceEvent*>(data);
  X11PointerReport report;
  report.kind = KindOf(event.evtype);
  report.t_s = Time(event.time);
  report.position_px = {event.event_x, event.event_y};
  report.button = event.detail;
  report.emulated = (event.flags & XIPointerEmulated) != 0;
  report.values = ValuesOf(event.valuators);
  report.held = ButtonsOf(event.buttons);
  const auto pointer = FindPointer(event.sourceid, event.deviceid);
  if (pointer == pointers_.end()) {
    // What moves the master, but is none of the devices, is a tablet's pad.
    const auto mouse = devices_.contains(event.sourceid) ? pointer : AnyMouse();
    if (mouse == pointers_.end()) return;
    const auto turned = X11PadScroll(report, mouse->second.device(), px_per_mm_);
    if (turned) out->emplace_back(*turned);
    return;
  }
  // One pointer on the screen: what another device does with it, the last one no more does.
  if (!report.emulated) LeaveOthers(pointer->first, report.t_s, out);
  Append(out, pointer->second.Feed(report));
}

void X11Source::TakeCrossing(const void* data, std::vector<InputEvent>* out) {
  const auto& event = *static_cast<const XIEnterEvent*>(data);
  const double t_s = Time(event.time);
  if (event.evtype == XI_Leave) {
    LeaveOthers(-1, t_s, out);
    return;
  }
  const auto pointer = FindPointer(event.sourceid, event.deviceid);
  if (pointer == pointers_.end()) return;
  for (const X11Device& device : ReadX11Devices(display_, px_per_mm_, pointer->first)) {
    std::vector<std::pair<int, double>> values;
    for (const X11Axis& axis : device.axes) {
      if (axis.value) values.emplace_back(axis.number, *axis.value);
    }
    pointer->second.SetScroll(values);
  }
}

void X11Source::TakeTouch(const void* data, std::vector<InputEvent>* out) {
  const auto& event = *static_cast<const XIDeviceEvent*>(data);
  const auto device = devices_.find(event.sourceid);
  if (device == devices_.end() || !device->second.second.has_touch) return;
  Touches& touches = touches_[event.sourceid];
  const auto touch = static_cast<uint32_t>(event.detail);
  if (event.evtype == XI_TouchBegin) {
    int free = 0;
    while (touches.positions_mm.contains(free)) ++free;
    touches.fingers[touch] = free;
  }
  const auto found = touches.fingers.find(touch);
  if (found == touches.fingers.end()) return;
  const int finger = found->second;
  TouchEvent made;
  made.device = device->second.first;
  made.finger = finger;
  made.t_s = Time(event.time);
  if (event.evtype == XI_TouchEnd) {
    made.kind = TouchEvent::Kind::kUp;
    made.position_mm = touches.positions_mm[finger];
    touches.positions_mm.erase(finger);
    touches.fingers.erase(found);
  } else {
    made.kind = event.evtype == XI_TouchBegin ? TouchEvent::Kind::kDown : TouchEvent::Kind::kMotion;
    made.position_mm = Vec2(event.event_x, event.event_y) / px_per_mm_;
    touches.positions_mm[finger] = made.position_mm;
  }
  out->emplace_back(made);
}

void X11Source::TakeKey(const void* data, std::vector<InputEvent>* out) {
  const auto& event = *static_cast<const XIDeviceEvent*>(data);
  const auto device = devices_.find(event.sourceid);
  const auto keycode = static_cast<uint32_t>(event.detail);
  if (device == devices_.end() || keycode < kXkbOffset) return;
  KeyEvent key;
  key.device = device->second.first;
  key.t_s = Time(event.time);
  key.pressed = event.evtype == XI_KeyPress;
  key.repeat = key.pressed && (event.flags & XIKeyRepeat) != 0;
  auto held = std::find_if(held_.begin(), held_.end(), [&](const Held& other) {
    return other.device == key.device && other.keycode == keycode;
  });
  // One that was held when the focus came is not ours to release.
  if (!key.pressed && held == held_.end()) return;
  if (key.pressed) {
    const auto word = [](int bits) { return static_cast<uint32_t>(bits); };
    Keystroke made = keyboard_.Press(
        keycode, {word(event.mods.base), word(event.mods.latched), word(event.mods.locked),
                  word(event.group.base), word(event.group.latched), word(event.group.locked)});
    key.text = std::move(made.text);
    if (held == held_.end()) held = held_.insert(held, {key.device, keycode, made.code});
  }
  key.code = held->code;  // as it was pressed, whatever the layout is by now
  if (!key.pressed) held_.erase(held);
  out->emplace_back(std::move(key));
}

std::vector<InputEvent> X11Source::ReleaseKeys() {
  std::vector<InputEvent> out;
  for (const Held& held : held_) {
    KeyEvent key;
    key.device = held.device;
    key.t_s = clock_.Local(Now());
    key.code = held.code;
    out.emplace_back(key);
  }
  held_.clear();
  keyboard_.Forget();
  return out;
}

void X11Source::TakeHierarchy(const void* data, std::vector<InputEvent>* out) {
  const auto& event = *static_cast<const XIHierarchyEvent*>(data);
  constexpr int kMatters = XISlaveAdded | XISlaveRemoved | XIDeviceEnabled | XIDeviceDisabled;
  if (event.flags & kMatters) Refresh(Time(event.time), out);
}

std::vector<InputEvent> X11Source::Take(_XEvent* event) {
  std::vector<InputEvent> out;
  if (keyboard_.Take(*event)) return out;
  if (event->type == proximity_out_) {
    const auto& left = reinterpret_cast<const XProximityNotifyEvent&>(*event);
    const auto pointer = pointers_.find(static_cast<int>(left.deviceid));
    if (pointer != pointers_.end()) Append(&out, pointer->second.Leave(Time(left.time)));
    return out;
  }
  XGenericEventCookie& cookie = event->xcookie;
  if (event->type != GenericEvent || cookie.extension != opcode_) return out;
  if (!XGetEventData(display_, &cookie)) return out;
  switch (cookie.evtype) {
    case XI_ButtonPress:
    case XI_ButtonRelease:
    case XI_Motion:
      TakePointer(cookie.data, &out);
      break;
    case XI_Enter:
    case XI_Leave:
      TakeCrossing(cookie.data, &out);
      break;
    case XI_TouchBegin:
    case XI_TouchUpdate:
    case XI_TouchEnd:
      TakeTouch(cookie.data, &out);
      break;
    case XI_KeyPress:
    case XI_KeyRelease:
      TakeKey(cookie.data, &out);
      break;
    case XI_HierarchyChanged:
      TakeHierarchy(cookie.data, &out);
      break;
    default:
      break;
  }
  XFreeEventData(display_, &cookie);
  return out;
}

}  // namespace parti::input
