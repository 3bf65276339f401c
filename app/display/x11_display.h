// A window on a desktop: X11's, also where a Wayland desktop shows it through Xwayland.
// The parts are render/x11_window.h and input/x11_source.h; this joins them.
#pragma once

#include <memory>
#include <string>

#include "app/display/display.h"

namespace parti::app {

/// As the window should come up.
struct X11Spec {
  std::string server;  ///< as in DISPLAY; empty: DISPLAY itself
  /// In pixels at scale 1; less where the screen is smaller; the user may change it.
  glm::ivec2 size{1600, 1000};
  std::string title = "Parti";  ///< UTF-8
  /// Frames are shown without waiting for the screen, so that ink is as late as it must be, but
  /// no oftener than this; half the time between two pictures of a usual screen. [s]
  double least_frame_s = 1.0 / 120;
};

/// errors  kDevice  no server, or one that refuses, or is too old;  kGraphics  no OpenGL ES 3.0.
Result<std::unique_ptr<Display>> OpenX11Display(const X11Spec& spec = {});

}  // namespace parti::app
