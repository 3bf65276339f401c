#include "grammar/layers/polygon_overlap.h"

#include <geos_c.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace parti::grammar {
namespace {

/// One call's GEOS: its messages are not printed, and nothing is shared between threads.
class Geos {
 public:
  using Geometry = std::unique_ptr<GEOSGeometry, void (*)(GEOSGeometry*)>;

  Geos() : handle_(GEOS_init_r()) {}
  ~Geos() { GEOS_finish_r(handle_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  GEOSGeometry* From(const Polygon& polygon) {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : polygon.holes) holes.push_back(From(hole));
    return GEOSGeom_createPolygon_r(handle_, From(polygon.outer), holes.data(),
                                    static_cast<unsigned>(holes.size()));
  }

  /// The polygons in a geometry: lines and points, where areas only touch, are none.
  void AddPolygons(const GEOSGeometry* geometry, std::vector<Polygon>* polygons) {
    if (GEOSGeomTypeId_r(handle_, geometry) == GEOS_POLYGON) {
      if (GEOSisEmpty_r(handle_, geometry) != 0) return;
      Polygon polygon{RingFrom(GEOSGetExteriorRing_r(handle_, geometry), false), {}};
      const int holes = GEOSGetNumInteriorRings_r(handle_, geometry);
      for (int i = 0; i < holes; ++i) {
        polygon.holes.push_back(RingFrom(GEOSGetInteriorRingN_r(handle_, geometry, i), true));
      }
      polygons->push_back(std::move(polygon));
      return;
    }
    const int parts = GEOSGetNumGeometries_r(handle_, geometry);
    for (int i = 0; i < parts; ++i) {
      const GEOSGeometry* part = GEOSGetGeometryN_r(handle_, geometry, i);
      if (part != geometry) AddPolygons(part, polygons);
    }
  }

  GEOSGeometry* Intersection(const GEOSGeometry* a, const GEOSGeometry* b) {
    return GEOSIntersection_r(handle_, a, b);
  }
  void Destroy(GEOSGeometry* geometry) {
    if (geometry != nullptr) GEOSGeom_destroy_r(handle_, geometry);
  }

 private:
  GEOSGeometry* From(const Ring& ring) {
    const auto n = static_cast<unsigned>(ring.size());
    GEOSCoordSequence* corners = GEOSCoordSeq_create_r(handle_, n + 1, 2);
    for (unsigned i = 0; i <= n; ++i) {
      GEOSCoordSeq_setXY_r(handle_, corners, i, ring[i % n].x, ring[i % n].y);
    }
    return GEOSGeom_createLinearRing_r(handle_, corners);
  }

  Ring RingFrom(const GEOSGeometry* line, bool hole) {
    const GEOSCoordSequence* corners = GEOSGeom_getCoordSeq_r(handle_, line);
    unsigned n = 0;
    GEOSCoordSeq_getSize_r(handle_, corners, &n);
    Ring ring(n > 0 ? n - 1 : 0);
    for (unsigned i = 0; i < ring.size(); ++i) {
      GEOSCoordSeq_getXY_r(handle_, corners, i, &ring[i].x, &ring[i].y);
    }
    if ((SignedArea(ring) < 0) != hole) std::reverse(ring.begin(), ring.end());
    return ring;
  }

  GEOSContextHandle_t handle_;
};

}  // namespace

Result<std::vector<Polygon>> Overlap(const Polygon& a, const Polygon& b) {
  Geos geos;
  GEOSGeometry* const from_a = geos.From(a);
  GEOSGeometry* const from_b = geos.From(b);
  GEOSGeometry* const both =
      from_a != nullptr && from_b != nullptr ? geos.Intersection(from_a, from_b) : nullptr;
  std::vector<Polygon> polygons;
  if (both != nullptr) geos.AddPolygons(both, &polygons);
  for (GEOSGeometry* geometry : {from_a, from_b, both}) geos.Destroy(geometry);
  if (both != nullptr) return polygons;
  return Fail(ErrorCode::kDegenerateGeometry, "a polygon that crosses itself can't be cut",
              "move its corners apart");
}

}  // namespace parti::grammar
