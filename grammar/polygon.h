// Simple polygons with holes in a plane: what planar shapes are made of.
// Booleans, offsets and triangulation come from CGAL and stay behind this header.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/error.h"
#include "base/math.h"

namespace parti::grammar {

using Ring = std::vector<Vec2>;  ///< closed implicitly; first corner not repeated

/// One outer ring counter-clockwise, holes clockwise inside it, touching nothing; m.
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;

  bool operator==(const Polygon&) const = default;
};

/// A bounding rectangle along the axes.
struct Box2 {
  Vec2 low{0, 0};
  Vec2 high{0, 0};
};

/// Corners nearer to each other, and areas smaller, than these are none.
inline constexpr double kLengthTolerance_m = 1e-6;
inline constexpr double kAreaTolerance_m2 = 1e-9;

/// Larger coordinates are refused: their products would leave what doubles can hold.
inline constexpr double kLargestCoordinate_m = 1e12;

/// Corners nearer than this to a cut through something of this extent lie on it.
constexpr double CutTolerance(double extent_m) { return 1e-9 * std::max(1.0, extent_m); }

/// Positive for counter-clockwise rings.
double SignedArea(const Ring& ring);
/// Outer area less the holes'.
double Area(const Polygon& polygon);
Box2 Bounds(const Polygon& polygon);
Polygon Rectangle(const Vec2& size);
/// On the border counts as inside.
bool Contains(const Polygon& polygon, const Vec2& point);

/// A Polygon from rings as people and files give them: first the outline, then holes, each in any
/// winding, repeated and collinear-by-repetition corners dropped.
/// errors  kBadNumber  a coordinate that is not finite, or beyond kLargestCoordinate_m;
///         kDegenerateGeometry  fewer than 3 distinct corners, or no area;
///         kSelfIntersecting  a ring that crosses or touches itself or another (the message says
///         where), or a hole outside the outline.
Result<Polygon> PolygonFrom(const std::vector<Ring>& rings);

/// The part with low <= coordinate <= high along axis (0: x, 1: y), as separate polygons in a
/// fixed order. They are cut exactly at low and high, so that neighbouring slabs share their
/// border; where a corner of a hole lies on the cut, a piece touches itself in that corner. Empty
/// where nothing of positive area is left.
std::vector<Polygon> Slab(const Polygon& polygon, int axis, double low, double high);

/// The polygon moved inward by distance_m (outward where negative) with mitred corners: several
/// pieces where it falls apart, none where it vanishes (straight skeleton).
/// errors  kDegenerateGeometry  the library refuses the polygon.
Result<std::vector<Polygon>> Offset(const Polygon& polygon, double distance_m);

/// `whole` without `parts`, which lie in it and come from Offset: the ring between a polygon and
/// what Offset made of it, with holes where the parts were.
std::vector<Polygon> Border(const Polygon& whole, const std::vector<Polygon>& parts);

/// Triangles covering the polygon (constrained Delaunay; a fan where it is strictly convex): three
/// indices each into its corners, numbered outer ring first, then each hole. Counter-clockwise.
std::vector<uint32_t> Triangulate(const Polygon& polygon);

}  // namespace parti::grammar
