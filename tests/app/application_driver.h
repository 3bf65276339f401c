// The whole application under test, on a display in memory: its devices are plugged in, its pens,
// mice and fingers moved, and waited for until nothing is left to do.
// What is on the display before is each test's; panels alone are panels_driver.h's.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "app/application.h"
#include "app/display/offscreen_display.h"

namespace parti::app::tests {

/// A fixture. The view has 1600 x 1000 px; tablet and touch screen are 160 x 100 mm.
class ApplicationDriver : public testing::Test {
 protected:
  static constexpr int kPen = 0, kTouch = 1, kMouse = 2, kKeys = 3;

  void SetUp() override;

  /// A pen tablet, a touch screen, a mouse and a keyboard.
  void PlugIn();

  void Settle();
  /// A command as text, and all that comes of it.
  void Do(const std::string& line);

  /// Of device_: its tip, and its button.
  void Pen(PenEvent::Kind kind, const Vec2& px);
  void PressButton(uint32_t button, bool pressed, const Vec2& px);
  void Key(uint32_t code);
  void Finger(TouchEvent::Kind kind, int finger, const Vec2& px);

  /// A line, without lifting the pen.
  void Draw(const Vec2& from, const Vec2& to);
  /// The same by a pen that is near already.
  void DrawOn(const Vec2& from, const Vec2& to);
  void Lift(const Vec2& at);
  /// The whole of it, and all that comes of it.
  void Line(const Vec2& from, const Vec2& to);
  void TapAt(const Vec2& px);
  /// The first target of a panel that begins like this, tapped in its middle; it must be there.
  void TapOn(const std::string& target);

  const SessionState& state() const { return *application_->snapshot().state; }
  /// Where a point of the world is seen.
  Vec2 Pixel(const Vec3& point) const { return *View(application_->camera()).Project(point); }
  /// What panels say.
  std::vector<std::string> Words() const;
  /// The display, drawn anew.
  render::Image Seen();

  std::string folder_;  ///< of the test
  std::unique_ptr<OffscreenDisplay> display_;
  std::unique_ptr<SessionThread> session_;
  std::unique_ptr<Application> application_;
  int device_ = kPen;  ///< kPen or kMouse
  double t_s_ = 1;
};

}  // namespace parti::app::tests
