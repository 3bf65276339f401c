// The keys that a console's user expects to work whatever runs there: Ctrl+Alt+F1 to F12 for the
// other consoles, Ctrl+Alt+Backspace to end. A value-typed state machine.
// Not responsible for what follows (a Seat's).
#pragma once

#include <optional>
#include <set>

#include "base/event.h"

namespace parti::app {

/// What a key asked for; such a key is not for anybody else.
struct ConsoleWish {
  std::optional<int> console;  ///< F3: 3
  bool end = false;
};

/// Feed it every key event. Either Ctrl and either Alt count, on any keyboard.
class ConsoleKeys {
 public:
  /// The wish of a key, once a press.
  std::optional<ConsoleWish> Feed(const KeyEvent& key);
  /// Keys are no more heard of: none is held.
  void Forget() { held_.clear(); }

 private:
  bool Holds(uint32_t left, uint32_t right) const;

  std::set<uint32_t> held_;  // Ctrl and Alt
};

}  // namespace parti::app
