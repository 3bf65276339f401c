// Which regions of a scene may overlap a rectangle: a uniform grid of bounding rectangles.
// A helper of merge_layers.h.
#pragma once

#include <cstdint>
#include <vector>

#include "grammar/polygon.h"

namespace parti::grammar {

/// Rectangles by number, found again by where they are.
class RegionIndex {
 public:
  /// For about `count` rectangles in `bounds`.
  RegionIndex(const Box2& bounds, size_t count);

  void Add(uint32_t number, const Box2& box);  ///< found from here on
  /// Numbers of rectangles in the cells that `box` covers, each once, ascending: all that overlap
  /// it, and some more.
  const std::vector<uint32_t>& Near(const Box2& box);

 private:
  struct Cells {
    uint32_t left, right, bottom, top;  ///< inclusive
  };
  Cells CellsOf(const Box2& box) const;

  Box2 bounds_;
  Vec2 per_cell_;  ///< cells per metre
  uint32_t side_;  ///< cells along each axis
  std::vector<std::vector<uint32_t>> cells_;
  std::vector<uint32_t> near_;
  std::vector<uint64_t> found_in_;  ///< the last search that found a number: long rectangles lie
                                    ///< in many cells together
  uint64_t search_ = 0;
};

}  // namespace parti::grammar
