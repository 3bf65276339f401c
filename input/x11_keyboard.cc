#include "input/x11_keyboard.h"

#include <X11/XKBlib.h>
#include <X11/Xlib-xcb.h>
#include <X11/Xlib.h>
#include <xkbcommon/xkbcommon-x11.h>
#include <xkbcommon/xkbcommon.h>

namespace parti::input {

void X11Keyboard::Unref::operator()(xkb_context* context) const { xkb_context_unref(context); }
void X11Keyboard::Unref::operator()(xkb_state* state) const { xkb_state_unref(state); }

X11Keyboard::X11Keyboard(_XDisplay* display)
    : display_(display), context_(xkb_context_new(XKB_CONTEXT_NO_FLAGS)) {
  int opcode = 0, error = 0, major = XkbMajorVersion, minor = XkbMinorVersion;
  if (!context_ || !XkbQueryExtension(display_, &opcode, &first_event_, &error, &major, &minor)) {
    first_event_ = 0;
    return;
  }
  XkbSelectEvents(display_, XkbUseCoreKbd, XkbNewKeyboardNotifyMask | XkbMapNotifyMask,
                  XkbNewKeyboardNotifyMask | XkbMapNotifyMask);
  typing_.emplace(context_.get());
  Load();
}

X11Keyboard::~X11Keyboard() = default;

void X11Keyboard::Load() {
  state_.reset();
  xcb_connection_t* connection = XGetXCBConnection(display_);
  xkb_x11_setup_xkb_extension(connection, XKB_X11_MIN_MAJOR_XKB_VERSION,
                              XKB_X11_MIN_MINOR_XKB_VERSION, XKB_X11_SETUP_XKB_EXTENSION_NO_FLAGS,
                              nullptr, nullptr, nullptr, nullptr);
  const int32_t device = xkb_x11_get_core_keyboard_device_id(connection);
  if (device < 0) return;
  xkb_keymap* keymap = xkb_x11_keymap_new_from_device(context_.get(), connection, device,
                                                      XKB_KEYMAP_COMPILE_NO_FLAGS);
  if (!keymap) return;
  state_.reset(xkb_state_new(keymap));
  xkb_keymap_unref(keymap);
}

Keystroke X11Keyboard::Press(uint32_t keycode, const X11Modifiers& modifiers) {
  const uint32_t place = keycode - kXkbOffset;
  if (!state_ || !typing_) return {place};
  xkb_state_update_mask(state_.get(), modifiers.pressed, modifiers.latched, modifiers.locked,
                        modifiers.pressed_layout, modifiers.latched_layout,
                        modifiers.locked_layout);
  return {CodeOf(state_.get(), place), typing_->Press(state_.get(), keycode)};
}

void X11Keyboard::Forget() {
  if (typing_) typing_->Forget();
}

bool X11Keyboard::Take(const _XEvent& event) {
  if (first_event_ == 0 || event.type != first_event_) return false;
  const int kind = reinterpret_cast<const XkbEvent&>(event).any.xkb_type;
  if (kind == XkbNewKeyboardNotify || kind == XkbMapNotify) Load();
  return true;
}

}  // namespace parti::input
