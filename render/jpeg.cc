// JPEG through libjpeg, whose way of saying that a file is damaged is a long jump: nothing that has
// a destructor may begin within its reach.
#include <csetjmp>
#include <cstdio>
// libjpeg's header wants cstdio's before it.
#include <jpeglib.h>

#include <algorithm>

#include "render/texture_image.h"

namespace parti::render {
namespace {

constexpr uint64_t kMostPixels = 1ull << 28;
/// libjpeg decodes at 1/2, 1/4 and 1/8 for less than the whole.
constexpr int kMostReduction = 8;

/// What libjpeg's calls back for errors find behind its own record.
struct Jump {
  jpeg_error_mgr manager;
  std::jmp_buf back;
};

[[noreturn]] void JumpBack(j_common_ptr common) {
  std::longjmp(reinterpret_cast<Jump*>(common->err)->back, 1);
}

void StaySilent(j_common_ptr /*common*/, int /*level*/) {}

/// Reads the header and chooses the size. False where this is nothing that we draw.
bool Begin(jpeg_decompress_struct* jpeg, int most_side_px) {
  if (jpeg_read_header(jpeg, TRUE) != JPEG_HEADER_OK) return false;
  if (uint64_t{jpeg->image_width} * jpeg->image_height > kMostPixels) return false;
  if (jpeg->num_components != 1 && jpeg->num_components != 3) return false;
  const unsigned side = std::max(jpeg->image_width, jpeg->image_height);
  jpeg->scale_denom = 1;
  while (jpeg->scale_denom < kMostReduction &&
         side / jpeg->scale_denom > static_cast<unsigned>(most_side_px)) {
    jpeg->scale_denom *= 2;
  }
  jpeg->out_color_space = JCS_EXT_RGBA;
  return jpeg_start_decompress(jpeg) == TRUE;
}

/// False, with `image` half filled, where the file is damaged beyond what can be shown.
bool Decode(std::string_view bytes, int most_side_px, Image* image) {
  jpeg_decompress_struct jpeg{};
  Jump jump{};
  jpeg.err = jpeg_std_error(&jump.manager);
  jump.manager.error_exit = JumpBack;
  jump.manager.emit_message = StaySilent;
  if (setjmp(jump.back)) {  // NOLINT(cert-err52-cpp): libjpeg knows no other way
    jpeg_destroy_decompress(&jpeg);
    return false;
  }
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  bool good = Begin(&jpeg, most_side_px);
  if (good) {
    image->width = static_cast<int>(jpeg.output_width);
    image->height = static_cast<int>(jpeg.output_height);
    image->pixels.resize(size_t{4} * image->width * image->height);
    while (jpeg.output_scanline < jpeg.output_height) {
      JSAMPROW row = &image->pixels[size_t{4} * image->width * jpeg.output_scanline];
      jpeg_read_scanlines(&jpeg, &row, 1);
    }
  }
  jpeg_destroy_decompress(&jpeg);
  return good;
}

}  // namespace

Result<Image> DecodeJpeg(std::string_view bytes, int most_side_px) {
  Image image;
  if (Decode(bytes, most_side_px, &image)) return image;
  return Fail(ErrorCode::kDamagedFile, "the image: not a JPEG that can be read",
              "is it a JPEG picture, grey or in colour?");
}

}  // namespace parti::render
