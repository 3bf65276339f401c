// Plays a drawing into a session: device events become strokes in the view, commands run after the
// stroke that they are keyed to.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/session.h"
#include "input/drawing.h"
#include "input/pen_bindings.h"
#include "input/strokes_from_events.h"

namespace parti::app {

/// How a replay went; and a way to look on.
struct ReplayReport {
  size_t strokes = 0;         ///< that reached the session
  size_t segments = 0;        ///< straight or curved pieces of them
  std::vector<Error> unread;  ///< strokes that meant nothing; they stay as ink
  /// Called before each command, with the session as it is then; may be empty. A failure stops.
  std::function<Result<void>(const Command&)> before_command;
};

/// Events one by one, as devices send them, into strokes of a session. What draws are the drags
/// that draw in the application with its usual bindings: the tip of a pen, the left button of a
/// mouse; not the eraser, which drawings have as `erase` commands, nor drags that look or select.
class Player {
 public:
  /// Both must outlive it.
  Player(Session* session, ReplayReport* report) : session_(session), report_(report) {}

  /// Strokes that this event completes reach the session.
  void Feed(const InputEvent& event);
  /// A command as text. errors  those of ParseCommand, before_command and Session::Execute.
  Result<void> Execute(const std::string& command);
  /// The end of the stream: what is being drawn is a stroke.
  void Finish();

  /// Completed strokes of any kind: what a drawing's commands are keyed to.
  int strokes() const { return strokes_; }

 private:
  void Draw(const input::PenStroke& stroke);

  Session* session_;
  ReplayReport* report_;
  input::StrokesFromEvents machine_;
  input::PenBindings bindings_;
  std::map<int, DeviceFacts> devices_;
  std::map<int, input::PenAct> acts_;  // what the stroke of a device does that goes on or has ended
  int strokes_ = 0;
};

/// A whole drawing.
/// errors  of the first command that fails, with its place in the drawing; everything before it has
///         been played.
Result<void> Replay(const input::Drawing& drawing, Session* session, ReplayReport* report);

}  // namespace parti::app
