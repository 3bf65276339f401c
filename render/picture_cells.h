// What a picture looks like, in short: a hash for each of its cells, by which two pictures are
// compared without reading them again. Not a way to find pixels that differ by little.
#pragma once

#include <cstdint>
#include <vector>

#include "render/damage.h"

namespace parti::render {

/// Square cells of kSide_px, counted from the lower left corner, row after row.
struct PictureCells {
  glm::ivec2 size_px{0, 0};  ///< of the picture
  std::vector<uint64_t> hashes;

  static constexpr int kSide_px = 64;

  /// Cells of a picture of this size, nothing of which is known.
  static PictureCells Of(const glm::ivec2& size_px);
  /// Takes in the RGBA bytes of a tile, rows from the bottom; x and y are multiples of kSide_px, as
  /// are width and height but at the picture's right and upper side.
  void SetTile(const glm::ivec2& at, const glm::ivec2& tile_px, const uint8_t* rgba);
};

/// Rectangles (y down) of cells that differ; everything where sizes differ or cells are not known.
Damage ChangeBetween(const PictureCells& before, const PictureCells& after);

}  // namespace parti::render
