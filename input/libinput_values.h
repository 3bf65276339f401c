// libinput's devices and events as the values of base/event.h.
// Not responsible for numbering devices, or for the order of times (libinput_source.h).
#pragma once

#include <libinput.h>

#include <optional>

#include "base/event.h"

namespace parti::input {

/// Whether Parti listens to the device: a pen tablet or a touch screen.
bool IsPenOrTouch(libinput_device* device);

/// Axes are read from the kernel's capability masks in sysfs, since libinput tells them only for a
/// tool that is in proximity.
DeviceFacts FactsOf(libinput_device* device);

/// t_s is the event's own time. Nothing for a totem or an event that is not a pen's.
std::optional<PenEvent> PenEventOf(libinput_event* event, int device);

/// For ups and cancels the position is left at 0: libinput does not say it.
/// Nothing for frame marks and events that are not a touch screen's.
std::optional<TouchEvent> TouchEventOf(libinput_event* event, int device);

}  // namespace parti::input
