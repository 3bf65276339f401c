#include "render/gpu_textures.h"

#include <utility>

#include "render/texture_image.h"

namespace parti::render {

GpuTextures::GpuTextures(GpuTextures&& other) noexcept
    : gl_(other.gl_),
      known_(std::exchange(other.known_, {})),
      old_(std::exchange(other.old_, {})) {}

GpuTextures& GpuTextures::operator=(GpuTextures&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(known_, other.known_);
  std::swap(old_, other.old_);
  return *this;
}

GpuTextures::~GpuTextures() {
  Delete(&known_);
  Delete(&old_);
}

GLuint GpuTextures::Of(const EncodedImage& image) {
  if (const auto found = known_.find(image); found != known_.end()) return found->second;
  if (auto node = old_.extract(image)) return known_.insert(std::move(node)).position->second;
  return known_.emplace(image, Upload(*image)).first->second;
}

GLuint GpuTextures::Upload(const std::string& bytes) const {
  const Result<Image> image = DecodeTexture(bytes);
  if (!image) return 0;
  GLuint texture = 0;
  gl_->GenTextures(1, &texture);
  gl_->BindTexture(GL_TEXTURE_2D, texture);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, image->width, image->height, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, image->pixels.data());
  gl_->GenerateMipmap(GL_TEXTURE_2D);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  return texture;
}

void GpuTextures::Delete(Textures* textures) const {
  for (const auto& [image, texture] : *textures) {
    if (texture) gl_->DeleteTextures(1, &texture);
  }
  textures->clear();
}

}  // namespace parti::render
