// One keyboard of the console: the system's layout, what is held, and so what its keys type.
// Not responsible for dead keys (key_typing.h), repeating (key_repeat.h), or window systems, which
// have layouts of their own (x11_keyboard.h).
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "input/key_codes.h"

namespace parti::input {

/// Names of a keyboard layout as XKB has them; empty ones are xkbcommon's defaults.
struct KeyLayout {
  std::string model = {};
  std::string layout = {};   ///< "de", "us,cz"
  std::string variant = {};  ///< "nodeadkeys"
  std::string options = {};  ///< "compose:ralt"

  bool operator==(const KeyLayout&) const = default;
};

/// The layout in the text of Debian's keyboard configuration (lines as XKBLAYOUT="de"); lines that
/// say something else are skipped.
KeyLayout LayoutOf(const std::string& configuration);

/// The user's layout: XKB_DEFAULT_LAYOUT and its like where they are set, else Debian's
/// keyboard configuration, else xkbcommon's own default.
KeyLayout SystemLayout();

/// A layout that is not known is taken for xkbcommon's default; where there is no keymap at all,
/// keys type nothing, but their codes say as much as ever.
class Keyboard {
 public:
  explicit Keyboard(const KeyLayout& layout = SystemLayout());
  Keyboard(Keyboard&&) noexcept;
  Keyboard& operator=(Keyboard&&) noexcept;
  ~Keyboard();

  /// The key in a place (evdev KEY_*) went down or up. A release has the code of its press, also
  /// where another layout was set in between, and no text.
  Keystroke Feed(uint32_t place, bool pressed);

  /// Whether the key in a place types again while it is held: letters do, shift does not.
  bool Repeats(uint32_t place) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace parti::input
