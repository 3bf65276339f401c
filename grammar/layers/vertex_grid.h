// Finding the vertices that lie on a slanted edge, among many.
// A helper of stitch_edges.h.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grammar/polygon.h"

namespace parti::grammar {

/// Vertices in the cells of a uniform grid, about one per cell.
class VertexGrid {
 public:
  /// `vertices` must outlive the grid; there may be none.
  explicit VertexGrid(std::span<const Vec2> vertices);

  /// The vertices within tolerance of the inside of the edge, from its start on.
  /// cost  the cells that its bounding rectangle covers.
  std::vector<uint32_t> Along(uint32_t from, uint32_t to, double tolerance) const;

 private:
  uint32_t ColumnOf(double x) const;
  uint32_t RowOf(double y) const;

  std::span<const Vec2> vertices_;
  Box2 bounds_;
  Vec2 per_cell_{0, 0};  ///< cells per metre
  uint32_t columns_ = 1, rows_ = 1;
  std::vector<uint32_t> starts_;   ///< of each cell in numbers_, and the end
  std::vector<uint32_t> numbers_;  ///< of vertices
};

}  // namespace parti::grammar
