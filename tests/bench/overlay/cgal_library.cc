// CGAL 5.5: exact numbers. What the others are compared with.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <exception>

#include "tests/bench/overlay/overlay_library.h"

namespace parti::bench {
namespace {

using grammar::Polygon;
using grammar::Ring;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Simple = CGAL::Polygon_2<Kernel>;
using Holed = CGAL::Polygon_with_holes_2<Kernel>;
using Set = CGAL::Polygon_set_2<Kernel>;

Simple From(const Ring& ring) {
  Simple polygon;
  for (const Vec2& p : ring) polygon.push_back({p.x, p.y});
  return polygon;
}
Holed From(const Polygon& polygon) {
  Holed holed(From(polygon.outer));
  for (const Ring& hole : polygon.holes) holed.add_hole(From(hole));
  return holed;
}
Ring RingFrom(const Simple& polygon) {
  Ring ring;
  for (const auto& p : polygon.vertices()) {
    ring.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  }
  return ring;
}
Polygons Read(const std::vector<Holed>& found) {
  Polygons polygons;
  for (const Holed& holed : found) {
    Polygon polygon{RingFrom(holed.outer_boundary()), {}};
    for (const Simple& hole : holed.holes()) polygon.holes.push_back(RingFrom(hole));
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

std::optional<Polygons> Intersection(const Polygon& a, const Polygon& b) {
  try {
    std::vector<Holed> found;
    CGAL::intersection(From(a), From(b), std::back_inserter(found));
    return Read(found);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<Polygons> Difference(const Polygon& whole, const Polygons& parts) {
  try {
    std::vector<Holed> all;
    for (const Polygon& part : parts) all.push_back(From(part));
    Set covered, left(From(whole));
    covered.join(all.begin(), all.end());
    left.difference(covered);
    std::vector<Holed> found;
    left.polygons_with_holes(std::back_inserter(found));
    return Read(found);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace

const OverlayLibrary kCgal = {"CGAL, exact", Intersection, Difference};

}  // namespace parti::bench
