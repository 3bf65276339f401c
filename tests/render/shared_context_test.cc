// Contexts that share their textures between threads, on each off-screen target.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <thread>

#include "base/check.h"
#include "render/gl_framebuffer.h"
#include "render/offscreen.h"

namespace parti::render {
namespace {

constexpr int kSide = 64;
using Pixel = std::array<uint8_t, 4>;

class SharedContext : public testing::TestWithParam<OffscreenTarget> {
 protected:
  void SetUp() override {
    auto created = CreateOffscreenContext(GetParam());
    if (!created) GTEST_SKIP() << FormatError(created.error());
    context_ = std::move(*created);
  }
  std::unique_ptr<GlContext> context_;
};

Gl Loaded(const GlContext& context) { return *LoadGl(context.Lookup(), context.is_gles()); }

/// A texture of one colour, finished: other contexts may read it.
GlFramebuffer Painted(const Gl& gl, float red) {
  auto made = GlFramebuffer::Create(gl, {kSide, kSide, GL_RGBA8, 0, 0, true});
  CHECK(made, "a small framebuffer can be made");
  gl.ClearColor(red, 0.2f, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Finish();
  return std::move(*made);
}

/// The texture's middle as this context sees it, through a framebuffer of its own.
Pixel Read(const Gl& gl, GLuint texture) {
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  Pixel pixel{};
  gl.ReadPixels(kSide / 2, kSide / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  gl.DeleteFramebuffers(1, &framebuffer);
  return pixel;
}

TEST_P(SharedContext, ATextureMadeOnOneThreadIsDrawnOnAnother) {
  auto shared = context_->CreateShared();
  ASSERT_TRUE(shared) << FormatError(shared.error());
  std::atomic<GLuint> texture = 0;
  std::atomic<bool> read = false;
  std::thread painter([&] {
    const CurrentScope current(**shared);
    const Gl gl = Loaded(**shared);
    const GlFramebuffer made = Painted(gl, 0.8f);
    texture = made.color_texture();
    texture.notify_one();
    read.wait(false);
  });
  texture.wait(0);
  {
    const CurrentScope current(*context_);
    EXPECT_EQ(Read(Loaded(*context_), texture), (Pixel{204, 51, 0, 255}));
  }
  read = true;
  read.notify_one();
  painter.join();
}

TEST_P(SharedContext, BothThreadsDrawAtTheSameTime) {
  auto shared = context_->CreateShared();
  ASSERT_TRUE(shared);
  const auto draw = [](GlContext* context, float red, int* wrong) {
    const CurrentScope current(*context);
    const Gl gl = Loaded(*context);
    for (int i = 0; i < 200; ++i) {
      const GlFramebuffer made = Painted(gl, red);
      if (Read(gl, made.color_texture())[0] != std::lround(red * 255)) ++*wrong;
    }
  };
  int wrong_there = 0, wrong_here = 0;
  std::thread other(draw, shared->get(), 0.2f, &wrong_there);
  draw(context_.get(), 1.0f, &wrong_here);
  other.join();
  EXPECT_EQ(wrong_there + wrong_here, 0);
}

TEST_P(SharedContext, EitherMayGoFirst) {
  auto first = context_->CreateShared();
  auto second = (*first)->CreateShared();
  ASSERT_TRUE(second);
  context_.reset();
  first->reset();
  const CurrentScope current(**second);
  ASSERT_TRUE(current.made());
  const Gl gl = Loaded(**second);
  EXPECT_EQ(Read(gl, Painted(gl, 1).color_texture())[0], 255);
}

INSTANTIATE_TEST_SUITE_P(Targets, SharedContext,
                         testing::Values(OffscreenTarget::kOsMesa,
                                         OffscreenTarget::kEglSurfaceless),
                         [](const auto& target) {
                           return target.param == OffscreenTarget::kOsMesa ? "OsMesa" : "Egl";
                         });

}  // namespace
}  // namespace parti::render
