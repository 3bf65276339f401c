// One session: takes strokes and commands, gives state. The application, `parti replay` and the
// tests drive this same class; panels are views on its state and send it commands.
// Not responsible for devices (input/), pictures (render/) or files (app/document).
#pragma once

#include <vector>

#include "app/command.h"
#include "app/session_options.h"
#include "app/session_state.h"
#include "app/timeline.h"

namespace parti::app {

/// The one place where state changes. Not thread-safe; states that were handed out stay as they
/// are.
class Session {
 public:
  explicit Session(SessionOptions options = {});
  /// Goes on with a model that was opened.
  Session(Model model, const Camera& camera, SessionOptions options = {});
  /// Goes on where a document left, undo and redo included. `strokes_drawn` is one more than the
  /// number of the last stroke that was ever drawn in it.
  Session(Timeline timeline, uint32_t strokes_drawn, SessionOptions options = {});

  const SessionState& state() const { return timeline_.present(); }
  /// The steps that undo and redo go through.
  const Timeline& timeline() const { return timeline_; }
  uint32_t strokes_drawn() const { return strokes_drawn_; }

  /// Everything that was done, in order: what a document keeps and a drawing replays.
  const std::vector<HistoryEntry>& history() const { return history_; }
  /// For those who have written it elsewhere: memory then does not grow with use.
  void ForgetHistory() { history_.clear(); }

  /// A finished stroke in the pixels of the current view. The shape that it is drawn on is found,
  /// its lines are lifted, and the suggestions are those of all strokes since the last pick.
  /// A stroke that means nothing is kept as ink; the error says why. Without a lot, strokes outline
  /// one on the ground; the lot that they close is in the history as a command.
  /// errors  kTooShort  a tap;  kNoFit  no visible shape or operation fits, or the outline of the
  ///         lot is not closed yet;  those of LotFromStrokes.
  Result<void> AddStroke(const Stroke& stroke);

  /// A command that fails changes nothing. Undo and redo go through strokes and commands alike,
  /// except those that only look (IsLooking) or change nothing; the view stays.
  Result<void> Execute(const Command& command);

 private:
  Result<void> StepTo(bool back);

  SessionOptions options_;
  Timeline timeline_;
  uint32_t strokes_drawn_ = 0;
  std::vector<HistoryEntry> history_;
};

}  // namespace parti::app
