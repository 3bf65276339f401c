// A part of a scene's plane: a rectangle along its axes, which most shapes of façades are, or
// polygons. Rectangles are cut exactly.
// Polygons are cut with polygons behind polygon_overlap.h.
#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "grammar/layers/stitch.h"

namespace parti::grammar {

/// A value. No polygons: all of `bounds`, or nothing where bounds have no area.
struct Region {
  Box2 bounds;
  std::vector<Polygon> polygons;  ///< apart from each other

  bool operator==(const Region&) const;
};

/// Nothing has bounds without area, and no polygons.
bool IsEmpty(const Region& region);
Region RegionOf(std::vector<Polygon> polygons);
std::vector<Polygon> PolygonsOf(const Region& region);
double AreaOf(const Region& region);

/// Whether bounds share more than a negligible strip.
bool MayOverlap(const Box2& a, const Box2& b, double tolerance_m);

/// What lies in both; nothing where only negligible strips do. Equal to `a` where b covers it.
/// errors  kDegenerateGeometry  a polygon that is not simple.
Result<Region> Shared(const Region& a, const Region& b, const Negligible& negligible);

/// The region without parts of it that don't overlap each other.
Region Without(const Region& region, std::span<const Region> parts, const Negligible& negligible);

}  // namespace parti::grammar
