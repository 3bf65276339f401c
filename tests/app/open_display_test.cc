// Which display is opened, and what is said where there is none: every message with its remedy.
#include "app/display/open_display.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "app/display/seat.h"
#include "app/display/wake_watch.h"
#include "tests/support/xvfb.h"

namespace parti::app {
namespace {

/// An environment variable with another value, or none, for the time of a test.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    value ? ::setenv(name, value, 1) : ::unsetenv(name);
  }
  ~Variable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

bool HasCards() { return std::filesystem::exists("/dev/dri"); }

TEST(OpenDisplays, KindsHaveNames) {
  EXPECT_EQ(*DisplayKindOf("best"), DisplayKind::kBest);
  EXPECT_EQ(*DisplayKindOf("kms"), DisplayKind::kKms);
  EXPECT_EQ(*DisplayKindOf("x11"), DisplayKind::kX11);
  EXPECT_EQ(*DisplayKindOf("offscreen"), DisplayKind::kOffscreen);
  const auto meant = DisplayKindOf("x1");
  ASSERT_FALSE(meant);
  EXPECT_EQ(meant.error().code, ErrorCode::kUnknownName);
  EXPECT_EQ(meant.error().hint, "did you mean x11?");
  EXPECT_EQ(DisplayKindOf("mir").error().hint, "use best, kms, x11 or offscreen");
}

TEST(OpenDisplays, WaylandIsReachedThroughXwayland) {
  const auto kind = DisplayKindOf("wayland");
  ASSERT_FALSE(kind);
  EXPECT_NE(kind.error().hint.find("--display x11"), std::string::npos);
}

TEST(OpenDisplays, OffscreenNeedsNothing) {
  DisplaySpec spec;
  spec.offscreen.size_px = {64, 48};
  const auto display = OpenDisplay(DisplayKind::kOffscreen, spec);
  ASSERT_TRUE(display) << FormatError(display.error());
  EXPECT_EQ((*display)->name(), "offscreen");
  EXPECT_EQ((*display)->size_px(), glm::ivec2(64, 48));
}

TEST(OpenDisplays, TheBestOneIsAWindowWhereThereIsAnXServer) {
  std::string why;
  const auto server = parti::tests::Xvfb::Start({640, 480}, &why);
  if (!server) GTEST_SKIP() << why;
  const Variable display("DISPLAY", server->name().c_str());
  const auto opened = OpenDisplay(DisplayKind::kBest);
  ASSERT_TRUE(opened) << FormatError(opened.error());
  EXPECT_EQ((*opened)->name(), "x11");
  EXPECT_NE((*opened)->Description().find(server->name()), std::string::npos);
}

TEST(OpenDisplays, AServerThatRefusesIsNamedWithTheScreenThatIsNotThere) {
  if (HasCards()) GTEST_SKIP() << "this machine has a screen; it is left alone";
  const Variable display("DISPLAY", ":987"), wayland("WAYLAND_DISPLAY", nullptr);
  const auto opened = OpenDisplay(DisplayKind::kBest);
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().message.find(":987"), std::string::npos);
  EXPECT_NE(opened.error().message.find("/dev/dri"), std::string::npos);
  EXPECT_NE(opened.error().hint.find("XAUTHORITY"), std::string::npos);
}

TEST(OpenDisplays, AWaylandDesktopIsNotRobbedOfItsScreen) {
  const Variable display("DISPLAY", ":987"), wayland("WAYLAND_DISPLAY", "wayland-0");
  const auto opened = OpenDisplay(DisplayKind::kBest);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().message.find("screen"), std::string::npos);
  EXPECT_NE(opened.error().hint.find("XAUTHORITY"), std::string::npos);
}

TEST(OpenDisplays, AWaylandDesktopWithoutXwaylandIsExplained) {
  const Variable display("DISPLAY", nullptr), wayland("WAYLAND_DISPLAY", "wayland-0");
  const auto opened = OpenDisplay(DisplayKind::kBest);
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().hint.find("xwayland"), std::string::npos);
}

TEST(OpenDisplays, WithoutDisplayX11SaysWhatIsNotSet) {
  const Variable display("DISPLAY", nullptr);
  const auto opened = OpenDisplay(DisplayKind::kX11);
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::kDevice);
  EXPECT_NE(opened.error().message.find("DISPLAY is not set"), std::string::npos);
  EXPECT_NE(opened.error().hint.find("--display kms"), std::string::npos);
}

TEST(OpenDisplays, AMachineWithoutScreensIsExplained) {
  if (HasCards()) GTEST_SKIP() << "this machine has a screen; it is left alone";
  const Variable display("DISPLAY", nullptr), wayland("WAYLAND_DISPLAY", nullptr);
  const auto kms = OpenDisplay(DisplayKind::kKms), best = OpenDisplay(DisplayKind::kBest);
  ASSERT_FALSE(kms);
  EXPECT_NE(kms.error().message.find("/dev/dri"), std::string::npos);
  EXPECT_NE(kms.error().hint.find("--display x11"), std::string::npos);
  ASSERT_FALSE(best);
  EXPECT_NE(best.error().message.find("DISPLAY is not set"), std::string::npos);
  EXPECT_NE(best.error().message.find("/dev/dri"), std::string::npos);
}

TEST(OpenDisplays, AScreenThatMayNotBeUsedIsExplained) {
  EXPECT_NE(CannotOpenScreen("card0", EACCES).hint.find("usermod -aG video"), std::string::npos);
  const Error busy = CannotOpenScreen("card0", EBUSY);
  EXPECT_NE(busy.message.find("another program"), std::string::npos);
  EXPECT_NE(busy.hint.find("--display x11"), std::string::npos);
  EXPECT_FALSE(CannotOpenScreen("card7", ENOENT).hint.empty());
}

TEST(WakeWatches, AMachineThatDidNotSleepDidNotWake) {
  WakeWatch watch;
  EXPECT_FALSE(watch.Look());
  EXPECT_FALSE(watch.Look());
}

}  // namespace
}  // namespace parti::app
