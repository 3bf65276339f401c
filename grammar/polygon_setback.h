// Moving some edges of a polygon inward and leaving the others: what setbacks and the shapes L, U
// and O are cut from. All edges by one distance is polygon.h's Offset.
#pragma once

#include <vector>

#include "grammar/polygon.h"

namespace parti::grammar {

/// What becomes of one edge.
struct EdgeSetback {
  double distance_m = 0;  ///< 0: it stays; never negative
  int strip = -1;         ///< which strip takes what it sweeps; -1: none keeps it
};

/// The polygon divided: strips[k] is what the edges of strip k sweep, in pieces; what several sweep
/// belongs to the first. The remainder is what no edge sweeps.
struct SetbackParts {
  std::vector<std::vector<Polygon>> strips;
  std::vector<Polygon> remainder;
};

/// `edges` has one entry per edge, ring by ring, the outline first. A strip ends at a corner where
/// the moved edge meets the moved or unmoved line of its neighbour (mitres, and straight on along
/// edges that stay); where the neighbour goes straight on and stays (kStraightOn_deg), square to
/// the edge. Strips stop at the outline.
///
/// Edges that vanish on their way are followed exactly where all move by one distance (by the
/// straight skeleton); else what they sweep beyond that is only nearly what a weighted skeleton
/// would give: within some per cent of the area where short edges at sharp corners go far.
///
/// errors  kDegenerateGeometry  a polygon that is not simple.
/// cost    O(n^2) where all edges move.
/// property 1  strips and remainder make up the polygon.  2  all edges by d leave Offset(d).
Result<SetbackParts> Setback(const Polygon& polygon, const std::vector<EdgeSetback>& edges);

/// Neighbours that turn by less go straight on.
inline constexpr double kStraightOn_deg = 20;

}  // namespace parti::grammar
