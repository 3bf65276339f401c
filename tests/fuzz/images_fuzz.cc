// Any bytes as an image that faces wear: pixels of the size that they say, or an error.
#include <algorithm>
#include <cstdint>

#include "base/check.h"
#include "render/texture_image.h"

namespace parti::render {
namespace {

void Try(std::string_view bytes) {
  const auto image = DecodeTexture(bytes);
  if (!image) {
    CHECK(!FormatError(image.error()).empty(), "an error says what is wrong");
    return;
  }
  CHECK(image->width > 0 && image->height > 0, "an image has pixels");
  CHECK(std::max(image->width, image->height) <= kMostTextureSide_px, "as many as devices take");
  CHECK(image->pixels.size() == size_t{4} * image->width * image->height, "all of them");
}

}  // namespace
}  // namespace parti::render

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  parti::render::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}
