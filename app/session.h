// One session: takes strokes and commands, gives state. The application, `parti replay` and the
// tests drive this same class; panels are views on its state and send it commands.
// Not responsible for devices (input/), pictures (render/) or files (app/document).
#pragma once

#include <vector>

#include "app/session_state.h"

namespace parti::app {

/// The one place where state changes. Not thread-safe; states that were handed out stay as they
/// are.
class Session {
 public:
  explicit Session(sketch::SketchParameters parameters = {});
  /// Goes on with a model that was opened.
  Session(Model model, const Camera& camera, sketch::SketchParameters parameters = {});

  const SessionState& state() const { return state_; }
  /// Everything that was done, in order: what a document keeps and a drawing replays.
  const std::vector<HistoryEntry>& history() const { return history_; }

  /// A finished stroke in the pixels of the current view. The shape that it is drawn on is found,
  /// its lines are lifted, and the suggestions are those of all strokes since the last pick.
  /// A stroke that means nothing is kept as ink; the error says why.
  /// errors  kTooShort  a tap;  kNoFit  no visible shape or operation fits;  kNothingMade  no lot.
  Result<void> AddStroke(const Stroke& stroke);

  /// A command that fails changes nothing.
  Result<void> Execute(const Command& command);

 private:
  Result<SessionState> After(const Command& command) const;
  /// Undo and redo go through strokes and commands alike, except views: looking is not a change.
  void Remember();

  sketch::SketchParameters parameters_;
  SessionState state_;
  std::vector<SessionState> undo_, redo_;
  std::vector<HistoryEntry> history_;
};

}  // namespace parti::app
