#include "input/keyboard.h"

#include <xkbcommon/xkbcommon.h>

#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/text_file.h"
#include "input/key_typing.h"

namespace parti::input {
namespace {

constexpr const char* kConfiguration = "/etc/default/keyboard";

template <auto release>
struct Release {
  template <typename Value>
  void operator()(Value* value) const {
    release(value);
  }
};

const char* Named(const std::string& text) { return text.empty() ? nullptr : text.c_str(); }

}  // namespace

KeyLayout LayoutOf(const std::string& configuration) {
  KeyLayout layout;
  const std::array<std::pair<std::string_view, std::string*>, 4> names{
      {{"XKBMODEL=", &layout.model},
       {"XKBLAYOUT=", &layout.layout},
       {"XKBVARIANT=", &layout.variant},
       {"XKBOPTIONS=", &layout.options}}};
  std::istringstream lines(configuration);
  for (std::string line; std::getline(lines, line);) {
    for (const auto& [name, value] : names) {
      if (!line.starts_with(name)) continue;
      *value = line.substr(name.size());
      std::erase(*value, '"');
      std::erase(*value, '\r');
    }
  }
  return layout;
}

KeyLayout SystemLayout() {
  if (!std::getenv("XKB_DEFAULT_LAYOUT")) {
    if (const auto text = ReadFile(kConfiguration)) return LayoutOf(*text);
  }
  return {};  // xkbcommon reads the environment itself
}

struct Keyboard::State {
  std::unique_ptr<xkb_context, Release<xkb_context_unref>> context;
  std::unique_ptr<xkb_keymap, Release<xkb_keymap_unref>> keymap;
  std::unique_ptr<xkb_state, Release<xkb_state_unref>> keys;
  std::optional<KeyTyping> typing;
  std::map<uint32_t, uint32_t> held;  // codes by place
};

Keyboard::Keyboard(const KeyLayout& layout) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.context.reset(xkb_context_new(XKB_CONTEXT_NO_FLAGS));
  if (!s.context) return;
  xkb_context_set_log_level(s.context.get(), XKB_LOG_LEVEL_CRITICAL);
  const xkb_rule_names names{nullptr, Named(layout.model), Named(layout.layout),
                             Named(layout.variant), Named(layout.options)};
  for (const xkb_rule_names* tried : {&names, static_cast<const xkb_rule_names*>(nullptr)}) {
    if (s.keymap) break;
    s.keymap.reset(xkb_keymap_new_from_names(s.context.get(), tried, XKB_KEYMAP_COMPILE_NO_FLAGS));
  }
  if (s.keymap) s.keys.reset(xkb_state_new(s.keymap.get()));
  if (s.keys) s.typing.emplace(s.context.get());
}

Keyboard::Keyboard(Keyboard&&) noexcept = default;
Keyboard& Keyboard::operator=(Keyboard&&) noexcept = default;
Keyboard::~Keyboard() = default;

Keystroke Keyboard::Feed(uint32_t place, bool pressed) {
  if (!state_->keys) return {place};
  xkb_state* keys = state_->keys.get();
  const uint32_t key = place + kXkbOffset;
  Keystroke made;
  if (pressed) {
    made.code = state_->held[place] = CodeOf(keys, place);
    made.text = state_->typing->Press(keys, key);
  } else {
    const auto held = state_->held.extract(place);
    made.code = held ? held.mapped() : CodeOf(keys, place);
  }
  xkb_state_update_key(keys, key, pressed ? XKB_KEY_DOWN : XKB_KEY_UP);
  return made;
}

bool Keyboard::Repeats(uint32_t place) const {
  return state_->keymap && xkb_keymap_key_repeats(state_->keymap.get(), place + kXkbOffset) != 0;
}

}  // namespace parti::input
