#include "render/texture_image.h"

#include <algorithm>

namespace parti::render {
namespace {

/// Over white, as pictures of paper are.
void MakeOpaque(Image* image) {
  for (size_t i = 0; i + 3 < image->pixels.size(); i += 4) {
    uint8_t* pixel = &image->pixels[i];
    const int alpha = pixel[3];
    if (alpha == 255) continue;
    for (int k = 0; k < 3; ++k) {
      pixel[k] = static_cast<uint8_t>((pixel[k] * alpha + 255 * (255 - alpha) + 127) / 255);
    }
    pixel[3] = 255;
  }
}

/// Each pixel the mean of up to 2 x 2.
Image Halved(const Image& image) {
  Image half{std::max(1, image.width / 2), std::max(1, image.height / 2), {}};
  half.pixels.reserve(size_t{4} * half.width * half.height);
  const auto at = [&image](int x, int y, int channel) {
    const size_t row = std::min(y, image.height - 1), column = std::min(x, image.width - 1);
    return int{image.pixels[4 * (row * image.width + column) + channel]};
  };
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int k = 0; k < 4; ++k) {
        const int sum = at(2 * x, 2 * y, k) + at(2 * x + 1, 2 * y, k) + at(2 * x, 2 * y + 1, k) +
                        at(2 * x + 1, 2 * y + 1, k);
        half.pixels.push_back(static_cast<uint8_t>((sum + 2) / 4));
      }
    }
  }
  return half;
}

}  // namespace

Result<Image> DecodeTexture(std::string_view bytes) {
  Result<Image> image =
      bytes.starts_with("\xff\xd8") ? DecodeJpeg(bytes) : DecodePng(bytes, "the image");
  if (!image) return image;
  MakeOpaque(&*image);
  while (std::max(image->width, image->height) > kMostTextureSide_px) *image = Halved(*image);
  return image;
}

}  // namespace parti::render
