// One input event as one line of a drawing, and back, without loss (docs/drawings.md).
// Not responsible for whether an event may stand where it does (drawing_rules.h).
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "base/event.h"

namespace parti::input {

/// `pen 0 move 0.0152 120.5,60.25 p=0.31 tilt=12,-3`: no line break at the end. Numbers have as
/// many digits as it takes to read the same double again.
std::string EventText(const InputEvent& event);

/// Whether a line's first word makes it an event's line: device, pen, touch, key or scroll.
bool IsEventWord(std::string_view word);

/// Property  ReadEvent(EventText(e)) == e for every event of finite numbers.
/// errors    kDamagedFile  with its column in `line`; the place's line number is 1, its file empty.
Result<InputEvent> ReadEvent(std::string_view line);

}  // namespace parti::input
