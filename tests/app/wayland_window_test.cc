// The program on a Wayland desktop: its best display is a window through Xwayland, which Weston
// shows where a mouse draws in it.
#include <gtest/gtest.h>

#include "tests/app/window_driver.h"
#include "tests/support/wayland.h"

namespace parti::tests {
namespace {

class WaylandWindowTest : public WindowDriver {
 protected:
  /// Weston in a window sometimes sees no mouse at all: then another is started.
  void SetUp() override {
    for (int attempt = 0; attempt < 4; ++attempt) {
      Begin();
      if (IsSkipped() || HasFatalFailure() || ComesToFollowTheMouse()) return;
      TearDown();
      desktop_.reset();
    }
    FAIL() << "Weston sees no mouse";
  }

  void Begin() {
    std::string why;
    desktop_ = WaylandDesktop::Start({1280, 800}, &why);
    if (!desktop_) GTEST_SKIP() << why;
    Open(desktop_->server(), &desktop_->screen(), desktop_->environment(), "best");
  }

  bool ComesToFollowTheMouse() const {
    for (int i = 0; i < 12; ++i) {
      if (FollowsTheMouse()) return true;
    }
    return false;
  }

  /// Whether a way of the mouse, which comes from beside the desktop, is one of the pointer in it.
  bool FollowsTheMouse() const {
    const Xvfb& screen = desktop_->screen();
    EXPECT_TRUE(screen.Do(
        {"mousemove", "1310", "830", "sleep", "0.1", "mousemove", "500", "300", "sleep", "0.2"}));
    const glm::ivec2 from = look_->Pointer();
    EXPECT_TRUE(screen.Do({"mousemove", "640", "400", "sleep", "0.2"}));
    return look_->Pointer() - from == glm::ivec2(140, 100);
  }

  render::Image Screen() const {
    XSpectator screen(desktop_->screen().name());
    return screen.Picture(screen.root());
  }

  std::unique_ptr<WaylandDesktop> desktop_;
};

/// Whether ink, and nothing paler, is within a few pixels of a place.
bool HasInkAt(const render::Image& image, const Vec2& px) {
  constexpr int kNear = 3, kDark = 110;
  for (int y = -kNear; y <= kNear; ++y) {
    for (int x = -kNear; x <= kNear; ++x) {
      const int column = static_cast<int>(px.x) + x, row = static_cast<int>(px.y) + y;
      const uint8_t* pixel = &image.pixels[size_t{4} * (row * image.width + column)];
      if (pixel[0] < kDark && pixel[1] < kDark && pixel[2] > pixel[0]) return true;
    }
  }
  return false;
}

TEST_F(WaylandWindowTest, AMouseDrawsAndItsInkIsSeenWhereItWas) {
  const Vec2 from(700, 250), to(420, 130);
  const render::Image before = Screen();
  Press(from, to);
  Release();
  ASSERT_TRUE(WaitForSafe(at_start_ + 1)) << Errors();
  Rest();
  const render::Image after = Screen();
  ASSERT_GE(after.width, 1280);
  for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const Vec2 at = from + (to - from) * part;
    EXPECT_FALSE(HasInkAt(before, at)) << part;
    EXPECT_TRUE(HasInkAt(after, at)) << part;
  }
  EXPECT_EQ(Closed().strokes.size(), 1u);
}

TEST_F(WaylandWindowTest, ADesktopThatCrashesLosesNothingThatWasAcknowledged) {
  Press({700, 250}, {420, 130});
  Release();
  ASSERT_TRUE(WaitForSafe(at_start_ + 1)) << Errors();
  look_.reset();
  desktop_->Kill();
  EXPECT_TRUE(Until([&] { return program_->Ended().has_value(); }));
  const auto document = app::OpenDocument(File());
  ASSERT_TRUE(document) << FormatError(document.error());
  EXPECT_EQ(document->strokes.size(), 1u);
}

}  // namespace
}  // namespace parti::tests
