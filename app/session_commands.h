// What each command makes of a session's state: pure functions, one for each kind of command.
// Undo, redo and what is remembered are session.h's.
#pragma once

#include <optional>

#include "app/command.h"
#include "app/session_options.h"
#include "app/session_state.h"

namespace parti::app {

/// The state after a command that is neither undo nor redo. An edit that the node edited can't
/// carry out on any shape is refused; nodes behind it that no longer fit stay, and become problems
/// (ProblemsOf).
/// errors  those of the command's parts, each with its remedy.
Result<SessionState> After(const SessionState& state, const Command& command,
                           const SessionOptions& options);

/// What came of a stroke.
struct StrokeOutcome {
  SessionState state;  ///< with the stroke in its sketch, or among the unread ones
  Result<void> read;   ///< why it means nothing
  /// The command that does the same: the lot, where the stroke closed its outline.
  std::optional<SetLot> begun = {};
};
/// On a model without lots, strokes outline the first one (LotFromStrokes).
/// errors (of `read`)  those of ReadSketch, or of LotFromStrokes.
StrokeOutcome AfterStroke(SessionState state, std::shared_ptr<const DrawnStroke> stroke,
                          const SessionOptions& options);

}  // namespace parti::app
