// A connection to an X server that may break without ending the program.
// What is shown over it is x11_window.h's, what is typed and drawn input/x11_source.h's.
#pragma once

#include <memory>
#include <string>

#include "base/error.h"

struct _XDisplay;

namespace parti::render {

/// Xlib's Display; X11/Xlib.h itself stays out of headers, for its macros.
using XDisplay = _XDisplay;

/// Used by one thread. Protocol errors are dropped: windows and devices vanish while one asks about
/// them, and the answers are looked at. A broken connection is told by lost() instead of ending the
/// program, as Xlib would have it.
class X11Connection {
 public:
  /// `name` as in DISPLAY; empty: DISPLAY itself.
  /// errors  kDevice  there is no such server, or it refuses; says which and the remedy.
  static Result<std::shared_ptr<X11Connection>> Open(const std::string& name = "");

  ~X11Connection();
  X11Connection(const X11Connection&) = delete;
  X11Connection& operator=(const X11Connection&) = delete;

  XDisplay* get() const { return display_; }
  const std::string& name() const { return name_; }  ///< ":0"
  /// Whether the server is gone; Xlib's calls then do nothing.
  bool lost() const { return lost_; }
  /// What to tell a person then.
  Error WhyLost() const;

 private:
  X11Connection(XDisplay* display, std::string name);

  XDisplay* display_;
  std::string name_;
  bool lost_ = false;
};

}  // namespace parti::render
