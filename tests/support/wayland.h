// A Wayland desktop of the test's own, without a screen: Weston in a window of an Xvfb, so that a
// mouse can be moved and the screen be looked at, with Xwayland in it for programs of X.
// What a program does there is its tests'.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/support/xvfb.h"

namespace parti::tests {

/// Ended when the value goes.
class WaylandDesktop {
 public:
  /// Nothing where the machine has no Weston or no Xwayland, or they do not come up within seconds;
  /// `why` then says so.
  static std::unique_ptr<WaylandDesktop> Start(const glm::ivec2& size_px, std::string* why);
  ~WaylandDesktop();

  /// What a program on this desktop has in its environment: "DISPLAY=:7", "WAYLAND_DISPLAY=…".
  std::vector<std::string> environment() const;
  const std::string& server() const { return server_; }  ///< Xwayland's name: ":7"
  const Xvfb& screen() const { return *screen_; }        ///< with the desktop's mouse and pixels
  /// Ends the desktop, as one that crashes.
  void Kill() { weston_.reset(); }

 private:
  WaylandDesktop(std::string folder, std::unique_ptr<Xvfb> screen)
      : folder_(std::move(folder)), screen_(std::move(screen)) {}
  bool Begin(const glm::ivec2& size_px);

  std::string folder_;
  std::unique_ptr<Xvfb> screen_;
  std::unique_ptr<Child> weston_;
  std::string server_;
};

}  // namespace parti::tests
