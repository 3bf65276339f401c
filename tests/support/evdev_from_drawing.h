// A drawing's pen as the raw events that a real tablet's kernel driver would have sent for it.
#pragma once

#include "input/drawing.h"
#include "tests/support/evdev_recording.h"

namespace parti::tests {

/// The description of a tablet of common make (200 units/mm, 8192 steps of pressure, tilt in 1/100
/// degree, distance, eraser, two buttons) with the facts of the drawing's first pen, and that pen's
/// events: only values that changed are sent, as the kernel does, and the pen comes into proximity
/// where the drawing forgot to say so. Touch, keys and other pens are left out.
/// What libinput makes of it has positions within kPositionError_mm and pressures within
/// kPressureError of the drawing's, but for a kDown, which libinput only takes from 0.041 on;
/// reports that change nothing are gone. errors  kNothingMade  there is no pen.
Result<EvdevRecording> EvdevFromDrawing(const input::Drawing& drawing);

/// The same on a tablet that is already described, in its units and steps; axes that it has not are
/// left out. With ABS_MISC and MSC_SERIAL it also says which pen it is, as Wacom's driver does.
Result<EvdevRecording> EvdevFromDrawing(const input::Drawing& drawing, EvdevRecording tablet);

inline constexpr double kPositionError_mm = 0.0026;  // half a unit
inline constexpr double kPressureError = 0.0005;     // a few steps: libinput's threshold's rounding

}  // namespace parti::tests
