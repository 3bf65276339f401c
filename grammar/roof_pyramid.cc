// Pyramids and tapers: all edges to one point. Hip roofs stand in where no point sees all edges.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "grammar/roof_plan.h"

namespace parti::grammar {
namespace {

/// The point must lie inside of every edge by this share of the extent.
constexpr double kSees = 1e-4;

Vec2 CentroidOf(const Ring& ring) {
  Vec2 sum(0, 0);
  double doubled = 0;
  for (size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec2 a = ring[i] - ring[0], b = ring[i + 1] - ring[0];
    sum += (a + b) * (Cross(a, b) / 3);
    doubled += Cross(a, b);
  }
  return ring[0] + sum / doubled;
}

double DistanceFrom(const Ring& ring, size_t edge, const Vec2& p) {
  const Vec2 along = glm::normalize(ring[(edge + 1) % ring.size()] - ring[edge]);
  return Cross(along, p - ring[edge]);
}

bool SeesAll(const Ring& ring, const Vec2& p) {
  const double margin = kSees * ExtentOf({ring, {}});
  for (size_t i = 0; i < ring.size(); ++i) {
    if (DistanceFrom(ring, i, p) < margin) return false;
  }
  return true;
}

/// What is left of the ring after everything that edge `edge` does not see is cut off.
Ring CutAlong(const Ring& ring, size_t edge, const Ring& left) {
  Ring kept;
  for (size_t i = 0; i < left.size(); ++i) {
    const Vec2 &a = left[i], &b = left[(i + 1) % left.size()];
    const double da = DistanceFrom(ring, edge, a), db = DistanceFrom(ring, edge, b);
    if (da >= 0) kept.push_back(a);
    if ((da >= 0) != (db >= 0)) kept.push_back(a + (b - a) * (da / (da - db)));
  }
  return kept;
}

std::optional<Vec2> ApexOver(const Polygon& polygon) {
  const Ring& ring = polygon.outer;
  if (!polygon.holes.empty()) return std::nullopt;
  const Vec2 centroid = CentroidOf(ring);
  if (SeesAll(ring, centroid)) return centroid;
  const Box2 box = Bounds(polygon);
  Ring kernel = {box.low, Vec2(box.high.x, box.low.y), box.high, Vec2(box.low.x, box.high.y)};
  for (size_t i = 0; i < ring.size() && !kernel.empty(); ++i) kernel = CutAlong(ring, i, kernel);
  if (kernel.size() < 3 || !(SignedArea(kernel) > 0)) return std::nullopt;
  const Vec2 middle = CentroidOf(kernel);
  return SeesAll(ring, middle) ? std::optional(middle) : std::nullopt;
}

Mesh PyramidOver(const Polygon& polygon, const Vec2& apex, double height) {
  const Ring& ring = polygon.outer;
  RoofPlan plan{polygon, {}, {}};
  const auto n = static_cast<uint32_t>(ring.size());
  for (const Vec2& p : ring) plan.points.emplace_back(p, 0);
  plan.points.emplace_back(apex, height);
  for (uint32_t i = 0; i < n; ++i) plan.faces.push_back({i, (i + 1) % n, n});
  return MeshOf(plan);
}

/// The pyramid cut off: its top is the outline, `top` times as wide.
Mesh FrustumOver(const Polygon& polygon, const Vec2& apex, double height, double top) {
  const Ring& ring = polygon.outer;
  RoofPlan plan{polygon, {}, {}};
  const auto n = static_cast<uint32_t>(ring.size());
  std::vector<uint32_t> lid;
  for (const Vec2& p : ring) plan.points.emplace_back(p, 0);
  for (const Vec2& p : ring) plan.points.emplace_back(apex + (p - apex) * top, height);
  for (uint32_t i = 0; i < n; ++i) {
    plan.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    lid.push_back(n + i);
  }
  plan.faces.push_back(std::move(lid));
  return MeshOf(plan);
}

Result<Mesh> Upward(const Polygon& polygon, double height, double top) {
  const Polygon straight = Straightened(polygon, ExtentOf(polygon));
  if (const auto apex = ApexOver(straight)) {
    return top > 0 ? FrustumOver(straight, *apex, height, top)
                   : PyramidOver(straight, *apex, height);
  }
  auto hip = HipRoof(polygon, {true, height / (1 - top)}, 0);
  if (!hip || !(top > 0)) return hip;
  return Slab(*hip, 2, 0, height);
}

/// Seen in the plane that it stands on; faces look outward all the same, and begin as they did.
void TurnDown(Mesh* mesh) {
  for (Vec3& p : mesh->points) p.z = -p.z;
  const auto turn = [](std::vector<uint32_t>* loop) {
    std::reverse(loop->begin(), loop->end());
    std::rotate(loop->begin(), loop->end() - 2, loop->end());
  };
  for (MeshFace& face : mesh->faces) {
    turn(&face.loop);
    for (auto& hole : face.holes) turn(&hole);
  }
}

}  // namespace

Result<Mesh> PyramidRoof(const Polygon& polygon, const RoofPitch& pitch, size_t front_edge) {
  const Polygon straight = Straightened(polygon, ExtentOf(polygon));
  const auto apex = ApexOver(straight);
  if (!apex) return HipRoof(polygon, pitch, 0);
  const auto slope = SlopeOf(pitch, 1);
  if (!slope) return Fail(slope);
  const double height =
      pitch.by_height ? pitch.value : *slope * DistanceFrom(polygon.outer, front_edge, *apex);
  if (!(height > kLengthTolerance_m)) return HipRoof(polygon, pitch, 0);
  return PyramidOver(straight, *apex, height);
}

Result<Mesh> Taper(const Polygon& polygon, double height_m, double top) {
  if (!(std::abs(height_m) > kLengthTolerance_m)) {
    return Fail(ErrorCode::kDegenerateGeometry, "taper by 0 makes no volume",
                "give a height other than 0; negative goes downward");
  }
  auto mesh = Upward(polygon, std::abs(height_m), top);
  if (mesh && height_m < 0) TurnDown(&*mesh);
  return mesh;
}

}  // namespace parti::grammar
