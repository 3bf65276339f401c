#include "input/libinput_devices.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "input/libinput_values.h"

namespace parti::input {
namespace {

/// A device's number goes with libinput's device as its user data; 0 there means none.
void SetNumber(libinput_device* device, size_t number) {
  libinput_device_set_user_data(device, reinterpret_cast<void*>(number + 1));
}
std::optional<int> NumberOf(libinput_device* device) {
  const auto data = reinterpret_cast<size_t>(libinput_device_get_user_data(device));
  if (data == 0) return std::nullopt;
  return static_cast<int>(data) - 1;
}

}  // namespace

double LibinputDevices::NeverBefore(double t_s) { return last_t_s_ = std::max(last_t_s_, t_s); }

void LibinputDevices::Add(libinput_device* device, double now_s, std::vector<InputEvent>* out) {
  if (!IsPenOrTouch(device) && !(mice_and_keys_ && IsMouseOrKeys(device))) {
    // A switch that says that the keyboard is folded away, or the lid shut, is libinput's: it stops
    // keys and touchpads by it, but not by one that is disabled.
    if (mice_and_keys_ && IsSwitch(device)) return;
    libinput_device_config_send_events_set_mode(device, LIBINPUT_CONFIG_SEND_EVENTS_DISABLED);
    return;
  }
  const int number = static_cast<int>(devices_.size());
  SetNumber(device, devices_.size());
  devices_.push_back(
      {device, FactsOf(device), fmt::format("/dev/input/{}", libinput_device_get_sysname(device))});
  Device& added = devices_.back();
  if (mice_and_keys_ && SendsKeys(device)) added.keyboard.emplace();
  libinput_device_config_tap_set_enabled(device, LIBINPUT_CONFIG_TAP_ENABLED);
  Hand(added);
  out->emplace_back(
      DeviceEvent{DeviceEvent::Kind::kAdded, NeverBefore(now_s), number, added.facts});
}

void LibinputDevices::Remove(libinput_device* device, double now_s, std::vector<InputEvent>* out) {
  const auto number = NumberOf(device);
  if (!number) return;
  Device& gone = At(*number);
  gone.present = false;
  gone.handle = nullptr;
  gone.keyboard.reset();
  out->emplace_back(
      DeviceEvent{DeviceEvent::Kind::kRemoved, NeverBefore(now_s), *number, gone.facts});
  repeat_.Feed(out->back());
}

void LibinputDevices::Hand(const Device& device) const {
  if (!device.facts.has_pointer || !device.handle) return;
  libinput_device_config_left_handed_set(device.handle, left_handed_ ? 1 : 0);
}

void LibinputDevices::SetLeftHanded(bool left_handed) {
  left_handed_ = left_handed;
  for (const Device& device : devices_) Hand(device);
}

void LibinputDevices::CompletePosition(TouchEvent* touch) {
  auto& fingers = At(touch->device).fingers_mm;
  const auto finger = static_cast<size_t>(touch->finger);
  if (fingers.size() <= finger) fingers.resize(finger + 1, Vec2(0, 0));
  const bool placed =
      touch->kind == TouchEvent::Kind::kDown || touch->kind == TouchEvent::Kind::kMotion;
  if (placed) {
    fingers[finger] = touch->position_mm;
  } else {
    touch->position_mm = fingers[finger];
  }
}

void LibinputDevices::Type(KeyEvent* key) {
  auto& keyboard = At(key->device).keyboard;
  bool repeats = false;
  if (keyboard) {
    repeats = keyboard->Repeats(key->code);
    Keystroke made = keyboard->Feed(key->code, key->pressed);
    key->code = made.code;
    key->text = std::move(made.text);
  }
  repeat_.Feed(*key, repeats);
}

std::optional<InputEvent> LibinputDevices::Report(libinput_event* event, int number) {
  if (auto pen = PenEventOf(event, number)) return *pen;
  if (auto touch = TouchEventOf(event, number)) {
    CompletePosition(&*touch);
    return *touch;
  }
  if (auto mouse = MouseEventOf(event, number, &pointer_)) return *mouse;
  if (auto scroll = ScrollEventOf(event, number, pointer_)) return *scroll;
  if (auto key = KeyEventOf(event, number)) {
    Type(&*key);
    return *key;
  }
  return std::nullopt;
}

void LibinputDevices::Take(libinput_event* event, double now_s, std::vector<InputEvent>* out) {
  libinput_device* device = libinput_event_get_device(event);
  const libinput_event_type type = libinput_event_get_type(event);
  if (type == LIBINPUT_EVENT_DEVICE_ADDED) return Add(device, now_s, out);
  if (type == LIBINPUT_EVENT_DEVICE_REMOVED) return Remove(device, now_s, out);
  const auto number = NumberOf(device);
  if (!number) return;
  auto report = Report(event, *number);
  if (!report) return;
  std::visit([this](auto& e) { e.t_s = NeverBefore(e.t_s); }, *report);
  out->push_back(std::move(*report));
}

void LibinputDevices::Tick(double now_s, std::vector<InputEvent>* out) {
  auto press = repeat_.Tick(now_s);
  if (!press) return;
  press->t_s = NeverBefore(press->t_s);
  out->emplace_back(std::move(*press));
}

const std::string& LibinputDevices::node(int device) const {
  const auto number = static_cast<size_t>(device);
  CHECK(device >= 0 && number < devices_.size(), "a device number that was given out");
  return devices_[number].node;
}

int LibinputDevices::present() const {
  return static_cast<int>(std::count_if(devices_.begin(), devices_.end(),
                                        [](const Device& device) { return device.present; }));
}

}  // namespace parti::input
