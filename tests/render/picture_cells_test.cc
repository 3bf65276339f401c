#include "render/picture_cells.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>

namespace parti::render {
namespace {

constexpr glm::ivec2 kSize{150, 100};  // 3 x 2 cells

/// One tile of all pixels, rows from the bottom.
PictureCells CellsOf(const std::vector<uint8_t>& rgba) {
  PictureCells cells = PictureCells::Of(kSize);
  cells.SetTile({0, 0}, kSize, rgba.data());
  return cells;
}

std::vector<uint8_t> Grey() { return std::vector<uint8_t>(size_t{4} * kSize.x * kSize.y, 128); }

uint8_t& At(std::vector<uint8_t>* rgba, int x, int y_up) {
  return (*rgba)[(size_t{4} * kSize.x * y_up) + size_t{4} * x];
}

TEST(PictureCells, EqualPicturesDoNotDiffer) {
  EXPECT_TRUE(ChangeBetween(CellsOf(Grey()), CellsOf(Grey())).empty());
}

TEST(PictureCells, EachPixelCounts) {
  for (const glm::ivec2& at : {glm::ivec2(0, 0), {149, 99}, {63, 63}, {64, 64}, {148, 50}}) {
    std::vector<uint8_t> changed = Grey();
    ++At(&changed, at.x, at.y);
    const Damage damage = ChangeBetween(CellsOf(Grey()), CellsOf(changed));
    EXPECT_TRUE(damage.Touches({at.x, kSize.y - 1 - at.y, 1, 1})) << at.x << ", " << at.y;
    EXPECT_LE(damage.area(), 64 * 64);
  }
}

TEST(PictureCells, TilesGiveTheSameAsOne) {
  std::vector<uint8_t> pixels = Grey();
  for (size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<uint8_t>(i * i >> 5);
  PictureCells tiled = PictureCells::Of(kSize);
  for (int y = 0; y < kSize.y; y += 64) {
    for (int x = 0; x < kSize.x; x += 64) {
      const glm::ivec2 tile = glm::min(glm::ivec2(64), kSize - glm::ivec2(x, y));
      std::vector<uint8_t> part;
      for (int row = 0; row < tile.y; ++row) {
        const uint8_t* begin = &At(&pixels, x, y + row);
        part.insert(part.end(), begin, begin + size_t{4} * tile.x);
      }
      tiled.SetTile({x, y}, tile, part.data());
    }
  }
  EXPECT_EQ(tiled.hashes, CellsOf(pixels).hashes);
}

TEST(PictureCells, WhatIsNotKnownDiffers) {
  const int64_t all = int64_t{kSize.x} * kSize.y;
  EXPECT_EQ(ChangeBetween({}, CellsOf(Grey())).area(), all);
  EXPECT_EQ(ChangeBetween(PictureCells::Of(kSize), PictureCells::Of(kSize)).area(), all);
}

}  // namespace
}  // namespace parti::render
