#include "app/snap.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/picking.h"

namespace parti::app {
namespace {

constexpr double kOnPlane_m = 1e-4;

bool LiesOn(const Plane& plane, const Segment3& edge) {
  const auto off = [&](const Vec3& p) {
    return std::abs(glm::dot(plane.normal, p) - plane.offset);
  };
  return off(edge.a) < kOnPlane_m && off(edge.b) < kOnPlane_m;
}

/// Its own name, else that of the nearest shape above it that has one.
std::string NameOf(const Model& model, const ShapeRef& ref) {
  const grammar::ShapeTree& tree = model.derived[ref.lot]->tree;
  for (auto shape = ref.shape; shape != grammar::kNoShape; shape = tree.node(shape).parent) {
    const std::string_view name = tree.Name(tree[shape].symbol);
    if (!name.empty()) return std::string(name);
  }
  return "shape";
}

/// The nearest of what has been seen so far.
struct Nearest {
  double px = std::numeric_limits<double>::infinity();
  Vec3 point{0, 0, 0};
  Segment3 edge;
};

void TryCorner(const View& view, const Vec3& corner, const Vec2& px, Nearest* nearest) {
  const auto seen = view.Project(corner);
  if (!seen || glm::distance(*seen, px) >= nearest->px) return;
  *nearest = {glm::distance(*seen, px), corner, {corner, corner}};
}

/// `on_plane`: where the line of sight meets the face.
void TryEdge(const View& view, const Segment3& edge, const Vec2& px, const Vec3& on_plane,
             Nearest* nearest) {
  const Vec3 along = edge.b - edge.a;
  const double length2 = glm::dot(along, along);
  if (length2 <= 0) return;
  const double u = std::clamp(glm::dot(on_plane - edge.a, along) / length2, 0.0, 1.0);
  const Vec3 point = edge.a + along * u;
  const auto seen = view.Project(edge);
  if (!seen) return;
  const Vec2 line = seen->b - seen->a;
  const double line2 = glm::dot(line, line);
  const double v = line2 > 0 ? std::clamp(glm::dot(px - seen->a, line) / line2, 0.0, 1.0) : 0;
  const double distance = glm::distance(px, seen->a + line * v);
  if (distance < nearest->px) *nearest = {distance, point, edge};
}

}  // namespace

std::optional<Snap> SnapAt(const Model& model, const ShapeRef& ref, const Camera& camera,
                           const Vec2& px, double reach_px) {
  const auto plane = PlaneAt(model, ref, camera, px);
  if (!plane) return std::nullopt;
  const View view(camera);
  const auto hit = Intersect(view.RayThrough(px), *plane);
  if (!hit) return std::nullopt;
  Nearest corner, edge;
  for (const Segment3& e : grammar::EdgesOf(ShapeAt(model, ref).item)) {
    if (!LiesOn(*plane, e)) continue;
    TryCorner(view, e.a, px, &corner);
    TryCorner(view, e.b, px, &corner);
    TryEdge(view, e, px, *hit, &edge);
  }
  const std::string name = NameOf(model, ref);
  if (corner.px <= reach_px) {
    return Snap{Snap::Kind::kCorner, corner.point, {}, "corner of " + name};
  }
  if (edge.px <= reach_px) {
    return Snap{Snap::Kind::kEdge, edge.point, edge.edge, "edge of " + name};
  }
  return Snap{Snap::Kind::kFace, *hit, {}, name};
}

}  // namespace parti::app
