// What `libinput debug-events` prints of a mocked tablet: libinput's own word to hold ours against.
#pragma once

#include <optional>
#include <vector>

#include "base/error.h"
#include "base/event.h"
#include "tests/support/evdev_recording.h"

namespace parti::tests {

/// One line about a pen. Numbers have two decimals.
struct PenLine {
  PenEvent::Kind kind = PenEvent::Kind::kMotion;
  std::optional<Vec2> position_mm = {};  ///< not printed for buttons
  std::optional<double> pressure = {};   ///< printed when the distance is 0
};

/// Its lines about pens, in order, while it is played the recording. With libinput's smoothing as
/// libinput has it, unless an Unsmoothed lives.
/// errors  as MockTablet::Run.
Result<std::vector<PenLine>> PlayToDebugEvents(const EvdevRecording& recording);

}  // namespace parti::tests
