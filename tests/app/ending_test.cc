// The program told to end while it is at something long: it ends soon, and its document is whole.
// Killed at any moment: document_kill_test.cc.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <thread>

#include "app/document.h"
#include "base/text_file.h"
#include "tests/support/child.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using parti::tests::Child;

constexpr auto kPatience = std::chrono::seconds(60);  // a busy machine

/// A lot, and more lines on it than can be played while a test waits.
std::string EndlessDrawing() {
  constexpr int kStrokes = 20000;
  std::string text =
      "parti-drawing 1\n"
      "device 0 added 0 name=\"Pen\" size_mm=160,100 pen pressure\n"
      "after 0: lot rect(20,14)\n"
      "pen 0 in 1 40,40 p=0\n";
  for (int i = 0; i < kStrokes; ++i) {
    const double t_s = 1 + i * 0.1;
    text += fmt::format(
        "pen 0 down {} 60,50 p=0.5\npen 0 move {} 70,50 p=0.5\npen 0 move {} 80,50 p=0.5\n"
        "pen 0 up {} 80,50 p=0\n",
        t_s, t_s + 0.01, t_s + 0.02, t_s + 0.03);
  }
  return text + "end\n";
}

class EndingTest : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    folder_ = parti::tests::TestFolder();
    ASSERT_TRUE(WriteFile(folder_ + "/endless.pen", EndlessDrawing()));
    program_ = std::make_unique<Child>(
        std::vector<std::string>{"env", "HOME=" + folder_, "XDG_CONFIG_HOME=" + folder_,
                                 PARTI_PROGRAM, "--display", "offscreen", "--acknowledged",
                                 folder_ + "/safe", "--play", folder_ + "/endless.pen", File()},
        folder_ + "/output", folder_ + "/errors");
  }

  std::string File() const { return folder_ + "/house.parti"; }
  /// Whether it came to be in time.
  static bool Until(const std::function<bool()>& done) {
    const auto limit = std::chrono::steady_clock::now() + kPatience;
    while (!done()) {
      if (std::chrono::steady_clock::now() > limit) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
  }
  bool IsSafe(int number) const {
    const auto said = ReadFile(folder_ + "/safe");
    const size_t last = said ? said->rfind("acknowledged ") : std::string::npos;
    return last != std::string::npos && std::atoi(said->c_str() + last + 13) >= number;
  }

  std::string folder_;
  std::unique_ptr<Child> program_;
};

TEST_P(EndingTest, ASignalEndsAPlayAndWhatWasDrawnIsThere) {
  constexpr int kDrawn = 5;  // requests: the lot, the view, strokes
  ASSERT_TRUE(Until([this] { return IsSafe(kDrawn); }));
  program_->Send(GetParam());
  EXPECT_TRUE(Until([this] { return program_->Ended().has_value(); })) << "it plays on";
  EXPECT_EQ(program_->Ended(), 0);
  const auto document = OpenDocument(File());
  ASSERT_TRUE(document) << FormatError(document.error());
  EXPECT_EQ(PresentOf(*document).ground->lots.size(), 1u);
  EXPECT_GE(document->history.size() + document->posted.size(), size_t{kDrawn});
}

INSTANTIATE_TEST_SUITE_P(Signals, EndingTest, testing::Values(SIGTERM, SIGINT, SIGHUP),
                         [](const auto& test) { return std::string(sigabbrev_np(test.param)); });

}  // namespace
}  // namespace parti::app
