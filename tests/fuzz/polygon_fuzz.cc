// Bytes to rings to everything that polygons go through. What PolygonFrom lets pass must hold all
// of the polygon's promises.
//
// Bytes: one for the mode (0: a byte per coordinate, on a grid, so that corners coincide and line
// up; else 8 bytes per coordinate, any double at all), one for a cut and a distance, then corners;
// in grid mode the pair 255, any starts the next ring.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/check.h"
#include "grammar/mesh.h"
#include "grammar/operation.h"
#include "grammar/polygon.h"

namespace parti::grammar {
namespace {

constexpr size_t kMostCorners = 60;

std::vector<Ring> GridRings(const uint8_t* data, size_t size) {
  std::vector<Ring> rings(1);
  for (size_t i = 0; i + 1 < size && i < 2 * kMostCorners; i += 2) {
    if (data[i] == 255) {
      rings.emplace_back();
      continue;
    }
    rings.back().emplace_back(data[i] % 32, data[i + 1] % 32);
  }
  return rings;
}

std::vector<Ring> AnyRings(const uint8_t* data, size_t size) {
  std::vector<Ring> rings(1);
  for (size_t i = 0; i + 16 <= size && i < 16 * kMostCorners; i += 16) {
    Vec2 p;
    std::memcpy(&p.x, data + i, 8);
    std::memcpy(&p.y, data + i + 8, 8);
    rings.back().push_back(p);
  }
  return rings;
}

double SumOfAreas(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& p : polygons) {
    CHECK(SignedArea(p.outer) > 0, "outlines run counter-clockwise");
    for (const Ring& hole : p.holes) CHECK(SignedArea(hole) < 0, "holes run clockwise");
    sum += Area(p);
  }
  return sum;
}

void CheckTriangles(const Polygon& polygon, double tolerance) {
  Ring corners = polygon.outer;
  for (const Ring& hole : polygon.holes) corners.insert(corners.end(), hole.begin(), hole.end());
  double sum = 0;
  const auto triangles = Triangulate(polygon);
  for (size_t i = 0; i < triangles.size(); i += 3) {
    sum +=
        SignedArea({corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]});
  }
  CHECK(std::abs(sum - Area(polygon)) <= tolerance, "triangles cover the polygon");
}

void CheckSlabs(const Polygon& polygon, double share, double tolerance) {
  const Box2 box = Bounds(polygon);
  for (const int axis : {0, 1}) {
    const double at = box.low[axis] + share * (box.high[axis] - box.low[axis]);
    const auto below = Slab(polygon, axis, box.low[axis], at);
    const auto above = Slab(polygon, axis, at, box.high[axis]);
    CHECK(std::abs(SumOfAreas(below) + SumOfAreas(above) - Area(polygon)) <= tolerance,
          "slabs tile the polygon");
    for (const Polygon& piece : below) CheckTriangles(piece, tolerance);
  }
}

void CheckOffsets(const Polygon& polygon, double distance, double tolerance) {
  const auto inward = Offset(polygon, distance);
  if (inward) {
    CHECK(SumOfAreas(*inward) <= Area(polygon) + tolerance, "what moves inward shrinks");
    CHECK(std::abs(SumOfAreas(*inward) + SumOfAreas(Border(polygon, *inward)) - Area(polygon)) <=
              tolerance,
          "inside and border make the whole");
  }
  const auto outward = Offset(polygon, -distance);
  if (outward) CHECK(SumOfAreas(*outward) >= Area(polygon) - tolerance, "outward grows");
}

void CheckCutPrism(const Polygon& polygon, double share, double tolerance) {
  const Mesh prism = Prism(polygon, 2);
  const Box2 box = Bounds(polygon);
  const double at = box.low.x + share * (box.high.x - box.low.x);
  const Mesh below = Slab(prism, 0, box.low.x, at), above = Slab(prism, 0, at, box.high.x);
  CHECK(std::abs(Volume(below) + Volume(above) - 2 * Area(polygon)) <= 2 * tolerance,
        "slabs tile the prism");
}

void Run(const std::vector<Ring>& rings, double share, double distance) {
  const auto polygon = PolygonFrom(rings);
  if (!polygon) {
    CHECK(!polygon.error().message.empty(), "a refusal says why");
    return;
  }
  // What doubles can hold of this size.
  const Box2 box = Bounds(*polygon);
  const double extent = glm::length(box.high - box.low);
  const double far = std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x),
                               std::abs(box.high.y), extent});
  const double tolerance = 1e-6 + 1e-7 * extent + 1e-12 * far * extent;
  CHECK(SumOfAreas({*polygon}) > 0, "a polygon has an area");
  CheckTriangles(*polygon, tolerance);
  CheckSlabs(*polygon, share, tolerance);
  CheckCutPrism(*polygon, share, tolerance);
  if (extent < 1e4 && far < 1e6) CheckOffsets(*polygon, distance, tolerance);
}

}  // namespace
}  // namespace parti::grammar

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace parti::grammar;
  if (size < 3) return 0;
  const double share = (data[1] % 33) / 32.0;
  const double distance = (1 + data[1] % 16) / 8.0;
  Run(data[0] == 0 ? GridRings(data + 2, size - 2) : AnyRings(data + 2, size - 2), share, distance);
  return 0;
}
