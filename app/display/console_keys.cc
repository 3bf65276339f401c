#include "app/display/console_keys.h"

#include <linux/input-event-codes.h>

namespace parti::app {
namespace {

std::optional<int> FunctionKey(uint32_t code) {
  if (code >= KEY_F1 && code <= KEY_F10) return static_cast<int>(code - KEY_F1) + 1;
  if (code == KEY_F11 || code == KEY_F12) return static_cast<int>(code - KEY_F11) + 11;
  return std::nullopt;
}

}  // namespace

bool ConsoleKeys::Holds(uint32_t left, uint32_t right) const {
  return held_.contains(left) || held_.contains(right);
}

std::optional<ConsoleWish> ConsoleKeys::Feed(const KeyEvent& key) {
  const bool modifier = key.code == KEY_LEFTCTRL || key.code == KEY_RIGHTCTRL ||
                        key.code == KEY_LEFTALT || key.code == KEY_RIGHTALT;
  if (modifier) {
    if (key.pressed) {
      held_.insert(key.code);
    } else {
      held_.erase(key.code);
    }
    return std::nullopt;
  }
  if (!key.pressed || key.repeat || !Holds(KEY_LEFTCTRL, KEY_RIGHTCTRL) ||
      !Holds(KEY_LEFTALT, KEY_RIGHTALT)) {
    return std::nullopt;
  }
  if (key.code == KEY_BACKSPACE) return ConsoleWish{std::nullopt, true};
  if (const auto console = FunctionKey(key.code)) return ConsoleWish{console, false};
  return std::nullopt;
}

}  // namespace parti::app
