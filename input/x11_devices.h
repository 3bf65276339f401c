// What an X server says of its input devices, as facts: which is a pen, an eraser, a touch screen,
// a mouse or a keyboard, by the conventions of the wacom, libinput and Xwayland drivers. Not
// responsible for events (x11_source.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/event.h"
#include "input/x11_pointer.h"

struct _XDisplay;

namespace parti::input {

/// One device of the server that Parti listens to.
struct X11Device {
  int id = 0;  ///< the server's number
  DeviceFacts facts;
  PenTool tool = PenTool::kMouse;  ///< of those with has_pen or has_pointer
  std::vector<X11Axis> axes;
  bool buttons_with_tip = false;  ///< as X11PointerFacts has it
};

/// What kind of tool a device's name and the wacom driver's word for it ("STYLUS", "ERASER",
/// "CURSOR", "PAD"; "" where another driver runs it) stand for. Nothing for pads and the like.
///
/// has_pressure  whether it has a valuator of pressure: no mouse has.
std::optional<PenTool> X11ToolOf(const std::string& name, const std::string& wacom_type,
                                 bool has_pressure);

/// Whether the name is that of a button or lid that the kernel gives as a keyboard. What
/// IsKeyboard (key_codes.h) asks can't be asked of a server: it gives every device all keys.
bool IsButtonOnly(const std::string& name);

/// The slaves that are there and enabled, `only` one or all. Their valuators have their present
/// values. px_per_mm becomes view_px_per_mm of those that point.
std::vector<X11Device> ReadX11Devices(_XDisplay* display, double px_per_mm,
                                      std::optional<int> only = std::nullopt);

}  // namespace parti::input
