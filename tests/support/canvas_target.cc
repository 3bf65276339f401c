#include "tests/support/canvas_target.h"

#include <gtest/gtest.h>

#include <cstring>

#include "base/check.h"

namespace parti::render::tests {

std::unique_ptr<CanvasTarget> CanvasTarget::Create(OffscreenTarget target, const glm::ivec2& size,
                                                   int buffers) {
  auto context = CreateOffscreenContext(target);
  if (!context || !(*context)->MakeCurrent()) return nullptr;
  const Result<Gl> gl = LoadGl((*context)->Lookup(), (*context)->is_gles());
  CHECK(gl, "a context has its functions");
  std::unique_ptr<CanvasTarget> made(new CanvasTarget(std::move(*context), *gl, buffers));
  auto canvas = Canvas::Create(made->gl_, size);
  CHECK(canvas, canvas ? "" : canvas.error().message);
  made->canvas_ = std::move(*canvas);
  made->MakeBuffers(size);
  return made;
}

CanvasTarget::~CanvasTarget() {
  (void)context_->MakeCurrent();  // another may be
  canvas_.reset();
  buffers_.clear();
  whole_.reset();
  context_->Release();
}

void CanvasTarget::MakeBuffers(const glm::ivec2& size) {
  buffers_.clear();
  const FramebufferSpec spec{size.x, size.y, GL_RGBA8, 0, 0, false};
  for (int i = 0; i < count_; ++i) buffers_.push_back({*GlFramebuffer::Create(gl_, spec)});
  whole_.emplace(*GlFramebuffer::Create(gl_, spec));
}

void CanvasTarget::Resize(const glm::ivec2& size) {
  const auto resized = canvas_->Resize(size);
  EXPECT_TRUE(resized) << FormatError(resized.error());
  MakeBuffers(size);
}

Damage CanvasTarget::Draw() {
  shown_ = (shown_ + 1) % buffers_.size();
  Buffer& buffer = buffers_[shown_];
  ++frame_;
  const auto damage =
      canvas_->Draw(buffer.framebuffer.id(), buffer.drawn < 0 ? 0 : frame_ - buffer.drawn);
  EXPECT_TRUE(damage) << FormatError(damage.error());
  buffer.drawn = frame_;
  return damage.value_or(Damage(canvas_->size()));
}

Image CanvasTarget::Shown() const { return Read(buffers_[shown_].framebuffer); }

Image CanvasTarget::Whole() {
  const auto damage = canvas_->Draw(whole_->id(), 0);
  EXPECT_TRUE(damage) << FormatError(damage.error());
  ++frame_;
  return Read(*whole_);
}

Image CanvasTarget::Read(const GlFramebuffer& buffer) const {
  const int width = buffer.spec().width, height = buffer.spec().height;
  const size_t row = size_t{4} * width;
  std::vector<uint8_t> read(row * height);
  buffer.Bind();
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  Image image{width, height, std::vector<uint8_t>(read.size())};
  for (int y = 0; y < height; ++y) {
    std::memcpy(&image.pixels[row * y], &read[row * (height - 1 - y)], row);
  }
  return image;
}

CanvasPicture PlainPicture(const Gl& gl, const glm::ivec2& size, const Vec3f& color) {
  auto made = GlFramebuffer::Create(gl, {size.x, size.y, GL_SRGB8_ALPHA8, 0, 0, true});
  auto held = std::make_shared<GlFramebuffer>(std::move(*made));
  std::vector<uint8_t> bytes;
  for (int i = 0; i < size.x * size.y; ++i) {
    for (int c = 0; c < 4; ++c) {
      bytes.push_back(c < 3 ? static_cast<uint8_t>(std::lround(color[c] * 255)) : 255);
    }
  }
  gl.BindTexture(GL_TEXTURE_2D, held->color_texture());
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  CanvasPicture picture;
  picture.texture = held->color_texture();
  picture.size_px = size;
  picture.view_px = size;
  picture.keep = held;
  return picture;
}

}  // namespace parti::render::tests
