// The window on an X server of the test's own: pixels as another program sees them, mice and keys
// that xdotool moves, sizes, focus, closing, and a server that dies.
#include "app/display/x11_display.h"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include "app/display/offscreen_display.h"
#include "tests/support/sample_scenes.h"
#include "tests/support/xvfb.h"

namespace parti::app {
namespace {

using parti::tests::XSpectator;
using parti::tests::Xvfb;
using render::Image;
using render::tests::PixelAt;

constexpr auto kPatience = std::chrono::seconds(20);  // a busy machine

/// Draws a frame: a warm paper with a dark square from 10, 20 to 30, 60 (y down).
void DrawFrame(Display* display) {
  const auto target = display->BeginFrame();
  ASSERT_TRUE(target) << FormatError(target.error());
  const render::Gl& gl = display->gl();
  const glm::ivec2 size = display->size_px();
  gl.BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
  gl.Viewport(0, 0, size.x, size.y);
  gl.Disable(GL_SCISSOR_TEST);
  gl.ClearColor(0.95f, 0.7f, 0.3f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(10, size.y - 60, 20, 40);
  gl.ClearColor(0.1f, 0.1f, 0.25f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Disable(GL_SCISSOR_TEST);
  const std::array<render::PixelRect, 1> all = {{{0, 0, size.x, size.y}}};
  const auto presented = display->Present(all);
  ASSERT_TRUE(presented) << FormatError(presented.error());
}

class X11Displays : public testing::Test {
 protected:
  void SetUp() override {
    std::string why;
    server_ = Xvfb::Start({1000, 700}, &why);
    if (!server_) GTEST_SKIP() << why;
    Open();
    look_ = std::make_unique<XSpectator>(server_->name());
    window_ = look_->Find("Parti");
    ASSERT_NE(window_, 0u);
    ASSERT_TRUE(Until([this] { return news_.shown; }));
  }

  void Open() {
    X11Spec spec;
    spec.server = server_->name();
    spec.size = {400, 300};
    spec.title = "Hof – Parti";
    auto opened = OpenX11Display(spec);
    ASSERT_TRUE(opened) << FormatError(opened.error());
    display_ = std::move(*opened);
  }

  /// One turn of a loop: waits a little, then takes what came.
  bool Turn() {
    std::vector<pollfd> waiting;
    for (const int fd : display_->fds()) waiting.push_back({fd, POLLIN, 0});
    if (!display_->HasNews()) ::poll(waiting.data(), waiting.size(), 20);
    auto news = display_->Dispatch();
    if (!news) {
      lost_ = news.error();
      return false;
    }
    std::move(news->input.begin(), news->input.end(), std::back_inserter(news_.input));
    news_.resized |= news->resized;
    news_.exposed |= news->exposed;
    news_.close_asked |= news->close_asked;
    news_.focus_lost |= news->focus_lost;
    news_.shown |= news->shown;
    news_.hidden |= news->hidden;
    return true;
  }

  bool Until(const std::function<bool()>& done) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!done()) {
      if (std::chrono::steady_clock::now() > end || !Turn()) return done();
    }
    return true;
  }

  void Draw() {
    ASSERT_TRUE(Until([this] { return display_->CanDraw(); }));
    DrawFrame(display_.get());
  }

  template <typename Event, typename Accept>
  bool Came(const Accept& accept) const {
    return std::any_of(news_.input.begin(), news_.input.end(), [&](const InputEvent& event) {
      const auto* wanted = std::get_if<Event>(&event);
      return wanted && accept(*wanted);
    });
  }

  /// Where an event is in the window, by its device's own word for it.
  Vec2 ViewOf(const PenEvent& event) const {
    for (const InputEvent& other : news_.input) {
      const auto* device = std::get_if<DeviceEvent>(&other);
      if (device && device->device == event.device) {
        return event.position_mm * device->facts.view_px_per_mm.value_or(0);
      }
    }
    return {-1, -1};
  }
  bool CamePen(PenEvent::Kind kind, const Vec2& at_px) const {
    return Came<PenEvent>([&](const PenEvent& event) {
      return event.kind == kind && event.tool == PenTool::kMouse &&
             glm::length(ViewOf(event) - at_px) < 0.6;
    });
  }
  bool CameKey(uint32_t code, bool pressed, const std::string& text) const {
    return Came<KeyEvent>([&](const KeyEvent& key) {
      return key.code == code && key.pressed == pressed && key.text == text && !key.repeat;
    });
  }

  std::unique_ptr<Xvfb> server_;
  std::unique_ptr<Display> display_;
  std::unique_ptr<XSpectator> look_;
  unsigned long window_ = 0;
  DisplayNews news_;
  std::optional<Error> lost_;
};

TEST_F(X11Displays, TheWindowShowsThePixelsThatTheSameCallsMakeOffScreen) {
  display_->context().Release();  // before another kind of context is made current
  auto memory = OffscreenDisplay::Create({{400, 300}, 1});
  ASSERT_TRUE(memory);
  DrawFrame(memory->get());
  const Image expected = *(*memory)->ReadPixels();
  memory->reset();
  Draw();
  EXPECT_EQ(display_->size_px(), glm::ivec2(400, 300));
  Image seen;
  ASSERT_TRUE(Until([&] {
    seen = look_->Picture(window_);
    return seen.width == 400 && PixelAt(seen, 0, 0).r > 0;
  }));
  ASSERT_EQ(seen.height, 300);
  int most = 0;
  for (size_t i = 0; i < seen.pixels.size(); ++i) {
    most = std::max(most, std::abs(seen.pixels[i] - expected.pixels[i]));
  }
  EXPECT_LE(most, 1) << "same colours, same places";
  EXPECT_LT(PixelAt(seen, 10, 20).r, 60);
  EXPECT_GT(PixelAt(seen, 9, 20).r, 200);
  EXPECT_GT(PixelAt(seen, 10, 19).r, 200);
}

TEST_F(X11Displays, DesktopsLearnItsNamesAndItsPicture) {
  EXPECT_EQ(look_->Text(window_, "_NET_WM_NAME"), "Hof – Parti");
  EXPECT_EQ(look_->Text(window_, "WM_CLASS"), std::string("parti\0Parti\0", 12));
  EXPECT_EQ(look_->Cardinals(window_, "_NET_WM_PID"),
            std::vector<unsigned long>{static_cast<unsigned long>(::getpid())});
  const auto icon = look_->Cardinals(window_, "_NET_WM_ICON");
  ASSERT_GT(icon.size(), 2u + 16 * 16);
  EXPECT_EQ(icon[0], 16u);
  EXPECT_EQ(icon[2 + 16 * 8 + 2] >> 24 & 0xff, 0xffu) << "opaque within";
  display_->SetTitle("Turm");
  EXPECT_TRUE(Until([this] { return look_->Text(window_, "_NET_WM_NAME") == "Turm"; }));
}

TEST_F(X11Displays, AMouseArrivesWhereItPoints) {
  ASSERT_TRUE(server_->Do({"mousemove", "120", "80"}));
  ASSERT_TRUE(Until([this] { return CamePen(PenEvent::Kind::kMotion, {120, 80}); }));
  EXPECT_TRUE(CamePen(PenEvent::Kind::kProximityIn, {120, 80}));
  ASSERT_TRUE(server_->Do({"mousedown", "1", "mousemove", "121", "95", "mouseup", "1"}));
  ASSERT_TRUE(Until([this] { return CamePen(PenEvent::Kind::kUp, {121, 95}); }));
  EXPECT_TRUE(CamePen(PenEvent::Kind::kDown, {120, 80}));
  EXPECT_TRUE(CamePen(PenEvent::Kind::kMotion, {121, 95}));
  ASSERT_TRUE(server_->Do({"click", "3"}));
  EXPECT_TRUE(Until([this] {
    return Came<PenEvent>([](const PenEvent& event) {
      return event.kind == PenEvent::Kind::kButton && event.button == BTN_RIGHT && !event.pressed;
    });
  }));
  ASSERT_TRUE(server_->Do({"click", "5"}));
  EXPECT_TRUE(Until([this] {
    return Came<ScrollEvent>([](const ScrollEvent& event) { return event.steps == Vec2(0, 1); });
  })) << "a wheel turned towards the user";
}

TEST_F(X11Displays, AStrokeGoesOnOutsideTheWindowAndEndsThere) {
  ASSERT_TRUE(
      server_->Do({"mousemove", "390", "200", "mousedown", "1", "mousemove", "600", "450"}));
  ASSERT_TRUE(Until([this] { return CamePen(PenEvent::Kind::kMotion, {600, 450}); }));
  EXPECT_FALSE(CamePen(PenEvent::Kind::kProximityOut, {600, 450}));
  ASSERT_TRUE(server_->Do({"mouseup", "1"}));
  EXPECT_TRUE(Until([this] { return CamePen(PenEvent::Kind::kProximityOut, {600, 450}); }));
  EXPECT_TRUE(CamePen(PenEvent::Kind::kUp, {600, 450}));
}

TEST_F(X11Displays, TimesAreTheMonotonicClocksAndNeverDecrease) {
  ASSERT_TRUE(server_->Do({"mousemove", "50", "60", "click", "1", "mousemove", "70", "80"}));
  ASSERT_TRUE(Until([this] { return CamePen(PenEvent::Kind::kMotion, {70, 80}); }));
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  double last = 0;
  for (const InputEvent& event : news_.input) {
    const double t_s = std::visit([](const auto& any) { return any.t_s; }, event);
    EXPECT_GE(t_s, last);
    last = t_s;
  }
  EXPECT_NEAR(last, static_cast<double>(now.tv_sec), 20);
}

TEST_F(X11Displays, KeysComeWithWhatTheyType) {
  look_->Focus(window_);
  ASSERT_TRUE(server_->Do({"key", "a", "key", "shift+a", "key", "Return", "key", "ctrl+z"}));
  ASSERT_TRUE(Until([this] { return CameKey(KEY_Z, false, ""); }));
  EXPECT_TRUE(CameKey(KEY_A, true, "a"));
  EXPECT_TRUE(CameKey(KEY_A, true, "A"));
  EXPECT_TRUE(CameKey(KEY_A, false, ""));
  EXPECT_TRUE(CameKey(KEY_ENTER, true, ""));
  EXPECT_TRUE(CameKey(KEY_LEFTCTRL, true, ""));
  EXPECT_TRUE(CameKey(KEY_Z, true, "")) << "a shortcut types nothing";
}

TEST_F(X11Displays, KeysGoByTheLettersOfTheDesktopsLayout) {
  constexpr uint32_t kOffset = 8;  // of X's codes
  const std::string beside_t = std::to_string(KEY_Y + kOffset);
  look_->Focus(window_);
  ASSERT_TRUE(server_->SetLayout("de"));
  ASSERT_TRUE(server_->Do({"key", beside_t}));
  ASSERT_TRUE(Until([this] { return CameKey(KEY_Z, false, ""); }));
  EXPECT_TRUE(CameKey(KEY_Z, true, "z"));
  news_.input.clear();
  ASSERT_TRUE(server_->SetLayout("ru"));
  ASSERT_TRUE(server_->Do({"key", beside_t}));
  ASSERT_TRUE(Until([this] { return CameKey(KEY_Y, false, ""); }));
  EXPECT_TRUE(CameKey(KEY_Y, true, "н"));
}

TEST_F(X11Displays, AKeyIsReleasedAsItWasPressed) {
  constexpr uint32_t kOffset = 8;
  const std::string beside_t = std::to_string(KEY_Y + kOffset);
  look_->Focus(window_);
  ASSERT_TRUE(server_->SetLayout("de"));
  ASSERT_TRUE(server_->Do({"keydown", beside_t}));
  ASSERT_TRUE(Until([this] { return CameKey(KEY_Z, true, "z"); }));
  ASSERT_TRUE(server_->SetLayout("us"));
  ASSERT_TRUE(server_->Do({"keyup", beside_t}));
  EXPECT_TRUE(Until([this] { return CameKey(KEY_Z, false, ""); }));
}

TEST_F(X11Displays, KeysThatAreHeldWhenTheFocusGoesAreReleased) {
  look_->Focus(window_);
  ASSERT_TRUE(server_->Do({"keydown", "shift"}));
  ASSERT_TRUE(Until([this] { return CameKey(KEY_LEFTSHIFT, true, ""); }));
  look_->Focus(std::nullopt);
  ASSERT_TRUE(Until([this] { return news_.focus_lost; }));
  EXPECT_TRUE(CameKey(KEY_LEFTSHIFT, false, ""));
  ASSERT_TRUE(server_->Do({"keyup", "shift"}));
}

TEST_F(X11Displays, AnotherSizeIsToldAndDrawn) {
  Draw();
  look_->Resize(window_, {520, 180});
  ASSERT_TRUE(Until([this] { return news_.resized; }));
  EXPECT_TRUE(news_.exposed);
  EXPECT_EQ(display_->size_px(), glm::ivec2(520, 180));
  Draw();
  Draw();
  Image seen;
  ASSERT_TRUE(Until([&] {
    seen = look_->Picture(window_);
    return seen.width == 520 && PixelAt(seen, 519, 179).r > 200;
  }));
  EXPECT_LT(PixelAt(seen, 10, 59).r, 60);
  EXPECT_GT(PixelAt(seen, 10, 60).r, 200);
}

TEST_F(X11Displays, NothingIsDrawnWhileItIsHidden) {
  Draw();
  look_->SetShown(window_, false);
  ASSERT_TRUE(Until([this] { return news_.hidden; }));
  EXPECT_FALSE(display_->CanDraw());
  news_ = {};
  look_->SetShown(window_, true);
  ASSERT_TRUE(Until([this] { return news_.shown && news_.exposed; }));
  Draw();
}

TEST_F(X11Displays, ClosingIsAskedNotDone) {
  look_->AskToClose(window_);
  ASSERT_TRUE(Until([this] { return news_.close_asked; }));
  Draw();
}

TEST_F(X11Displays, TheDesktopsScaleIsFollowed) {
  EXPECT_EQ(display_->scale(), 1);
  look_->SetRootText("RESOURCE_MANAGER", "Xcursor.size:\t48\nXft.dpi:\t192\n");
  ASSERT_TRUE(Until([this] { return news_.resized; }));
  EXPECT_EQ(display_->scale(), 2);
}

TEST_F(X11Displays, AWindowComesUpAsLargeAsTheDesktopWantsThings) {
  EXPECT_EQ(display_->size_px(), glm::ivec2(400, 300));
  display_.reset();
  look_->SetRootText("RESOURCE_MANAGER", "Xft.dpi:\t192\n");
  Open();
  EXPECT_EQ(display_->size_px(), glm::ivec2(800, 600));
  display_.reset();
  look_->SetRootText("RESOURCE_MANAGER", "Xft.dpi:\t288\n");
  Open();
  EXPECT_EQ(display_->size_px(), glm::ivec2(900, 630)) << "most of the screen";
}

TEST_F(X11Displays, FramesArePacedAndTheLoopIsWoken) {
  Draw();
  EXPECT_FALSE(display_->CanDraw()) << "a frame was shown just now";
  EXPECT_TRUE(Until([this] { return display_->CanDraw(); }));
}

TEST_F(X11Displays, AServerThatDiesIsAnErrorNotTheEnd) {
  Draw();
  look_.reset();
  server_->Kill();
  EXPECT_FALSE(Until([] { return false; }));
  ASSERT_TRUE(lost_);
  EXPECT_EQ(lost_->code, ErrorCode::kDevice);
  EXPECT_NE(lost_->message.find(server_->name()), std::string::npos);
  const std::array<render::PixelRect, 1> all = {{{0, 0, 1, 1}}};
  EXPECT_FALSE(display_->Present(all));
  display_.reset();
}

TEST_F(X11Displays, ASharedContextOutlivesTheWindow) {
  auto shared = display_->CreateSharedContext();
  ASSERT_TRUE(shared) << FormatError(shared.error());
  std::thread other([&] {
    const render::CurrentScope current(**shared);
    EXPECT_TRUE(current.made());
  });
  other.join();
  display_.reset();
  shared->reset();
}

TEST(X11DisplayErrors, NoServerIsExplained) {
  X11Spec spec;
  spec.server = ":987";
  const auto refused = OpenX11Display(spec);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kDevice);
  EXPECT_NE(refused.error().message.find(":987"), std::string::npos);
  EXPECT_FALSE(refused.error().hint.empty());
}

}  // namespace
}  // namespace parti::app
