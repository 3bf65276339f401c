// Plays a drawing into a session: device events become strokes in the view, commands run after the
// stroke that they are keyed to.
#pragma once

#include <functional>
#include <vector>

#include "app/session.h"
#include "input/drawing.h"

namespace parti::app {

/// How a replay went; and a way to look on.
struct ReplayReport {
  size_t strokes = 0;         ///< that reached the session
  size_t segments = 0;        ///< straight or curved pieces of them
  std::vector<Error> unread;  ///< strokes that meant nothing; they stay as ink
  /// Called before each command, with the session as it is then; may be empty. A failure stops.
  std::function<Result<void>(const Command&)> before_command;
};

/// Eraser strokes and strokes of other tools than a pen are not drawn.
/// errors  of the first command that fails, with its place in the drawing; everything before it has
///         been played.
Result<void> Replay(const input::Drawing& drawing, Session* session, ReplayReport* report);

}  // namespace parti::app
