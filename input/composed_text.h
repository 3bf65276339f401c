// What a pressed key types, as UTF-8: layouts and dead keys through libxkbcommon.
// Not responsible for which keys are held, or for where the layout comes from (x11_keyboard.h).
#pragma once

#include <cstdint>
#include <memory>
#include <string>

struct xkb_compose_state;
struct xkb_compose_table;
struct xkb_context;
struct xkb_state;

namespace parti::input {

/// Remembers a dead key that waits for its letter.
class ComposedText {
 public:
  /// Sequences of dead keys are those of the locale of LC_ALL, LC_CTYPE or LANG; none where there
  /// is no table for it. `context` may go before the value.
  explicit ComposedText(xkb_context* context);
  ~ComposedText();
  ComposedText(ComposedText&&) noexcept;
  ComposedText& operator=(ComposedText&&) noexcept;

  /// What the press of `keycode` (evdev's + 8) types with the modifiers of `state`: "" for keys
  /// that type nothing, for dead keys until their letter comes, for control characters, and while
  /// Control, Alt or the Super key makes a shortcut of it.
  std::string Press(xkb_state* state, uint32_t keycode);

  /// A dead key that waits does so no more.
  void Forget();

 private:
  struct Unref {
    void operator()(xkb_compose_state* state) const;
    void operator()(xkb_compose_table* table) const;
  };
  std::unique_ptr<xkb_compose_table, Unref> table_;
  std::unique_ptr<xkb_compose_state, Unref> compose_;
};

}  // namespace parti::input
