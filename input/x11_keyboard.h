// The keyboard layout that an X server's desktop has set, and what its keys type.
// Not responsible for reading key events (x11_source.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "input/key_codes.h"
#include "input/key_typing.h"

struct _XDisplay;
union _XEvent;
struct xkb_context;
struct xkb_state;

namespace parti::input {

/// Modifiers and layouts, as a key event carries them.
struct X11Modifiers {
  uint32_t pressed = 0, latched = 0, locked = 0;
  uint32_t pressed_layout = 0, latched_layout = 0, locked_layout = 0;
};

/// Keys type nothing where the server has no XKB, and their codes are those of their places.
class X11Keyboard {
 public:
  explicit X11Keyboard(_XDisplay* display);
  ~X11Keyboard();
  X11Keyboard(X11Keyboard&&) = delete;

  /// The press of X's `keycode`, which is at least kXkbOffset.
  Keystroke Press(uint32_t keycode, const X11Modifiers& modifiers);
  /// The focus went elsewhere.
  void Forget();
  /// Whether the event was the keyboard's own: another layout was set.
  bool Take(const _XEvent& event);

 private:
  void Load();

  struct Unref {
    void operator()(xkb_context* context) const;
    void operator()(xkb_state* state) const;
  };
  _XDisplay* display_;
  int first_event_ = 0;  // of XKB
  std::unique_ptr<xkb_context, Unref> context_;
  std::unique_ptr<xkb_state, Unref> state_;
  std::optional<KeyTyping> typing_;
};

}  // namespace parti::input
