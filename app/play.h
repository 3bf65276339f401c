// Plays a drawing through the application as if its devices were there: for tests, for looking at
// a bug report, and for pictures of a session.
// Without an application, and quicker, `parti replay` plays it into a session (replay.h).
#pragma once

#include "app/application.h"
#include "input/drawing.h"

namespace parti::app {

/// Feeds every event of the drawing in order, as fast as it is handled, and its commands where they
/// stand. Before a command, and at the end, everything that came before has been executed. Ends
/// early when the application is asked to close.
/// errors  those of Application::Turn;  a command that ParseCommand can't read, with its place.
Result<void> Play(const input::Drawing& drawing, Application* application);

/// Turns until nothing is left to do, or the application is asked to close; at most so long.
/// errors  those of Application::Turn;  kLimitReached  it took longer.
Result<void> Settle(Application* application, double most_s = 60);

}  // namespace parti::app
