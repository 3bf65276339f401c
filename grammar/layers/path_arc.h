// Arcs of ellipses as SVG writes them, by their ends (SVG 1.1, appendix F.6).
// A helper of svg_path.h.
#pragma once

#include <optional>

#include "grammar/layers/svg_path.h"

namespace parti::grammar {

/// What SVG says of an arc besides its ends.
struct ArcForm {
  Vec2 radii{0, 0};       ///< signs don't count; too small ones are scaled up
  double turned_deg = 0;  ///< the ellipse's x axis, counter-clockwise
  bool large = false;     ///< of the two arcs of each direction, the longer one
  bool counter_clockwise = false;
};

/// Nothing where it is a line: a radius of 0, or both ends in one place.
std::optional<PathSegment> ArcBetween(const Vec2& from, const Vec2& to, const ArcForm& form);

}  // namespace parti::grammar
