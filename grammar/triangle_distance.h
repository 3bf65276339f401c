// Distances between points, segments, triangles and boxes in space, for geometric queries.
// Exact up to rounding; degenerate triangles and segments count as what is left of them.
#pragma once

#include <array>
#include <vector>

#include "base/math.h"
#include "grammar/scope.h"

namespace parti::grammar {

using Triangle = std::array<Vec3, 3>;

/// Axis-aligned, in the world.
struct Box3 {
  Vec3 low{0, 0, 0};
  Vec3 high{0, 0, 0};
};

Box3 BoundsOf(const std::vector<Triangle>& triangles);  ///< n >= 1
double Distance(const Box3& a, const Box3& b);

/// The nearest point of the segment, the triangle.
Vec3 NearestOn(const Segment3& segment, const Vec3& point);
Vec3 NearestOn(const Triangle& triangle, const Vec3& point);
/// The nearest point of the solid box that the scope is.
Vec3 NearestOn(const Scope& scope, const Vec3& point);

/// 0 where they meet.
double Distance(const Segment3& a, const Segment3& b);
/// Whether the segment passes through the triangle's plane inside it.
bool Pierces(const Segment3& segment, const Triangle& triangle);
/// 0 where they meet.
double Distance(const Triangle& a, const Triangle& b);

/// How often the closed surface goes round the point: 1 inside, 0 outside (solid angles; van
/// Oosterom and Strackee 1983), between on it.
double WindingNumber(const std::vector<Triangle>& surface, const Vec3& point);

}  // namespace parti::grammar
