#include "render/picture_cells.h"

#include <algorithm>
#include <cstring>

namespace parti::render {
namespace {

constexpr int kSide = PictureCells::kSide_px;

glm::ivec2 CellsAcross(const glm::ivec2& size_px) { return (size_px + (kSide - 1)) / kSide; }

/// Two pixels at a time; a multiply and a shift tell apart whatever a change of a scene makes.
uint64_t HashOfRow(const uint8_t* rgba, int pixels, uint64_t hash) {
  for (int x = 0; x < pixels; x += 2) {
    uint64_t word = 0;
    std::memcpy(&word, rgba + 4 * size_t{static_cast<unsigned>(x)}, x + 1 < pixels ? 8 : 4);
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ull;
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace

PictureCells PictureCells::Of(const glm::ivec2& size_px) {
  const glm::ivec2 across = CellsAcross(size_px);
  return {size_px, std::vector<uint64_t>(static_cast<size_t>(across.x) * across.y)};
}

void PictureCells::SetTile(const glm::ivec2& at, const glm::ivec2& tile_px, const uint8_t* rgba) {
  const int across = CellsAcross(size_px).x;
  for (int y = 0; y < tile_px.y; ++y) {
    const uint8_t* row = rgba + size_t{4} * tile_px.x * y;
    for (int x = 0; x < tile_px.x; x += kSide) {
      const size_t cell = static_cast<size_t>((at.y + y) / kSide) * across + (at.x + x) / kSide;
      // Hashes begin at 1: 0 is a cell that is not known.
      const uint64_t begun = y % kSide == 0 ? 1 : hashes[cell];
      hashes[cell] =
          HashOfRow(row + size_t{4} * x, std::min(kSide, tile_px.x - x), begun) | uint64_t{1};
    }
  }
}

Damage ChangeBetween(const PictureCells& before, const PictureCells& after) {
  Damage change(after.size_px);
  if (before.size_px != after.size_px || before.hashes.size() != after.hashes.size()) {
    change.AddAll();
    return change;
  }
  const int across = CellsAcross(after.size_px).x;
  for (size_t i = 0; i < after.hashes.size(); ++i) {
    if (after.hashes[i] == before.hashes[i] && after.hashes[i] != 0) continue;
    const int x = static_cast<int>(i) % across, y = static_cast<int>(i) / across;
    change.Add({x * kSide, after.size_px.y - (y + 1) * kSide, kSide, kSide});
  }
  return change;
}

}  // namespace parti::render
