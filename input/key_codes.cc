#include "input/key_codes.h"

#include <xkbcommon/xkbcommon.h>

#include <algorithm>
#include <optional>

namespace parti::input {
namespace {

/// One layout of a keymap, without modifiers.
struct Layout {
  xkb_keymap* keymap;
  xkb_layout_index_t index;

  /// The code of the letter that the key in this place types.
  std::optional<uint32_t> LetterAt(uint32_t place) const {
    const xkb_keysym_t* symbols = nullptr;
    const int count =
        xkb_keymap_key_get_syms_by_level(keymap, place + kXkbOffset, index, 0, &symbols);
    if (count != 1 || symbols[0] < XKB_KEY_a || symbols[0] > XKB_KEY_z) return std::nullopt;
    return kLetterKeys[symbols[0] - XKB_KEY_a];
  }

  /// The place of the key that types the letter of this code.
  std::optional<uint32_t> PlaceOf(uint32_t letter) const {
    const uint32_t first = std::max(xkb_keymap_min_keycode(keymap), kXkbOffset) - kXkbOffset;
    const uint32_t end = std::min<uint32_t>(xkb_keymap_max_keycode(keymap), KEY_CNT);
    for (uint32_t place = first; place < end; ++place) {
      if (LetterAt(place) == letter) return place;
    }
    return std::nullopt;
  }

  bool is_latin() const { return PlaceOf(KEY_A).has_value(); }
};

std::optional<Layout> LatinLayout(xkb_state* keys) {
  xkb_keymap* keymap = xkb_state_get_keymap(keys);
  const Layout active{keymap, xkb_state_serialize_layout(keys, XKB_STATE_LAYOUT_EFFECTIVE)};
  if (active.is_latin()) return active;
  for (xkb_layout_index_t i = 0; i < xkb_keymap_num_layouts(keymap); ++i) {
    if (const Layout other{keymap, i}; other.is_latin()) return other;
  }
  return std::nullopt;
}

}  // namespace

uint32_t CodeOf(xkb_state* keys, uint32_t place) {
  const auto layout = LatinLayout(keys);
  if (!layout) return place;
  if (const auto letter = layout->LetterAt(place)) return *letter;
  uint32_t code = place;
  // A letter lies in one place, and none in this one: the way has no circle, and at most 26 steps.
  for (size_t step = 0; step < kLetterKeys.size(); ++step) {
    if (std::find(kLetterKeys.begin(), kLetterKeys.end(), code) == kLetterKeys.end()) break;
    const auto from = layout->PlaceOf(code);
    if (!from) break;
    code = *from;
  }
  return code;
}

bool IsKeyboard(const std::function<bool(uint32_t code)>& has_key) {
  return std::all_of(kLetterKeys.begin(), kLetterKeys.end(), has_key);
}

}  // namespace parti::input
