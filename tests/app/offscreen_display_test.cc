// The display in memory as an application's loop uses it.
#include "app/display/offscreen_display.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <thread>

#include "tests/support/sample_scenes.h"

namespace parti::app {
namespace {

using render::tests::PixelAt;

bool IsReadable(const Display& display) {
  pollfd waiting{display.fds().front(), POLLIN, 0};
  return ::poll(&waiting, 1, 0) > 0;
}

class OffscreenDisplays : public testing::TestWithParam<render::OffscreenTarget> {
 protected:
  void SetUp() override {
    auto made = OffscreenDisplay::Create({{40, 30}, 1, GetParam()});
    if (!made) GTEST_SKIP() << FormatError(made.error());
    display_ = std::move(*made);
  }

  /// Presents a frame of one colour; returns the age of what it was drawn over.
  int Fill(float grey) {
    const auto target = display_->BeginFrame();
    EXPECT_TRUE(target) << FormatError(target.error());
    const render::Gl& gl = display_->gl();
    gl.BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    gl.ClearColor(grey, grey, grey, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    const std::array<render::PixelRect, 1> damage = {{{0, 0, 40, 30}}};
    EXPECT_TRUE(display_->Present(damage));
    return target->age;
  }

  std::unique_ptr<OffscreenDisplay> display_;
};

TEST_P(OffscreenDisplays, WhatIsDrawnCanBeReadAsItIs) {
  EXPECT_EQ(Fill(0.5f), 0);
  EXPECT_EQ(Fill(0.5f), 1) << "the framebuffer keeps the last frame";
  const auto image = display_->ReadPixels();
  ASSERT_TRUE(image) << FormatError(image.error());
  EXPECT_EQ(image->width, 40);
  EXPECT_EQ(image->height, 30);
  EXPECT_NEAR(PixelAt(*image, 39, 29).r, 128, 1);
  EXPECT_EQ(display_->frames(), 2);
  EXPECT_EQ(display_->presented().size(), 1u);
}

TEST_P(OffscreenDisplays, EventsComeOutInOrderAndWakeTheLoop) {
  EXPECT_FALSE(IsReadable(*display_));
  std::thread other([this] {
    display_->Inject(KeyEvent{0, 1.0, 30, true});
    display_->Inject(KeyEvent{0, 1.5, 30, false});
    display_->AskToClose();
    display_->LoseFocus();
  });
  other.join();
  EXPECT_TRUE(IsReadable(*display_));
  const auto news = display_->Dispatch();
  ASSERT_TRUE(news);
  ASSERT_EQ(news->input.size(), 2u);
  EXPECT_EQ(std::get<KeyEvent>(news->input[0]).t_s, 1.0);
  EXPECT_TRUE(news->close_asked);
  EXPECT_TRUE(news->focus_lost);
  EXPECT_FALSE(IsReadable(*display_));
  EXPECT_TRUE(display_->Dispatch()->input.empty());
}

TEST_P(OffscreenDisplays, AResizeTakesEffectInDispatchAndLosesThePicture) {
  Fill(1);
  display_->Resize({60, 20}, 2);
  EXPECT_EQ(display_->size_px(), glm::ivec2(40, 30));
  const auto news = display_->Dispatch();
  ASSERT_TRUE(news);
  EXPECT_TRUE(news->resized);
  EXPECT_TRUE(news->exposed);
  EXPECT_EQ(display_->size_px(), glm::ivec2(60, 20));
  EXPECT_EQ(display_->scale(), 2);
  EXPECT_EQ(Fill(1), 0);
  EXPECT_EQ(display_->ReadPixels()->width, 60);
  display_->Resize({60, 20}, 2);
  EXPECT_FALSE(display_->Dispatch()->resized) << "the same size is no news";
}

TEST_P(OffscreenDisplays, NothingIsDrawnWhileHidden) {
  display_->SetVisible(false);
  EXPECT_TRUE(display_->Dispatch()->hidden);
  EXPECT_FALSE(display_->CanDraw());
  display_->SetVisible(false);
  EXPECT_FALSE(display_->Dispatch()->hidden) << "it was hidden already";
  display_->SetVisible(true);
  EXPECT_TRUE(display_->Dispatch()->shown);
  EXPECT_TRUE(display_->CanDraw());
}

TEST_P(OffscreenDisplays, ALostScreenIsAnErrorOfDispatch) {
  display_->Break({ErrorCode::kDevice, "the screen is gone"});
  const auto news = display_->Dispatch();
  ASSERT_FALSE(news);
  EXPECT_EQ(news.error().code, ErrorCode::kDevice);
}

TEST_P(OffscreenDisplays, ASharedContextSeesTheTexturesOnAnotherThread) {
  ASSERT_TRUE(display_->context().MakeCurrent());
  const render::Gl& gl = display_->gl();
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.Finish();
  auto shared = display_->CreateSharedContext();
  ASSERT_TRUE(shared) << FormatError(shared.error());
  std::thread other([&] {
    const render::CurrentScope current(**shared);
    ASSERT_TRUE(current.made());
    const auto theirs = render::LoadGl((*shared)->Lookup(), (*shared)->is_gles());
    ASSERT_TRUE(theirs);
    GLuint framebuffer = 0;
    theirs->GenFramebuffers(1, &framebuffer);
    theirs->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    theirs->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    theirs->ClearColor(0, 1, 0, 1);
    theirs->Clear(GL_COLOR_BUFFER_BIT);
    theirs->Finish();
    theirs->DeleteFramebuffers(1, &framebuffer);
  });
  other.join();
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  std::array<uint8_t, 4> pixel{};
  gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  EXPECT_EQ(pixel, (std::array<uint8_t, 4>{0, 255, 0, 255}));
  gl.DeleteFramebuffers(1, &framebuffer);
  gl.DeleteTextures(1, &texture);
}

INSTANTIATE_TEST_SUITE_P(Targets, OffscreenDisplays,
                         testing::Values(render::OffscreenTarget::kOsMesa,
                                         render::OffscreenTarget::kEglSurfaceless),
                         [](const auto& target) {
                           return target.param == render::OffscreenTarget::kOsMesa ? "OsMesa"
                                                                                   : "Egl";
                         });

TEST(OffscreenDisplaySizes, ASizeBelowOnePixelIsRefused) {
  EXPECT_EQ(OffscreenDisplay::Create({{0, 10}, 1}).error().code, ErrorCode::kBadNumber);
  EXPECT_EQ(OffscreenDisplay::Create({{10, 10}, 0}).error().code, ErrorCode::kBadNumber);
  EXPECT_EQ(OffscreenDisplay::Create({{10000000, 10}, 1}).error().code, ErrorCode::kGraphics);
}

}  // namespace
}  // namespace parti::app
