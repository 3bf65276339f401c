// GEOS 3.11: OverlayNG, with doubles as they are and on a grid of 1e-8 m.
#include <geos_c.h>

#include <algorithm>

#include "tests/bench/overlay/overlay_library.h"

namespace parti::bench {
namespace {

using grammar::Polygon;
using grammar::Ring;

constexpr double kGrid_m = 1e-8;

/// One call's geometries; nothing is freed before its end.
class Geos {
 public:
  Geos() : handle_(GEOS_init_r()) {}
  ~Geos() {
    for (GEOSGeometry* geometry : made_) GEOSGeom_destroy_r(handle_, geometry);
    GEOS_finish_r(handle_);
  }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  GEOSContextHandle_t handle() const { return handle_; }
  GEOSGeometry* Keep(GEOSGeometry* geometry) {
    if (geometry != nullptr) made_.push_back(geometry);
    return geometry;
  }

  GEOSGeometry* From(const Polygon& polygon) {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : polygon.holes) holes.push_back(From(hole));
    return GEOSGeom_createPolygon_r(handle_, From(polygon.outer), holes.data(),
                                    static_cast<unsigned>(holes.size()));
  }
  GEOSGeometry* UnionOf(const Polygons& parts) {
    std::vector<GEOSGeometry*> all;
    for (const Polygon& part : parts) all.push_back(From(part));
    GEOSGeometry* collection = Keep(GEOSGeom_createCollection_r(
        handle_, GEOS_MULTIPOLYGON, all.data(), static_cast<unsigned>(all.size())));
    return Keep(GEOSUnaryUnion_r(handle_, collection));
  }

  std::optional<Polygons> Read(GEOSGeometry* geometry) {
    if (Keep(geometry) == nullptr) return std::nullopt;
    Polygons polygons;
    Add(geometry, &polygons);
    return polygons;
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
  Ring RingFrom(const GEOSGeometry* line) {
    const GEOSCoordSequence* corners = GEOSGeom_getCoordSeq_r(handle_, line);
    unsigned n = 0;
    GEOSCoordSeq_getSize_r(handle_, corners, &n);
    Ring ring(n > 0 ? n - 1 : 0);
    for (unsigned i = 0; i < ring.size(); ++i) {
      GEOSCoordSeq_getXY_r(handle_, corners, i, &ring[i].x, &ring[i].y);
    }
    return ring;
  }
  void Add(const GEOSGeometry* geometry, Polygons* polygons) {
    if (GEOSGeomTypeId_r(handle_, geometry) == GEOS_POLYGON) {
      if (GEOSisEmpty_r(handle_, geometry) != 0) return;
      Polygon polygon{RingFrom(GEOSGetExteriorRing_r(handle_, geometry)), {}};
      const int holes = GEOSGetNumInteriorRings_r(handle_, geometry);
      for (int i = 0; i < holes; ++i) {
        polygon.holes.push_back(RingFrom(GEOSGetInteriorRingN_r(handle_, geometry, i)));
      }
      if (grammar::SignedArea(polygon.outer) < 0) {
        std::reverse(polygon.outer.begin(), polygon.outer.end());
        for (Ring& hole : polygon.holes) std::reverse(hole.begin(), hole.end());
      }
      polygons->push_back(std::move(polygon));
      return;
    }
    const int parts = GEOSGetNumGeometries_r(handle_, geometry);
    for (int i = 0; i < parts; ++i) {
      const GEOSGeometry* part = GEOSGetGeometryN_r(handle_, geometry, i);
      if (part != geometry) Add(part, polygons);
    }
  }

  GEOSContextHandle_t handle_;
  std::vector<GEOSGeometry*> made_;
};

std::optional<Polygons> Intersection(const Polygon& a, const Polygon& b) {
  Geos geos;
  GEOSGeometry *p = geos.Keep(geos.From(a)), *q = geos.Keep(geos.From(b));
  return geos.Read(GEOSIntersection_r(geos.handle(), p, q));
}

std::optional<Polygons> IntersectionOnGrid(const Polygon& a, const Polygon& b) {
  Geos geos;
  GEOSGeometry *p = geos.Keep(geos.From(a)), *q = geos.Keep(geos.From(b));
  return geos.Read(GEOSIntersectionPrec_r(geos.handle(), p, q, kGrid_m));
}

std::optional<Polygons> Difference(const Polygon& whole, const Polygons& parts) {
  Geos geos;
  GEOSGeometry* covered = geos.UnionOf(parts);
  if (covered == nullptr) return std::nullopt;
  return geos.Read(GEOSDifference_r(geos.handle(), geos.Keep(geos.From(whole)), covered));
}

std::optional<Polygons> DifferenceOnGrid(const Polygon& whole, const Polygons& parts) {
  Geos geos;
  GEOSGeometry* covered = geos.UnionOf(parts);
  if (covered == nullptr) return std::nullopt;
  GEOSGeometry* from = geos.Keep(geos.From(whole));
  return geos.Read(GEOSDifferencePrec_r(geos.handle(), from, covered, kGrid_m));
}

}  // namespace

const OverlayLibrary kGeos = {"GEOS", Intersection, Difference};
const OverlayLibrary kGeosOnGrid = {"GEOS, grid", IntersectionOnGrid, DifferenceOnGrid};

}  // namespace parti::bench
