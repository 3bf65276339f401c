#include "grammar/reframe.h"

#include <cmath>
#include <memory>
#include <utility>

#include "grammar/item_make.h"

namespace parti::grammar {
namespace {

/// Directions with less of a length than this have none.
constexpr double kShortest = 1e-6;

Item TurnedInPlane(const Item& planar, const Vec3& x) {
  const Vec3 level = x - planar.scope.z * glm::dot(x, planar.scope.z);
  if (glm::length(level) < kShortest) return planar;
  Scope frame = planar.scope;
  frame.x = glm::normalize(level);
  frame.y = glm::cross(frame.z, frame.x);
  Polygon polygon = PolygonOf(planar);
  const auto turn = [&](Ring* ring) {
    for (Vec2& p : *ring) {
      const Vec3 local = frame.ToLocal(planar.scope.ToWorld(Vec3(p.x, p.y, 0)));
      p = Vec2(local.x, local.y);
    }
  };
  turn(&polygon.outer);
  for (Ring& hole : polygon.holes) turn(&hole);
  const Item made = PlanarItem(frame, std::move(polygon), planar);
  Item turned = planar;
  turned.scope = made.scope;
  turned.scope.size.z = planar.scope.size.z;
  turned.polygon = made.polygon;
  return turned;
}

Item TurnedAround(const Item& volume, const Scope& axes) {
  const Scope& before = volume.scope;
  Scope frame = axes;
  frame.origin = before.origin;
  Mesh mesh = MeshOf(volume);
  for (Vec3& p : mesh.points) p = frame.ToLocal(before.ToWorld(p));
  for (Paint& paint : mesh.paints) {
    if (!paint.map) continue;
    const TextureMap map = InFrame(*paint.map, before.origin, before.x, before.y, before.z);
    paint.map = LocalIn(map, frame.origin, frame.x, frame.y, frame.z);
  }
  const Item made = VolumeItem(frame, std::move(mesh), volume);
  Item turned = volume;
  turned.scope = made.scope;
  turned.mesh = made.mesh;
  turned.mesh_is_unit = false;
  return turned;
}

}  // namespace

Vec3 TurnedAbout(int axis, const Angle& angle, const Vec3& v) {
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const double cosine = std::cos(angle.radians()), sine = std::sin(angle.radians());
  Vec3 turned = v;
  turned[j] = cosine * v[j] - sine * v[k];
  turned[k] = sine * v[j] + cosine * v[k];
  return turned;
}

Scope TurnedAxes(const Scope& scope, const Vec3& angles_deg) {
  const auto turn = [&](Vec3 v) {
    for (int i = 0; i < 3; ++i) {
      if (angles_deg[i] != 0) v = TurnedAbout(i, Angle::Degrees(angles_deg[i]), v);
    }
    return scope.x * v.x + scope.y * v.y + scope.z * v.z;
  };
  Scope turned = scope;
  turned.x = turn(Vec3(1, 0, 0));
  turned.y = turn(Vec3(0, 1, 0));
  turned.z = turn(Vec3(0, 0, 1));
  return turned;
}

Item Reframed(const Item& item, const Scope& axes) {
  Item turned = IsFlat(item.type) ? TurnedInPlane(item, axes.x) : TurnedAround(item, axes);
  turned.anchor.reset();
  return turned;
}

}  // namespace parti::grammar
