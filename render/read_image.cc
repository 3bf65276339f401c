#include "render/read_image.h"

#include <cstring>

namespace parti::render {

Result<Image> ReadImage(const Gl& gl, GLuint framebuffer, const glm::ivec2& size_px) {
  const size_t row = size_t{4} * size_px.x;
  std::vector<uint8_t> read(row * size_px.y);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, size_px.x, size_px.y, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  if (const auto checked = CheckGl(gl, "reading the picture back"); !checked) return Fail(checked);
  Image image{size_px.x, size_px.y, std::vector<uint8_t>(read.size())};
  for (int y = 0; y < size_px.y; ++y) {
    std::memcpy(&image.pixels[row * y], &read[row * (size_px.y - 1 - y)], row);
  }
  for (size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
  return image;
}

}  // namespace parti::render
