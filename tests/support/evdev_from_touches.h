// A drawing's fingers as the raw events that a real touch screen's kernel driver would have sent.
#pragma once

#include "input/drawing.h"
#include "tests/support/evdev_recording.h"

namespace parti::tests {

/// `screen` (ABS_MT_SLOT, _TRACKING_ID, _POSITION_X, _POSITION_Y) with the events of all touches of
/// the drawing: each finger in the lowest slot that is free, the first one also as ABS_X, ABS_Y and
/// BTN_TOUCH. Touches beyond the screen's slots are left out; kCancel lifts like kUp.
/// errors  kNothingMade  nobody touches anything.
Result<EvdevRecording> EvdevFromTouches(const input::Drawing& drawing, EvdevRecording screen);

}  // namespace parti::tests
