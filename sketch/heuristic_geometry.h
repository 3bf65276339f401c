// What the heuristics ask of lines and outlines.
// Angles and distances only: what they mean is for each heuristic to say (Jesus 2018, 6.5).
#pragma once

#include <vector>

#include "base/math.h"
#include "grammar/item.h"

namespace parti::sketch {

inline double LengthOf(const Segment3& line) { return glm::distance(line.a, line.b); }
/// Unit direction; zero for a line of no length.
Vec3 DirectionOf(const Segment3& line);
bool Parallel(const Vec3& u, const Vec3& v, Angle tolerance);    ///< unit vectors; either sense
bool Orthogonal(const Vec3& u, const Vec3& v, Angle tolerance);  ///< unit vectors

/// Whether a planar item lies and looks up: the ground, or a flat roof.
bool LooksUp(const grammar::Item& planar);

/// An edge of a planar item's outline or holes with its neighbours, in scope coordinates: the
/// item's inside lies to the left of a to b.
struct OutlineEdge {
  Vec2 a{0, 0};
  Vec2 b{0, 0};
  Vec2 inward{0, 0};   ///< unit normal
  Vec2 mitre_a{0, 0};  ///< how a moves when every edge moves inward by 1 m
  Vec2 mitre_b{0, 0};
};
/// Ring by ring, the outline first.
std::vector<OutlineEdge> OutlineOf(const grammar::Item& planar);

}  // namespace parti::sketch
