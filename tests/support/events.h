// Input events for tests: short ways to write them, and arbitrary valid ones for properties.
#pragma once

#include <rapidcheck.h>

#include <string_view>
#include <vector>

#include "base/event.h"
#include "input/drawing.h"

namespace parti::tests {

DeviceEvent PenAdded(int device = 0, double t_s = 0);
PenEvent Pen(PenEvent::Kind kind, double t_s, Vec2 position_mm, int device = 0);

/// "0,0 10,0 10,8" drawn as one stroke of device 0, from proximity to proximity, 10 ms a sample.
std::vector<InputEvent> StrokeEvents(std::string_view points_mm, double start_s);

/// Any drawing that the rules allow: several devices of any facts, all kinds of events, commands.
rc::Gen<input::Drawing> ArbitraryDrawing();

}  // namespace parti::tests
