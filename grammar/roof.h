// Roofs over polygons with holes, as closed meshes: hip, gable, pyramid and shed roofs, and tapers.
// Coordinates: the polygon's x and y, z up from its plane; m. Standing them up in the world is the
// operations' business.
//
// Every roof has the bottom as its first face, looking down; then the roof planes, one flat face
// each, beginning with the eave; upright faces last or where a roof plane was put upright. Corners
// that bend the outline by less than kStraight (polygon_skeleton.h) are left out.
#pragma once

#include <cstddef>

#include "base/error.h"
#include "grammar/mesh.h"
#include "grammar/polygon.h"

namespace parti::grammar {

/// How steep a roof is: by the angle of its planes, or so that its highest point is that high.
struct RoofPitch {
  bool by_height = false;
  double value = 30;  ///< degrees, or metres
};

/// Angles outside of these are no roofs.
inline constexpr double kFlattestRoof_deg = 0.1;
inline constexpr double kSteepestRoof_deg = 89;

/// A plane of the given pitch rises from every edge. overhang_m >= 0 is measured down the planes,
/// as CGA does: eaves move outward and below the polygon's plane, and the bottom with them.
/// errors  kBadNumber  a pitch that is none;  kDegenerateGeometry  as StraightSkeleton.
/// cost    that of StraightSkeleton.
Result<Mesh> HipRoof(const Polygon& polygon, const RoofPitch& pitch, double overhang_m);

/// What overhangs where, both in metres: down the planes at the eaves; outward at the gables.
struct GableOverhang {
  double eave_m = 0;
  double gable_m = 0;
};

/// A hip roof whose triangular ends stand upright: those between two planes that look away from
/// each other (kGableTurn_deg). Where ends touch, as on a square, those come first that look least
/// to `front`, so that eaves are on the street.
/// errors  those of HipRoof.
Result<Mesh> GableRoof(const Polygon& polygon, const RoofPitch& pitch,
                       const GableOverhang& overhang, const Vec2& front);

/// The outline turns by this at both ends of a gable together, and by kGableCorner_deg at each.
inline constexpr double kGableTurn_deg = 130;
inline constexpr double kGableCorner_deg = 30;

/// Triangles from every edge to a point over the centroid, or where that does not see all edges,
/// over the middle of what does (the polygon's kernel). Angles are measured at `front_edge`. A
/// polygon without kernel, and one with holes, gets a hip roof.
/// errors  those of HipRoof.
Result<Mesh> PyramidRoof(const Polygon& polygon, const RoofPitch& pitch, size_t front_edge);

/// A pyramid of that height, downward where it is negative, cut off where it is `top` times as wide
/// as the polygon; 0 <= top < 1. Without kernel: the hip roof that has this height after it was cut
/// where its fronts have gone 1 - top of their way.
/// errors  kDegenerateGeometry  a height of 0, or as StraightSkeleton.
Result<Mesh> Taper(const Polygon& polygon, double height_m, double top);

/// One plane over everything that rises inward from the line of edge `low_edge`, lowered or raised
/// so that its lowest corner is on the ground; the rest stands upright.
/// errors  kBadNumber, kDegenerateGeometry.
Result<Mesh> ShedRoof(const Polygon& polygon, const RoofPitch& pitch, size_t low_edge);

}  // namespace parti::grammar
