#include "grammar/layers/region.h"

#include <utility>

#include "grammar/layers/polygon_overlap.h"

namespace parti::grammar {
namespace {

Polygon PolygonOf(const Box2& box) {
  return {{box.low, Vec2(box.high.x, box.low.y), box.high, Vec2(box.low.x, box.high.y)}, {}};
}

bool IsRectangle(const Polygon& polygon, const Box2& box) {
  if (!polygon.holes.empty() || polygon.outer.size() != 4) return false;
  for (const Vec2& p : polygon.outer) {
    const bool corner =
        (p.x == box.low.x || p.x == box.high.x) && (p.y == box.low.y || p.y == box.high.y);
    if (!corner) return false;
  }
  return true;
}

Box2 Common(const Box2& a, const Box2& b) {
  return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

bool Encloses(const Box2& outer, const Box2& inner, double tolerance) {
  return inner.low.x >= outer.low.x - tolerance && inner.low.y >= outer.low.y - tolerance &&
         inner.high.x <= outer.high.x + tolerance && inner.high.y <= outer.high.y + tolerance;
}

/// A polygon cut to a rectangle, along the axes that need it.
std::vector<Polygon> Cropped(const Polygon& polygon, const Box2& box) {
  std::vector<Polygon> cropped;
  for (const Polygon& strip : Slab(polygon, 0, box.low.x, box.high.x)) {
    for (Polygon& piece : Slab(strip, 1, box.low.y, box.high.y)) {
      cropped.push_back(std::move(piece));
    }
  }
  return cropped;
}

}  // namespace

bool Region::operator==(const Region& other) const {
  return bounds.low == other.bounds.low && bounds.high == other.bounds.high &&
         polygons == other.polygons;
}

bool IsEmpty(const Region& region) {
  return !(region.bounds.high.x > region.bounds.low.x &&
           region.bounds.high.y > region.bounds.low.y);
}

Region RegionOf(std::vector<Polygon> polygons) {
  Region region;
  if (polygons.empty()) return region;
  region.bounds = Bounds(polygons[0]);
  for (const Polygon& polygon : polygons) {
    const Box2 box = Bounds(polygon);
    region.bounds.low = glm::min(region.bounds.low, box.low);
    region.bounds.high = glm::max(region.bounds.high, box.high);
  }
  if (polygons.size() == 1 && IsRectangle(polygons[0], region.bounds)) return region;
  region.polygons = std::move(polygons);
  return region;
}

std::vector<Polygon> PolygonsOf(const Region& region) {
  if (!region.polygons.empty()) return region.polygons;
  if (IsEmpty(region)) return {};
  return {PolygonOf(region.bounds)};
}

double AreaOf(const Region& region) {
  if (IsEmpty(region)) return 0;
  const Vec2 size = region.bounds.high - region.bounds.low;
  if (region.polygons.empty()) return size.x * size.y;
  double area = 0;
  for (const Polygon& polygon : region.polygons) area += Area(polygon);
  return area;
}

bool MayOverlap(const Box2& a, const Box2& b, double tolerance_m) {
  const Vec2 size = Common(a, b).high - Common(a, b).low;
  return size.x > tolerance_m && size.y > tolerance_m;
}

Result<Region> Shared(const Region& a, const Region& b, const Negligible& negligible) {
  const double tolerance = negligible.length_m;
  if (!MayOverlap(a.bounds, b.bounds, tolerance)) return Region();
  if (b.polygons.empty() && Encloses(b.bounds, a.bounds, tolerance)) return a;
  if (a.polygons.empty() && b.polygons.empty()) return Region{Common(a.bounds, b.bounds), {}};
  std::vector<Polygon> shared;
  if (b.polygons.empty() || a.polygons.empty()) {
    const Region& cut = b.polygons.empty() ? a : b;
    const Box2& box = b.polygons.empty() ? b.bounds : a.bounds;
    for (const Polygon& polygon : cut.polygons) {
      for (Polygon& piece : Cropped(polygon, box)) shared.push_back(std::move(piece));
    }
    return RegionOf(std::move(shared));
  }
  for (const Polygon& p : a.polygons) {
    for (const Polygon& q : b.polygons) {
      if (!MayOverlap(Bounds(p), Bounds(q), tolerance)) continue;
      auto pieces = Overlap(p, q);
      if (!pieces) return Fail(pieces);
      for (Polygon& piece : *pieces) shared.push_back(std::move(piece));
    }
  }
  // Stitched, as a hole may come to lie on its outline by less than counts. Small areas count here:
  // regions that share one are not disjoint.
  return RegionOf(Stitch(shared, {}, {tolerance, 0}));
}

Region Without(const Region& region, std::span<const Region> parts, const Negligible& negligible) {
  std::vector<Polygon> minus;
  for (const Region& part : parts) {
    for (Polygon& polygon : PolygonsOf(part)) minus.push_back(std::move(polygon));
  }
  return RegionOf(Stitch(PolygonsOf(region), minus, negligible));
}

}  // namespace parti::grammar
