// The edges that are left when shared ones have cancelled: the first half of Stitch.
// Knows nothing of loops.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grammar/polygon.h"

namespace parti::grammar {

/// An edge between two vertices, by number; what it borders lies on its left.
struct StitchEdge {
  uint32_t from = 0;
  uint32_t to = 0;
};

/// A graph whose edges meet in vertices only.
struct StitchGraph {
  std::vector<Vec2> vertices;     ///< sorted by x, then y; each once
  std::vector<StitchEdge> edges;  ///< sorted by from, then to
};

/// The borders of `plus` and the reversed ones of `minus`: coordinates within tolerance_m made
/// equal (those of `plus` first), edges cut at vertices within tolerance_m, edges that run both
/// ways left out.
StitchGraph StitchGraphOf(std::span<const Polygon> plus, std::span<const Polygon> minus,
                          double tolerance_m);

}  // namespace parti::grammar
