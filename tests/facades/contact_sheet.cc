#include "tests/facades/contact_sheet.h"

#include <algorithm>

#include "base/check.h"

namespace parti::tests {
namespace {

constexpr int kGap_px = 6;

void Paste(const render::Image& picture, int left, int top, render::Image* sheet) {
  const auto row_bytes = static_cast<size_t>(picture.width) * 4;
  for (int y = 0; y < picture.height; ++y) {
    const auto from = picture.pixels.begin() + static_cast<ptrdiff_t>(row_bytes * y);
    const size_t to = (static_cast<size_t>(top + y) * sheet->width + left) * 4;
    std::copy_n(from, row_bytes, sheet->pixels.begin() + static_cast<ptrdiff_t>(to));
  }
}

}  // namespace

render::Image ContactSheet(const std::vector<render::Image>& pictures, int columns) {
  CHECK(!pictures.empty() && columns > 0, "something to show");
  const int width = pictures[0].width + kGap_px, height = pictures[0].height + kGap_px;
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  render::Image sheet;
  sheet.width = columns * width + kGap_px;
  sheet.height = rows * height + kGap_px;
  sheet.pixels.assign(static_cast<size_t>(sheet.width) * sheet.height * 4, 255);
  for (size_t i = 0; i < pictures.size(); ++i) {
    const int number = static_cast<int>(i);
    Paste(pictures[i], kGap_px + number % columns * width, kGap_px + number / columns * height,
          &sheet);
  }
  return sheet;
}

}  // namespace parti::tests
