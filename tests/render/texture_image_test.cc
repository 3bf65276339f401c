// Images as faces wear them, from whole, odd and damaged files.
#include "render/texture_image.h"

#include <gtest/gtest.h>

#include "tests/render/image_bytes.h"

namespace parti::render {
namespace {

using tests::JpegBytes;
using tests::PixelOf;
using tests::Plain;
using tests::PngBytes;

TEST(TextureImage, APngIsDecodedAsItIs) {
  Image image = Plain(3, 2, {10, 20, 30, 255});
  image.pixels[4] = 99;
  EXPECT_EQ(*DecodeTexture(PngBytes(image)), image);
}

TEST(TextureImage, WhatIsTransparentShowsWhite) {
  const Image clear = *DecodeTexture(PngBytes(Plain(2, 2, {10, 20, 30, 0})));
  EXPECT_EQ(clear, Plain(2, 2, {255, 255, 255, 255}));
  const Image half = *DecodeTexture(PngBytes(Plain(1, 1, {0, 100, 255, 128})));
  EXPECT_NEAR(half.pixels[0], 127, 1);
  EXPECT_NEAR(half.pixels[1], 177, 1);
  EXPECT_EQ(half.pixels[2], 255);
}

TEST(TextureImage, AJpegGivesItsColoursBack) {
  for (const auto& rgb : {std::array{200, 60, 40}, {20, 120, 220}, {250, 250, 250}}) {
    const Image image = *DecodeTexture(JpegBytes(40, 24, rgb));
    ASSERT_EQ(image.width, 40);
    ASSERT_EQ(image.height, 24);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(PixelOf(image, 20, 12)[k], rgb[k], 4);
    EXPECT_EQ(PixelOf(image, 39, 23)[3], 255);
  }
}

TEST(TextureImage, LargeImagesAreHalvedToTheLimit) {
  const Image wide = *DecodeTexture(PngBytes(Plain(3 * kMostTextureSide_px, 3, {9, 8, 7, 255})));
  EXPECT_EQ(wide, Plain(3 * kMostTextureSide_px / 4, 1, {9, 8, 7, 255}));
  const Image tall = *DecodeTexture(JpegBytes(8, 5 * kMostTextureSide_px, {200, 60, 40}));
  EXPECT_LE(tall.height, kMostTextureSide_px);
  EXPECT_GT(tall.height, kMostTextureSide_px / 2);
  EXPECT_NEAR(PixelOf(tall, 0, 700)[0], 200, 4);
}

TEST(TextureImage, AHalvedPixelIsTheMeanOfFour) {
  Image image = Plain(2 * kMostTextureSide_px, 2, {100, 100, 100, 255});
  for (size_t i = 0; i < image.pixels.size(); i += 8) image.pixels[i] = 0;
  EXPECT_EQ(PixelOf(*DecodeTexture(PngBytes(image)), 7, 0)[0], 50);
}

TEST(TextureImage, NoFileCutShortOrWithAByteChangedIsMoreThanAnError) {
  for (const std::string& whole :
       {PngBytes(Plain(20, 10, {1, 2, 3, 255})), JpegBytes(20, 10, {1, 2, 3})}) {
    for (size_t i = 0; i < whole.size(); ++i) {
      std::string changed = whole;
      changed[i] = static_cast<char>(~changed[i]);
      for (const std::string_view bytes :
           {std::string_view(whole).substr(0, i), std::string_view(changed)}) {
        const auto image = DecodeTexture(bytes);
        if (image) {
          ASSERT_EQ(image->pixels.size(), size_t{4} * image->width * image->height) << i;
        } else {
          ASSERT_EQ(image.error().code, ErrorCode::kDamagedFile) << i;
        }
      }
    }
  }
}

TEST(TextureImage, WhatIsNoImageIsRefused) {
  for (const std::string& bytes : {std::string(), std::string("GIF89a"), std::string("\xff\xd8"),
                                   std::string("\x89PNG\r\n\x1a\n"), std::string(100, '\xff')}) {
    EXPECT_FALSE(DecodeTexture(bytes));
  }
}

}  // namespace
}  // namespace parti::render
