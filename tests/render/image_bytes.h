// Images as files hold them, for tests of what reads them.
#pragma once

#include <array>
#include <string>

#include "render/image.h"

namespace parti::render::tests {

using Rgba = std::array<uint8_t, 4>;

/// All of one colour.
Image Plain(int width, int height, const Rgba& color);
/// Rows from the top.
Rgba PixelOf(const Image& image, int x, int y);
std::string PngBytes(const Image& image);
/// Of one colour, at quality 95.
std::string JpegBytes(int width, int height, const std::array<int, 3>& rgb);

}  // namespace parti::render::tests
