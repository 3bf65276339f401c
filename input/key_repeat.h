// Keys that are held type again: a pure state machine, since libinput and the kernel's evdev leave
// repeating to the program. Not responsible for what keys type (keyboard.h); window systems
// repeat by themselves.
#pragma once

#include <optional>

#include "base/event.h"

namespace parti::input {

/// The numbers of repeating, as desktops have them.
struct KeyRepeatParams {
  double delay_s = 0.5;      ///< until a held key types again, s, [0.1, 2]
  double interval_s = 0.04;  ///< between its further presses, s, [0.01, 1]
};

/// Value-typed. The key that was pressed last repeats until it is released, another is pressed, or
/// its keyboard goes.
/// Property  a held key gives one press per interval in the long run, and never two at once,
///           however late Tick is called.
class KeyRepeat {
 public:
  explicit KeyRepeat(const KeyRepeatParams& params = {}) : params_(params) {}

  /// The next event of the stream; `repeats` says whether this key does (shift does not).
  void Feed(const InputEvent& event, bool repeats = true);

  /// When Tick has something to give; nothing while no key is held.
  std::optional<double> Due_s() const;

  /// The press that is due at this time, if one is.
  std::optional<KeyEvent> Tick(double now_s);

 private:
  KeyRepeatParams params_;
  std::optional<KeyEvent> held_;  // as it was pressed
  double due_s_ = 0;
};

}  // namespace parti::input
