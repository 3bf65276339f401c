#include "tests/app/window_driver.h"

#include <chrono>
#include <cmath>
#include <thread>

#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::tests {
namespace {

using std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::seconds(60);  // a busy machine

std::string Text(double px) { return std::to_string(std::lround(px)); }

}  // namespace

void WindowDriver::Open(const std::string& server, const Xvfb* hands,
                        const std::vector<std::string>& environment, const std::string& display) {
  folder_ = TestFolder();
  hands_ = hands;
  ASSERT_TRUE(WriteFile(folder_ + "/safe", ""));
  std::vector<std::string> words = {"env", "HOME=" + folder_, "XDG_CONFIG_HOME=" + folder_,
                                    "LIBGL_ALWAYS_SOFTWARE=1"};
  words.insert(words.end(), environment.begin(), environment.end());
  for (const std::string& word :
       {std::string(PARTI_PROGRAM), std::string("--display"), display, std::string("--lot"),
        std::string("rect(20,14)"), std::string("--acknowledged"), folder_ + "/safe", File()}) {
    words.emplace_back(word);
  }
  program_ = std::make_unique<Child>(words, folder_ + "/output", folder_ + "/errors");
  look_ = std::make_unique<XSpectator>(server);
  window_ = look_->Find("Parti");
  ASSERT_NE(window_, 0u) << Errors();
  Rest();
  at_start_ = Safe();
  ASSERT_GT(at_start_, 0) << Errors();
}

void WindowDriver::TearDown() {
  look_.reset();
  program_.reset();
}

void WindowDriver::Rest() const {
  constexpr auto kStill = std::chrono::milliseconds(1500);
  int safe = -1;
  auto since = steady_clock::now();
  Until([&] {
    if (Safe() != safe || safe == 0) {
      safe = Safe();
      since = steady_clock::now();
    }
    return steady_clock::now() - since > kStill;
  });
}

bool WindowDriver::Until(const std::function<bool()>& done) {
  const auto end = steady_clock::now() + kPatience;
  while (!done()) {
    if (steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

std::string WindowDriver::Errors() const { return ReadFile(folder_ + "/errors").value_or(""); }

int WindowDriver::Safe() const {
  const std::string log = ReadFile(folder_ + "/safe").value_or("");
  const size_t at = log.rfind("acknowledged ");
  return at == std::string::npos ? 0 : std::stoi(log.substr(at + 13));
}

bool WindowDriver::WaitForSafe(int number) {
  return Until([&] { return Safe() >= number; });
}

void WindowDriver::Press(const Vec2& from, const Vec2& to) {
  std::vector<std::string> words = {"mousemove", Text(from.x), Text(from.y), "mousedown", "1"};
  for (int i = 1; i <= 20; ++i) {
    const Vec2 at = from + (to - from) * (i / 20.0);
    for (const std::string& word : {std::string("mousemove"), Text(at.x), Text(at.y),
                                    std::string("sleep"), std::string("0.01")}) {
      words.emplace_back(word);
    }
  }
  ASSERT_TRUE(hands_->Do(words));
}

void WindowDriver::Release() { ASSERT_TRUE(hands_->Do({"mouseup", "1"})); }

app::Document WindowDriver::Closed() {
  look_->AskToClose(window_);
  std::optional<int> status;
  EXPECT_TRUE(Until([&] { return (status = program_->Ended()).has_value(); }));
  EXPECT_EQ(status, 0) << Errors();
  auto document = app::OpenDocument(File());
  EXPECT_TRUE(document) << FormatError(document.error());
  return document.value_or(app::Document{});
}

}  // namespace parti::tests
