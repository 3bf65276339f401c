// What normalisation asks of a 2D library, as inputs for its comparison.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grammar/polygon.h"

namespace parti::bench {

/// Two polygons of which the intersection is wanted.
using Pair = std::pair<grammar::Polygon, grammar::Polygon>;

/// Arches, tiles and gables that were cut to one another before, so that they share slanted edges
/// up to a few last bits, or up to 1e-12 m.
std::vector<Pair> CutPairs(size_t count, uint64_t seed);
/// A random scene's pair, one inside the other, of which GEOS finds nothing to be shared.
Pair PairOfAFailure();

/// A wall, and what is to be taken out of it.
struct WallScene {
  grammar::Polygon wall;
  std::vector<grammar::Polygon> parts;
};
/// columns x rows of arched windows with sills that touch them, in tiles with shared edges.
WallScene ArchedGrid(int columns, int rows);
/// The same as rectangles only.
WallScene RectangleGrid(int columns, int rows);
/// The annotated rectangles of real façades, 20 m wide; empty where the file is not there.
std::vector<WallScene> RealFacades(const std::string& path);

}  // namespace parti::bench
