// Which way a shape's front is: the street's side where a street is known, else the longest side.
// Never the edge that a file happens to begin with. Scopes go their own way (scope.h).
#pragma once

#include <cstddef>
#include <cstdint>

#include "grammar/item.h"

namespace parti::grammar {

/// The sides of a shape as one sees them who stands on the street and looks at it.
enum class StreetSide : uint8_t { kFront, kRight, kBack, kLeft };

/// Edges that turn by less than this along the outline belong to one side: real outlines are never
/// straight.
inline constexpr double kSideTurn_deg = 15;

/// The unit direction in the world out of the front of a shape, in its plane (of a volume:
/// horizontal). Where Item::street_deg is given, towards the street. Else out of the longest side
/// of the outline (chords of runs of edges, kSideTurn_deg); of sides as long within 1e-6, the one
/// that looks most to the south, then most to the east. A volume goes by its largest bottom face;
/// where it has none, by its scope's z. O(n), O(n^2) for outlines without corners.
/// property 1  independent of the corner with which the outline begins.
Vec3 FrontOf(const Item& item);

/// The number of the outline's edge that is the front: of those that look within kSideTurn_deg of
/// FrontOf, or else most nearly that way, the longest. Edge i runs from corner i; of a rectangle,
/// edge 0 along its scope's x. The item is planar.
size_t FrontEdge(const Item& planar);

/// The side to which `outward` looks, turning around `up` from `front`; unit vectors. Quadrants are
/// half open, as comp's are: [-45, 45) degrees is the front.
StreetSide StreetSideOf(const Vec3& front, const Vec3& up, const Vec3& outward);

}  // namespace parti::grammar
