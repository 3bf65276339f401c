// The codes that keys go by: evdev's, but those of letters follow the user's layout, so that Ctrl+Z
// is the key which types z. One place for the console and for window systems.
// Not responsible for what keys type (key_typing.h).
#pragma once

#include <linux/input-event-codes.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>

struct xkb_state;

namespace parti::input {

/// XKB's and X's code of a key is evdev's and this.
inline constexpr uint32_t kXkbOffset = 8;

/// The keys of a to z on a US keyboard.
inline constexpr std::array<uint32_t, 26> kLetterKeys = {
    KEY_A, KEY_B, KEY_C, KEY_D, KEY_E, KEY_F, KEY_G, KEY_H, KEY_I, KEY_J, KEY_K, KEY_L, KEY_M,
    KEY_N, KEY_O, KEY_P, KEY_Q, KEY_R, KEY_S, KEY_T, KEY_U, KEY_V, KEY_W, KEY_X, KEY_Y, KEY_Z};

/// What a key's event says of it.
struct Keystroke {
  uint32_t code = 0;      ///< CodeOf
  std::string text = {};  ///< of a press, as KeyTyping::Press
};

/// The code of the key in place `place` (evdev's KEY_*: where it lies on a US keyboard), with the
/// layout that is active in `keys`. Modifiers don't matter.
/// Property  (1) a key that types one of a to z has that letter's code, wherever it lies.
///           (2) other keys have that of their place, unless a letter has it: then that of the
///               place which the letter is typed in, and so on. So different keys have different
///               codes, where a layout has no letter twice.
///           (3) a layout of other letters (Greek, Russian) has codes of the first of the keymap's
///               layouts that has Latin ones; there is none: of places.
/// Cost: some hundred look-ups in the keymap, up to some thousand for a key that gave way.
uint32_t CodeOf(xkb_state* keys, uint32_t place);

/// Whether names and numbers can be typed with a device that has these keys (evdev's KEY_*): it has
/// all letters. Power buttons, volume keys and pads of numbers, which are keyboards to the system,
/// are none.
bool IsKeyboard(const std::function<bool(uint32_t code)>& has_key);

}  // namespace parti::input
