// A window on an X server that OpenGL draws into, with what desktops want to know of one.
// Input is input/x11_source.h's; the loop that reads events is the display's.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>

#include "render/egl_window.h"
#include "render/x11_connection.h"

union _XEvent;

namespace parti::render {

/// What an event said about the window.
struct X11WindowNews {
  bool resized = false;
  bool exposed = false;
  bool close_asked = false;
  bool hidden = false;
  bool shown = false;
  bool focus_lost = false;
};

/// Destroyed before its connection; sizes in pixels, at least 1 x 1.
class X11Window {
 public:
  /// Shows a window of that size, in pixels at scale 1 (x, y >= 1), or of most of the screen where
  /// that is smaller.
  /// errors  kGraphics  as EglWindow;  kDevice  the server is gone.
  static Result<std::unique_ptr<X11Window>> Create(std::shared_ptr<X11Connection> connection,
                                                   const glm::ivec2& size,
                                                   const std::string& title);
  ~X11Window();
  X11Window(const X11Window&) = delete;
  X11Window& operator=(const X11Window&) = delete;

  EglWindow& context() { return *context_; }
  unsigned long id() const { return id_; }
  glm::ivec2 size_px() const { return size_px_; }
  double scale() const { return scale_; }
  /// Mapped, and not wholly covered.
  bool visible() const { return mapped_ && !covered_; }

  /// Shown by the window manager; UTF-8.
  void SetTitle(const std::string& title);
  /// Any event of the connection; those that are not the window's change nothing.
  X11WindowNews Take(const _XEvent& event);

 private:
  X11Window(std::shared_ptr<X11Connection> connection, std::unique_ptr<EglWindow> context,
            unsigned long id, const glm::ivec2& size_px);
  void TellDesktop();
  bool Answer(const _XEvent& message);
  X11WindowNews SetVisible(bool mapped, bool covered);

  std::shared_ptr<X11Connection> connection_;
  std::unique_ptr<EglWindow> context_;
  unsigned long id_;
  glm::ivec2 size_px_;
  double scale_;
  bool mapped_ = false;
  bool covered_ = false;
};

/// How large the desktop wants things: Xft.dpi of `resources` (the text of RESOURCE_MANAGER) over
/// 96, within [0.5, 4]; 1 where it does not say, or nonsense.
double ScaleIn(const std::string& resources);

}  // namespace parti::render
