// An X server of the test's own, without a screen: a display number that is free, a size, and
// synthetic mice and keys. Windows are looked at as another program would.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/image.h"
#include "tests/support/child.h"

namespace parti::tests {

/// Killed when the value goes.
class Xvfb {
 public:
  /// Nothing where the machine has no Xvfb, or it does not come up within seconds; `why` then says
  /// so. The screen is 24 bits deep.
  static std::unique_ptr<Xvfb> Start(const glm::ivec2& size_px, std::string* why);
  ~Xvfb();

  const std::string& name() const { return name_; }  ///< ":7"
  /// Ends the server, as a desktop that crashes.
  void Kill() { server_.reset(); }

  /// Runs xdotool with these words ("mousemove", "10", "20", "click", "1"); false where it fails.
  bool Do(const std::vector<std::string>& words) const;
  /// Gives all keyboards a layout ("de"), as a desktop's settings do; false where it fails.
  bool SetLayout(const std::string& layout) const;

 private:
  Xvfb(std::string folder, std::unique_ptr<Child> server, std::string name);
  bool Run(const std::string& program, const std::vector<std::string>& words) const;

  std::string folder_;
  std::unique_ptr<Child> server_;
  std::string name_;
};

/// Removes the lock and the socket that a server which was killed leaves where X's protocol has
/// them.
void RemoveTracesOf(const std::string& server);

/// Another client of the server, which finds and looks at the windows of the program under test.
class XSpectator {
 public:
  explicit XSpectator(const std::string& server);
  ~XSpectator();
  XSpectator(const XSpectator&) = delete;
  XSpectator& operator=(const XSpectator&) = delete;

  /// The window whose WM_CLASS is `of_class`, in a window manager's frame or without; waits up to
  /// seconds for it. 0: there is none.
  unsigned long Find(const std::string& of_class);
  unsigned long root() const;  ///< the window that is all of the screen
  /// What the server shows in it, opaque. Empty where the window is not seen.
  render::Image Picture(unsigned long window);
  std::string Text(unsigned long window, const std::string& property);  ///< "" where it has none
  /// Longs of a property of format 32.
  std::vector<unsigned long> Cardinals(unsigned long window, const std::string& property);
  void SetRootText(const std::string& property, const std::string& text);
  glm::ivec2 Pointer() const;  ///< where the server has it
  void Resize(unsigned long window, const glm::ivec2& size_px);
  void SetShown(unsigned long window, bool shown);
  /// As a window manager does when its cross is clicked.
  void AskToClose(unsigned long window);
  void Focus(std::optional<unsigned long> window);  ///< nothing: the root

 private:
  void* display_;
};

}  // namespace parti::tests
