#include "render/image.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/text_file.h"

namespace parti::render {
namespace {

std::string Temporary(const std::string& name) {
  return (std::filesystem::path(testing::TempDir()) / ("parti_image_" + name)).string();
}

Image Gradient(int width, int height) {
  Image image{width, height, {}};
  for (int i = 0; i < 4 * width * height; ++i) {
    image.pixels.push_back(static_cast<uint8_t>(i * 7 % 256));
  }
  return image;
}

TEST(Png, ReadsBackWhatWasWritten) {
  for (const auto& [width, height] : {std::pair(1, 1), {3, 2}, {640, 400}}) {
    const Image image = Gradient(width, height);
    const std::string path = Temporary("round_trip.png");
    ASSERT_TRUE(WritePng(image, path));
    const Result<Image> read = ReadPng(path);
    ASSERT_TRUE(read) << FormatError(read.error());
    EXPECT_EQ(*read, image);
  }
}

TEST(Png, SamePictureGivesSameBytes) {
  ASSERT_TRUE(WritePng(Gradient(64, 48), Temporary("a.png")));
  ASSERT_TRUE(WritePng(Gradient(64, 48), Temporary("b.png")));
  EXPECT_EQ(*ReadFile(Temporary("a.png")), *ReadFile(Temporary("b.png")));
}

TEST(Png, EveryTruncationIsAnErrorNotACrash) {
  const std::string path = Temporary("whole.png"), cut_path = Temporary("cut.png");
  ASSERT_TRUE(WritePng(Gradient(16, 16), path));
  const std::string whole = *ReadFile(path);
  // The last 12 bytes are the end mark, without which libpng still gives the whole picture.
  for (size_t length = 0; length + 12 < whole.size(); ++length) {
    ASSERT_TRUE(WriteFile(cut_path, whole.substr(0, length)));
    const Result<Image> read = ReadPng(cut_path);
    ASSERT_FALSE(read) << "cut to " << length << " of " << whole.size() << " bytes";
    EXPECT_EQ(read.error().code, ErrorCode::kDamagedFile);
  }
}

TEST(Png, ADamagedByteIsAnError) {
  const std::string path = Temporary("damaged.png");
  ASSERT_TRUE(WritePng(Gradient(16, 16), path));
  std::string bytes = *ReadFile(path);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
  ASSERT_TRUE(WriteFile(path, bytes));
  const Result<Image> read = ReadPng(path);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kDamagedFile);
  EXPECT_NE(read.error().message.find(path), std::string::npos);
}

TEST(Png, MissingFilesAndFoldersAreFileErrors) {
  EXPECT_EQ(ReadPng(Temporary("missing/x.png")).error().code, ErrorCode::kFile);
  EXPECT_EQ(WritePng(Gradient(2, 2), Temporary("missing/x.png")).error().code, ErrorCode::kFile);
}

TEST(Png, SizesThatDisagreeWithThePixelsAreRefused) {
  EXPECT_EQ(WritePng({4, 4, {}}, Temporary("empty.png")).error().code, ErrorCode::kBadNumber);
  EXPECT_EQ(WritePng({0, 0, {}}, Temporary("empty.png")).error().code, ErrorCode::kBadNumber);
}

}  // namespace
}  // namespace parti::render
