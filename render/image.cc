#include "render/image.h"

#include <png.h>

#include <cstring>

#include "base/text_file.h"

namespace parti::render {
namespace {

/// The largest picture that is read: larger ones are refused rather than filling the memory.
constexpr uint64_t kMostPixels = 1ull << 28;

Error PngError(ErrorCode code, const std::string& path, const std::string& why) {
  return {code, path + ": " + why, code == ErrorCode::kFile ? "" : "is it a PNG picture?"};
}

}  // namespace

Result<void> WritePng(const Image& image, const std::string& path) {
  const size_t wanted = size_t{4} * static_cast<size_t>(image.width) * image.height;
  if (image.width < 1 || image.height < 1 || image.pixels.size() != wanted) {
    return Fail(ErrorCode::kBadNumber, path + ": the picture's size and pixels don't agree");
  }
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr)) {
    return tl::unexpected(PngError(ErrorCode::kFile, path, png.message));
  }
  bytes.resize(size);
  return WriteFile(path, bytes);
}

Result<Image> ReadPng(const std::string& path) {
  const Result<std::string> bytes = ReadFile(path);
  if (!bytes) return Fail(bytes);
  return DecodePng(*bytes, path);
}

Result<Image> DecodePng(std::string_view bytes, const std::string& name) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) {
    return tl::unexpected(PngError(ErrorCode::kDamagedFile, name, png.message));
  }
  if (uint64_t{png.width} * png.height > kMostPixels) {
    png_image_free(&png);
    return tl::unexpected(PngError(ErrorCode::kDamagedFile, name, "more than 2^28 pixels"));
  }
  png.format = PNG_FORMAT_RGBA;
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.pixels.resize(PNG_IMAGE_SIZE(png));
  // libpng's simplified reader reports a truncated file here, and frees its state.
  if (!png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr)) {
    return tl::unexpected(PngError(ErrorCode::kDamagedFile, name, png.message));
  }
  return image;
}

}  // namespace parti::render
