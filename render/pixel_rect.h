// A rectangle of pixels of a picture: what is damaged, clipped or presented.
// Not a camera's and not a tablet's: those have places between pixels.
#pragma once

namespace parti::render {

/// Pixels [x, x + width) by [y, y + height), from the top left, y down. Empty when a size is 0.
struct PixelRect {
  int x = 0;
  int y = 0;
  int width = 0;   ///< >= 0
  int height = 0;  ///< >= 0

  bool operator==(const PixelRect&) const = default;
};

}  // namespace parti::render
