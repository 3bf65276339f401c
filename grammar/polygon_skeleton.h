// The straight skeleton of a polygon with holes: what roofs and offsets are cut from.
// The door to CGAL's: polygon_skeleton.cc is the only source that includes it; exceptions of the
// library end there, as Results.
#pragma once

#include <cstdint>
#include <vector>

#include "grammar/polygon.h"

namespace parti::grammar {

/// A corner of the outline (distance 0), or a point where fronts that move inward from the edges
/// meet.
struct SkeletonNode {
  Vec2 at{0, 0};
  double distance_m = 0;  ///< from the edges that meet here
};

/// The polygon divided into one face per edge: the part that the edge sweeps when it moves inward.
/// Lifted by their distances, the faces are the planes of a hip roof of 45 degrees.
struct Skeleton {
  Polygon polygon;                  ///< Straightened
  std::vector<SkeletonNode> nodes;  ///< first its corners, ring by ring
  /// Corner numbers of each face, counter-clockwise, its edge first. Faces share nodes: every edge
  /// inside is in two faces, once each way round.
  std::vector<std::vector<uint32_t>> faces;
};

/// Corners that lie nearer to the line through their neighbours than this share of the polygon's
/// extent are left out of skeletons (0.1 mm of 60 m): surveys put them on straight walls.
inline constexpr double kStraight = 1.5e-6;

/// The longer side of the polygon's bounds.
double ExtentOf(const Polygon& polygon);

/// The polygon without the corners that bend its rings by less than kStraight of `extent_m`, and
/// without edges that short. Rings that nothing is left of are dropped; the outer one is kept as it
/// is.
Polygon Straightened(const Polygon& polygon, double extent_m);

/// The skeleton of Straightened(polygon, extent_m); faces in the order of its edges, ring by ring.
///
/// CGAL's algorithm, exact where it decides, on corners that are rounded to a grid of 2^-26 of the
/// extent_m (0.5 um of 30 m): rounding makes what nearly happens at once happen at once, and the
/// arithmetic short. Which fronts meet is taken from that; where they meet is then solved for with
/// the edges as they were given.
///
/// errors  kDegenerateGeometry  CGAL refuses the polygon, or gives no division of it.
/// cost    about n^2 log n; 150 edges take 20 ms.
/// source  Aichholzer et al. 1995; CGAL, 2D Straight Skeleton and Polygon Offsetting.
Result<Skeleton> StraightSkeleton(const Polygon& polygon, double extent_m);
Result<Skeleton> StraightSkeleton(const Polygon& polygon);  ///< extent_m is the polygon's

/// What the fronts enclose that have moved inward by distance_m > 0: pieces with holes, slivers
/// included. Found by following the level through the faces: nothing can go wrong where nodes lie
/// on it.
std::vector<Polygon> LevelOf(const Skeleton& skeleton, double distance_m);

}  // namespace parti::grammar
