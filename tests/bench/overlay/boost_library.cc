// Boost.Polygon 1.74: integers of 32 bits; a grid of 1e-7 m, which spans 200 m.
#include <boost/polygon/polygon.hpp>
#include <cmath>

#include "tests/bench/overlay/overlay_library.h"

namespace parti::bench {
namespace {

namespace bp = boost::polygon;
using grammar::Polygon;
using grammar::Ring;
using Set = bp::polygon_set_data<int>;
using Holed = bp::polygon_with_holes_data<int>;

constexpr double kPerMetre = 1e7;

std::vector<bp::point_data<int>> PointsOf(const Ring& ring) {
  std::vector<bp::point_data<int>> points;
  for (const Vec2& p : ring) {
    points.emplace_back(static_cast<int>(std::lround(p.x * kPerMetre)),
                        static_cast<int>(std::lround(p.y * kPerMetre)));
  }
  return points;
}

void Insert(const Polygon& polygon, Set* set) {
  const auto outer = PointsOf(polygon.outer);
  bp::polygon_data<int> outline;
  outline.set(outer.begin(), outer.end());
  set->insert(outline);
  for (const Ring& ring : polygon.holes) {
    const auto points = PointsOf(ring);
    bp::polygon_data<int> hole;
    hole.set(points.begin(), points.end());
    set->insert(hole, true);
  }
}

template <typename Points>
Ring RingFrom(const Points& points) {
  Ring ring;
  for (auto p = points.begin(); p != points.end(); ++p) {
    ring.emplace_back(bp::x(*p) / kPerMetre, bp::y(*p) / kPerMetre);
  }
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

Polygons Read(const Set& set) {
  std::vector<Holed> found;
  set.get(found);
  Polygons polygons;
  for (const Holed& holed : found) {
    Polygon polygon{RingFrom(holed), {}};
    for (auto hole = holed.begin_holes(); hole != holed.end_holes(); ++hole) {
      polygon.holes.push_back(RingFrom(*hole));
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

std::optional<Polygons> Intersection(const Polygon& a, const Polygon& b) {
  using bp::operators::operator&=;
  Set p, q;
  Insert(a, &p);
  Insert(b, &q);
  p &= q;
  return Read(p);
}

std::optional<Polygons> Difference(const Polygon& whole, const Polygons& parts) {
  using bp::operators::operator-=;
  Set set, covered;
  Insert(whole, &set);
  for (const Polygon& part : parts) Insert(part, &covered);
  set -= covered;
  return Read(set);
}

}  // namespace

const OverlayLibrary kBoostPolygon = {"Boost.Polygon", Intersection, Difference};

}  // namespace parti::bench
