// libinput's devices and events as the values of base/event.h.
// Not responsible for numbering devices, for the order of times, or for what keys type
// (libinput_source.h, keyboard.h).
#pragma once

#include <libinput.h>

#include <optional>

#include "base/event.h"
#include "input/pointer_position.h"

namespace parti::input {

/// Whether the device is a pen tablet or a touch screen.
bool IsPenOrTouch(libinput_device* device);

/// Whether it is a mouse, a touchpad or a keyboard.
bool IsMouseOrKeys(libinput_device* device);

/// Whether keys come from it, however few: those of pads of numbers and power buttons, too.
bool SendsKeys(libinput_device* device);

/// Whether it has switches, as of a lid or of a keyboard that folds away.
bool IsSwitch(libinput_device* device);

/// Axes are read from the kernel's capability masks in sysfs, since libinput tells them only for a
/// tool that is in proximity.
DeviceFacts FactsOf(libinput_device* device);

/// t_s is the event's own time. Nothing for a totem or an event that is not a pen's.
std::optional<PenEvent> PenEventOf(libinput_event* event, int device);

/// For ups and cancels the position is left at 0: libinput does not say it.
/// Nothing for frame marks and events that are not a touch screen's.
std::optional<TouchEvent> TouchEventOf(libinput_event* event, int device);

/// A mouse's motion or button, as a PenEvent of tool kMouse; moves the pointer.
/// Nothing for events that are not a mouse's.
std::optional<PenEvent> MouseEventOf(libinput_event* event, int device, PointerPosition* pointer);

/// Nothing for events that are not a wheel's or a touchpad's, and for the ends of scrolling.
std::optional<ScrollEvent> ScrollEventOf(libinput_event* event, int device,
                                         const PointerPosition& pointer);

/// A key's press or release, without its text; the code is that of its place. Nothing for events
/// that are not a keyboard's.
std::optional<KeyEvent> KeyEventOf(libinput_event* event, int device);

}  // namespace parti::input
