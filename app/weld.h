// Triangles with corners of their own become triangles that share them.
// For each shape by itself: shapes stay apart.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "app/index_table.h"
#include "base/math.h"

namespace parti::app {

/// A part with shared corners. Corners nearer than kWeld_m are one: faces of a body that work out a
/// corner by different sums then meet exactly.
struct WeldedPart {
  std::vector<Vec3> points;         ///< in the order in which triangles name them first
  std::vector<uint32_t> triangles;  ///< three indices each; those without area are left out
  std::vector<Vec3> normals;        ///< one a triangle, unit length
  std::vector<uint32_t> sources;    ///< one a triangle: which of the part's it was
};

inline constexpr double kWeld_m = 1e-5;

/// Welds part after part, and keeps its memory for the next.
class Welder {
 public:
  /// Left out: triangles with corners that are not finite, or without area. Linear. What it gives
  /// stays until the next call.
  const WeldedPart& Weld(const std::vector<Vec3>& corners);

 private:
  using Cell = std::array<int64_t, 3>;
  static Cell CellOf(const Vec3& p);
  static uint64_t HashOf(const Cell& block);
  void Search(const Cell& block, const Cell& home, const Vec3& p, int* rank, uint32_t* found) const;
  uint32_t IndexOf(const Vec3& p);

  WeldedPart part_;
  IndexTable table_;  ///< of part_.points, by their blocks
};

/// One part.
WeldedPart Weld(const std::vector<Vec3>& corners);

}  // namespace parti::app
