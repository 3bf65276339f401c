// The path of vectorial: SVG's path data as lines and curves (SVG 1.1, 8.3), read with y up (Jesus
// 2018, Listing 4.4; errata 4). Sampling it to polygons is path_rings.h's.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/math.h"

namespace parti::grammar {

/// One line or curve of a path, in the path's units; it starts at points[0].
struct PathSegment {
  enum class Kind : uint8_t { kLine, kQuadratic, kCubic, kArc };
  Kind kind = Kind::kLine;
  /// Bézier control points: 2, 3 or 4 of them. An arc's: its start, its end, and its middle.
  std::array<Vec2, 4> points{};
  Vec2 radii{0, 0};         ///< kArc: of the ellipse, greater than 0
  double turned = 0;        ///< kArc: the ellipse's x axis, radians, counter-clockwise
  double from = 0, by = 0;  ///< kArc: angle on the ellipse at the start, and how far it goes; rad

  const Vec2& start() const { return points[0]; }
  Vec2 end() const { return points[kind == Kind::kCubic ? 3 : kind == Kind::kQuadratic ? 2 : 1]; }
  Vec2 At(double t) const;  ///< 0 <= t <= 1; the ends are exact
};

/// Closed loops of segments, each starting where the one before it ends.
using SvgPath = std::vector<std::vector<PathSegment>>;

/// Reads path data: M L H V C S Q T A Z, in capitals (absolute) or not (relative), with SVG's
/// shorthands. Open loops are closed by a line; loops that go nowhere are left out. Coordinates are
/// what the text says, with y up: an arc with sweep flag 1 runs counter-clockwise.
/// errors  kBadText  what is no path data, or nothing; kBadNumber  beyond 1e6: both with the place
///         in the text;  kLimitReached  more than 10,000 segments.
Result<SvgPath> ParseSvgPath(std::string_view text);

}  // namespace parti::grammar
