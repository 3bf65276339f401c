#include "input/composed_text.h"

#include <xkbcommon/xkbcommon-compose.h>
#include <xkbcommon/xkbcommon.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace parti::input {
namespace {

const char* Locale() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* value = std::getenv(name);
    if (value && *value) return value;
  }
  return "C";
}

bool IsShortcut(xkb_state* state, uint32_t keycode) {
  static constexpr std::array<const char*, 3> kModifiers = {XKB_MOD_NAME_CTRL, XKB_MOD_NAME_ALT,
                                                            XKB_MOD_NAME_LOGO};
  return std::any_of(kModifiers.begin(), kModifiers.end(), [&](const char* name) {
    const xkb_mod_index_t index = xkb_keymap_mod_get_index(xkb_state_get_keymap(state), name);
    if (index == XKB_MOD_INVALID) return false;
    return xkb_state_mod_index_is_active(state, index, XKB_STATE_MODS_EFFECTIVE) > 0 &&
           !xkb_state_mod_index_is_consumed(state, keycode, index);
  });
}

/// What `get` (as snprintf) writes, without control characters.
template <typename Get>
std::string Printable(const Get& get) {
  std::array<char, 64> buffer{};
  const int length = get(buffer.data(), buffer.size());
  if (length <= 0 || static_cast<size_t>(length) >= buffer.size()) return "";
  std::string text(buffer.data(), static_cast<size_t>(length));
  const auto is_control = [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f;
  };
  return std::any_of(text.begin(), text.end(), is_control) ? "" : text;
}

}  // namespace

void ComposedText::Unref::operator()(xkb_compose_state* state) const {
  xkb_compose_state_unref(state);
}
void ComposedText::Unref::operator()(xkb_compose_table* table) const {
  xkb_compose_table_unref(table);
}

ComposedText::ComposedText(xkb_context* context)
    : table_(xkb_compose_table_new_from_locale(context, Locale(), XKB_COMPOSE_COMPILE_NO_FLAGS)),
      compose_(table_ ? xkb_compose_state_new(table_.get(), XKB_COMPOSE_STATE_NO_FLAGS) : nullptr) {
}
ComposedText::~ComposedText() = default;
ComposedText::ComposedText(ComposedText&&) noexcept = default;
ComposedText& ComposedText::operator=(ComposedText&&) noexcept = default;

std::string ComposedText::Press(xkb_state* state, uint32_t keycode) {
  if (IsShortcut(state, keycode)) return "";
  const xkb_keysym_t symbol = xkb_state_key_get_one_sym(state, keycode);
  if (compose_ && xkb_compose_state_feed(compose_.get(), symbol) == XKB_COMPOSE_FEED_ACCEPTED) {
    const xkb_compose_status status = xkb_compose_state_get_status(compose_.get());
    if (status == XKB_COMPOSE_COMPOSING || status == XKB_COMPOSE_CANCELLED) return "";
    if (status == XKB_COMPOSE_COMPOSED) {
      return Printable([&](char* to, size_t size) {
        return xkb_compose_state_get_utf8(compose_.get(), to, size);
      });
    }
  }
  return Printable(
      [&](char* to, size_t size) { return xkb_state_key_get_utf8(state, keycode, to, size); });
}

void ComposedText::Forget() {
  if (compose_) xkb_compose_state_reset(compose_.get());
}

}  // namespace parti::input
