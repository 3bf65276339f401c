// Numbers that a session is given: how sketches are read, and how much undo keeps.
// What a person sets and finds again is settings.h's.
#pragma once

#include <cstddef>

#include "app/lot_from_stroke.h"
#include "sketch/parameters.h"

namespace parti::app {

/// How far undo goes back.
struct UndoLimits {
  /// Most steps behind the present one, [1, 1e6]. Chosen: a long day's strokes and picks.
  size_t steps = 1000;
  /// Memory that the steps may take besides the present one [bytes, estimated]. Past it, distant
  /// steps first keep only their records, and are derived again when undo comes to them; then the
  /// oldest are forgotten. Chosen: an eighth of a small tablet's 2 GB.
  size_t bytes = size_t{256} << 20;
};

/// All of a session's numbers.
struct SessionOptions {
  sketch::SketchParameters sketch = {};
  LotParameters lot = {};
  UndoLimits undo = {};
  /// Keep SessionState::steps, for `replay --json` and bug reports; they grow with every pick.
  bool keep_steps = false;
};

}  // namespace parti::app
