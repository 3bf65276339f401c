#include "tests/render/image_bytes.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
// libjpeg's header wants cstdio's before it.
#include <jpeglib.h>

#include <cstdlib>
#include <filesystem>

#include "base/text_file.h"

namespace parti::render::tests {

Image Plain(int width, int height, const Rgba& color) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    image.pixels.insert(image.pixels.end(), color.begin(), color.end());
  }
  return image;
}

Rgba PixelOf(const Image& image, int x, int y) {
  const uint8_t* p = &image.pixels[size_t{4} * (static_cast<size_t>(y) * image.width + x)];
  return {p[0], p[1], p[2], p[3]};
}

std::string PngBytes(const Image& image) {
  const auto path = std::filesystem::path(testing::TempDir()) /
                    ("parti_image_bytes_" + std::to_string(getpid()) + ".png");
  EXPECT_TRUE(WritePng(image, path.string()));
  std::string bytes = ReadFile(path.string()).value_or("");
  std::filesystem::remove(path);
  return bytes;
}

std::string JpegBytes(int width, int height, const std::array<int, 3>& rgb) {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = static_cast<JDIMENSION>(width);
  jpeg.image_height = static_cast<JDIMENSION>(height);
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_set_quality(&jpeg, 95, TRUE);
  jpeg_start_compress(&jpeg, TRUE);
  std::string row;
  for (int x = 0; x < width; ++x) {
    for (const int part : rgb) row.push_back(static_cast<char>(part));
  }
  auto* sent = reinterpret_cast<JSAMPROW>(row.data());
  while (jpeg.next_scanline < jpeg.image_height) jpeg_write_scanlines(&jpeg, &sent, 1);
  jpeg_finish_compress(&jpeg);
  std::string result(reinterpret_cast<char*>(bytes), size);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return result;
}

}  // namespace parti::render::tests
