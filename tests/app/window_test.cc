// The program in a window under Xvfb, with a mouse and keys that xdotool moves: what a person on a
// desktop does, and what a window manager may do to them in the middle of it.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "base/camera.h"
#include "grammar/operation.h"
#include "tests/app/window_driver.h"
#include "tests/support/golden.h"

namespace parti::tests {
namespace {

using app::Document;

class WindowTest : public WindowDriver {
 protected:
  void SetUp() override {
    std::string why;
    server_ = Xvfb::Start({1280, 800}, &why);
    if (!server_) GTEST_SKIP() << why;
    Open(server_->name(), server_.get(), {"DISPLAY=" + server_->name()}, "x11");
  }

  static size_t Strokes(const Document& document) { return document.strokes.size(); }

  std::unique_ptr<Xvfb> server_;
};

TEST_F(WindowTest, AMouseDrawsAndAKeyAccepts) {
  const auto opened = app::OpenDocument(File());
  ASSERT_TRUE(opened) << FormatError(opened.error());
  const View view(app::PresentOf(*opened).camera);
  Press(*view.Project(Vec3(0, 0, 14)), *view.Project(Vec3(0, 6, 14)));
  Release();
  ASSERT_TRUE(WaitForSafe(at_start_ + 1)) << Errors();
  ASSERT_TRUE(server_->Do({"key", "Return"}));
  ASSERT_TRUE(WaitForSafe(at_start_ + 2)) << Errors();
  Rest();
  ExpectGolden(look_->Picture(window_), "window_extruded");
  const std::string rules = grammar::TextOf(*app::PresentOf(Closed()).rules);
  EXPECT_NE(rules.find("extrude(6)"), std::string::npos) << rules;
}

TEST_F(WindowTest, ResizingInMidStrokeLosesNothing) {
  Press({500, 500}, {520, 300});
  look_->Resize(window_, {900, 600});
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  Release();
  ASSERT_TRUE(WaitForSafe(at_start_ + 1)) << Errors();
  EXPECT_EQ(Strokes(Closed()), 1u);
}

TEST_F(WindowTest, LosingTheFocusInMidStrokeLosesNothing) {
  Press({500, 500}, {520, 300});
  look_->Focus(std::nullopt);
  Release();
  ASSERT_TRUE(WaitForSafe(at_start_ + 1)) << Errors();
  EXPECT_EQ(Strokes(Closed()), 1u);
}

TEST_F(WindowTest, ClosingInMidStrokeLosesNothing) {
  Press({500, 500}, {520, 300});
  EXPECT_EQ(Strokes(Closed()), 1u);
}

TEST_F(WindowTest, ADesktopThatCrashesLosesNothingThatWasAcknowledged) {
  Press({500, 500}, {520, 300});
  Release();
  ASSERT_TRUE(WaitForSafe(at_start_ + 1)) << Errors();
  look_.reset();
  server_->Kill();
  EXPECT_TRUE(Until([&] { return program_->Ended().has_value(); }));
  const auto document = app::OpenDocument(File());
  ASSERT_TRUE(document) << FormatError(document.error());
  EXPECT_EQ(Strokes(*document), 1u);
}

}  // namespace
}  // namespace parti::tests
