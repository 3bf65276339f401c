#include "tests/support/golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "tests/support/data.h"

namespace parti::tests {
namespace {

using render::Image;

bool Differs(const uint8_t* a, const uint8_t* b, int channel) {
  for (int i = 0; i < 4; ++i) {
    if (std::abs(int{a[i]} - int{b[i]}) > channel) return true;
  }
  return false;
}

bool Updating() {
  const char* update = std::getenv("PARTI_UPDATE_GOLDEN");
  return update && std::string_view(update) == "1";
}

void Save(const Image& image, const std::string& path) {
  const Result<void> written = render::WritePng(image, path);
  EXPECT_TRUE(written) << FormatError(written.error());
}

}  // namespace

PictureDifference Compare(const Image& made, const Image& golden,
                          const GoldenTolerance& tolerance) {
  PictureDifference difference{made.width == golden.width && made.height == golden.height, 0, 0,
                               made};
  if (!difference.same_size) return difference;
  const size_t width = static_cast<size_t>(made.width), squares = width / kCrowd_px + 1;
  std::vector<size_t> crowds(squares * (static_cast<size_t>(made.height) / kCrowd_px + 1));
  for (size_t i = 0; i < made.pixels.size(); i += 4) {
    uint8_t* mark = &difference.marked.pixels[i];
    for (int c = 0; c < 3; ++c) mark[c] = static_cast<uint8_t>(192 + mark[c] / 4);
    if (!Differs(&made.pixels[i], &golden.pixels[i], tolerance.channel)) continue;
    mark[0] = 220, mark[1] = 0, mark[2] = 0;
    ++difference.pixels;
    ++crowds[i / 4 / width / kCrowd_px * squares + i / 4 % width / kCrowd_px];
  }
  difference.crowd = *std::max_element(crowds.begin(), crowds.end());
  return difference;
}

void ExpectGolden(const Image& image, const std::string& name, const GoldenTolerance& tolerance) {
  ExpectPicture(image, "tests/golden/" + name, tolerance);
}

void ExpectPicture(const Image& image, const std::string& path, const GoldenTolerance& tolerance) {
  const std::string base = SourceFile(path);
  if (Updating()) return Save(image, base + ".png");
  const Result<Image> golden = render::ReadPng(base + ".png");
  if (!golden) {
    Save(image, base + ".out.png");
    ADD_FAILURE() << FormatError(golden.error()) << "\nPARTI_UPDATE_GOLDEN=1 writes it";
    return;
  }
  const PictureDifference difference = Compare(image, *golden, tolerance);
  const double allowed = tolerance.fraction * image.width * image.height;
  const double crowd = tolerance.crowd * kCrowd_px * kCrowd_px;
  if (difference.same_size && static_cast<double>(difference.pixels) <= allowed &&
      static_cast<double>(difference.crowd) <= crowd) {
    return;
  }
  Save(image, base + ".out.png");
  if (!difference.same_size) {
    ADD_FAILURE() << path << ": " << image.width << " x " << image.height << " px, the golden "
                  << golden->width << " x " << golden->height << "; see " << base << ".out.png";
    return;
  }
  Save(difference.marked, base + ".diff.png");
  ADD_FAILURE() << path << ": " << difference.pixels << " pixels differ, " << allowed << " may; "
                << difference.crowd << " of them in one square of " << kCrowd_px << " px, " << crowd
                << " may; see " << base << ".out.png and .diff.png";
}

}  // namespace parti::tests
