// How far a gesture or a drag has come: shared by everything that lasts from a touch to a lift.
// Not responsible for what is dragged (gestures.h, pen_bindings.h).
#pragma once

#include <cstdint>

namespace parti::input {

/// Everything that begins either ends, and what it did stays, or is cancelled: it was not meant,
/// and what it did is to be taken back.
enum class DragPhase : uint8_t { kBegin, kMove, kEnd, kCancel };

}  // namespace parti::input
