// A picture in memory, and PNG files in and out.
// Other formats are the exporters'.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace parti::render {

/// 8 bits a channel, RGBA, sRGB, rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> pixels;  ///< 4 * width * height

  bool operator==(const Image&) const = default;
};

/// Writes 8-bit RGBA; the same bytes for the same picture. The file appears whole or not at all.
/// errors  kFile  it can't be written;  kBadNumber  sizes that don't agree with the pixels.
Result<void> WritePng(const Image& image, const std::string& path);

/// Reads every kind of PNG (grey, palette, 16 bit, interlaced) as 8-bit RGBA.
/// errors  kFile  it can't be read;  kDamagedFile  not a PNG, truncated, or inconsistent.
Result<Image> ReadPng(const std::string& path);
/// The same of a file's bytes; `name` is what errors call it. errors  kDamagedFile.
Result<Image> DecodePng(std::string_view bytes, const std::string& name);

}  // namespace parti::render
