// The program in a window under Xvfb, with a mouse and keys that xdotool moves: what a person on a
// desktop does, and what a window manager may do to them in the middle of it.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "app/document.h"
#include "base/camera.h"
#include "base/text_file.h"
#include "grammar/operation.h"
#include "tests/support/golden.h"
#include "tests/support/program.h"
#include "tests/support/xvfb.h"

namespace parti::tests {
namespace {

using app::Document;

constexpr auto kPatience = std::chrono::seconds(60);  // a busy machine

class WindowTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string why;
    server_ = Xvfb::Start({1280, 800}, &why);
    if (!server_) GTEST_SKIP() << why;
    folder_ = TestFolder();
    Open();
  }

  void Open() {
    ASSERT_TRUE(WriteFile(folder_ + "/safe", ""));
    program_ = std::make_unique<Child>(
        std::vector<std::string>{"env", "DISPLAY=" + server_->name(), "HOME=" + folder_,
                                 "XDG_CONFIG_HOME=" + folder_, "LIBGL_ALWAYS_SOFTWARE=1",
                                 PARTI_PROGRAM, "--display", "x11", "--lot", "rect(20,14)",
                                 "--acknowledged", folder_ + "/safe", File()},
        folder_ + "/output", folder_ + "/errors");
    look_ = std::make_unique<XSpectator>(server_->name());
    window_ = look_->Find("Parti");
    ASSERT_NE(window_, 0u) << Errors();
    Rest();
    at_start_ = Safe();
    ASSERT_GT(at_start_, 0) << Errors();
  }

  /// Until nothing has been written for a while: the lot is there, and the view has come to rest.
  void Rest() const {
    constexpr auto kStill = std::chrono::milliseconds(1500);
    int safe = -1;
    auto since = std::chrono::steady_clock::now();
    Until([&] {
      if (Safe() != safe || safe == 0) {
        safe = Safe();
        since = std::chrono::steady_clock::now();
      }
      return std::chrono::steady_clock::now() - since > kStill;
    });
  }

  static bool Until(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!done()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
  }

  std::string File() const { return folder_ + "/house.parti"; }
  std::string Errors() const { return ReadFile(folder_ + "/errors").value_or(""); }
  /// The number of the last request that is safe.
  int Safe() const {
    const std::string log = ReadFile(folder_ + "/safe").value_or("");
    const size_t at = log.rfind("acknowledged ");
    return at == std::string::npos ? 0 : std::stoi(log.substr(at + 13));
  }
  bool WaitForSafe(int number) {
    return Until([&] { return Safe() >= number; });
  }

  /// A line with the left button, not let go.
  void Press(const Vec2& from, const Vec2& to) {
    std::vector<std::string> words = {"mousemove", Text(from.x), Text(from.y), "mousedown", "1"};
    for (int i = 1; i <= 20; ++i) {
      const Vec2 at = from + (to - from) * (i / 20.0);
      for (const std::string& word : {std::string("mousemove"), Text(at.x), Text(at.y),
                                      std::string("sleep"), std::string("0.01")}) {
        words.emplace_back(word);
      }
    }
    ASSERT_TRUE(server_->Do(words));
  }
  void Release() { ASSERT_TRUE(server_->Do({"mouseup", "1"})); }
  static std::string Text(double px) { return std::to_string(std::lround(px)); }

  /// Closes the window as its cross does, and reads what is left.
  Document Closed() {
    look_->AskToClose(window_);
    std::optional<int> status;
    EXPECT_TRUE(Until([&] { return (status = program_->Ended()).has_value(); }));
    EXPECT_EQ(status, 0) << Errors();
    auto document = app::OpenDocument(File());
    EXPECT_TRUE(document) << FormatError(document.error());
    return document.value_or(Document{});
  }
  static size_t Strokes(const Document& document) { return document.strokes.size(); }

  std::string folder_;
  std::unique_ptr<Xvfb> server_;
  std::unique_ptr<Child> program_;
  std::unique_ptr<XSpectator> look_;
  unsigned long window_ = 0;
  int at_start_ = 0;  // requests that the program made of itself
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
