#include "input/key_repeat.h"

namespace parti::input {

void KeyRepeat::Feed(const InputEvent& event, bool repeats) {
  if (const auto* device = std::get_if<DeviceEvent>(&event)) {
    if (held_ && held_->device == device->device) held_.reset();
  }
  const auto* key = std::get_if<KeyEvent>(&event);
  if (!key) return;
  if (key->pressed) {
    held_.reset();
    if (!repeats) return;
    held_ = *key;
    due_s_ = key->t_s + params_.delay_s;
  } else if (held_ && held_->device == key->device && held_->code == key->code) {
    held_.reset();
  }
}

std::optional<double> KeyRepeat::Due_s() const {
  if (!held_) return std::nullopt;
  return due_s_;
}

std::optional<KeyEvent> KeyRepeat::Tick(double now_s) {
  if (!held_ || !(now_s >= due_s_)) return std::nullopt;
  KeyEvent press = *held_;
  press.t_s = now_s;
  press.repeat = true;
  due_s_ += params_.interval_s;
  if (!(due_s_ > now_s)) due_s_ = now_s + params_.interval_s;  // what was missed is not made up for
  return press;
}

}  // namespace parti::input
