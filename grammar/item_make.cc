#include "grammar/item_make.h"

#include <utility>

namespace parti::grammar {
namespace {

/// Geometry that fills this part of its bounds is the whole of it.
constexpr double kFull = 1 - 1e-9;
/// Axes whose dot products with up differ by less are as near to it.
constexpr double kSameRise = 1e-6;

}  // namespace

void Inherit(const Item& parent, Item* item) {
  item->color_rgb = parent.color_rgb;
  item->paint = parent.paint;
  item->street_deg = parent.street_deg;
}

Item PlanarItem(const Scope& frame, Polygon polygon, const Item& parent) {
  const Box2 box = Bounds(polygon);
  const Vec2 size = box.high - box.low;
  Item item;
  item.type = ItemType::kPlanar;
  item.scope = frame;
  item.scope.origin = frame.ToWorld(Vec3(box.low.x, box.low.y, 0));
  item.scope.size = Vec3(size.x, size.y, 0);
  item.facing = frame.z;
  Inherit(parent, &item);
  if (Area(polygon) >= kFull * size.x * size.y) return item;
  for (Vec2& p : polygon.outer) p -= box.low;
  for (Ring& hole : polygon.holes) {
    for (Vec2& p : hole) p -= box.low;
  }
  item.polygon = std::make_shared<const Polygon>(std::move(polygon));
  return item;
}

Item VolumeItem(const Scope& frame, Mesh mesh, const Item& parent) {
  Vec3 low = mesh.points[0], high = low;
  for (const Vec3& p : mesh.points) {
    low = Vec3(std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z));
    high = Vec3(std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z));
  }
  Item item;
  item.type = ItemType::kVolume;
  item.scope = frame;
  item.scope.origin = frame.ToWorld(low);
  item.scope.size = high - low;
  item.facing = parent.facing;
  Inherit(parent, &item);
  item.hollow = parent.hollow;
  const Vec3& size = item.scope.size;
  const bool is_box = mesh.closed && Volume(mesh) >= kFull * size.x * size.y * size.z;
  if (is_box && mesh.paints.empty()) return item;
  for (Vec3& p : mesh.points) p -= low;
  for (Paint& paint : mesh.paints) {
    if (paint.map) paint.map = Rescaled(*paint.map, low, Vec3(1, 1, 1));
  }
  item.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return item;
}

Standing StandingOf(const Scope& scope) {
  const double x = std::abs(scope.x.y), y = std::abs(scope.y.y), z = std::abs(scope.z.y);
  const bool z_before_y = z > y + kSameRise;
  const bool x_is_up = x > std::max(y, z) + kSameRise;
  if (x_is_up) {
    const bool down = scope.x.y < 0;
    return {{1, 0, 2}, {!down, down, false}};
  }
  if (z_before_y) {
    const bool down = scope.z.y < 0;
    return {{0, 2, 1}, {false, down, !down}};
  }
  const bool down = scope.y.y < 0;
  return {{0, 1, 2}, {false, down, down}};
}

Scope StandUp(const Scope& scope, const Standing& standing) {
  Scope result = scope;
  Vec3* axes[3] = {&result.x, &result.y, &result.z};
  for (int i = 0; i < 3; ++i) {
    const int from = standing.source[i];
    *axes[i] = standing.flipped[i] ? -scope.axis(from) : scope.axis(from);
    result.size[i] = scope.size[from];
    if (standing.flipped[i]) result.origin += scope.axis(from) * scope.size[from];
  }
  return result;
}

Vec3 StandUp(const Vec3& local, const Vec3& size, const Standing& standing) {
  Vec3 result;
  for (int i = 0; i < 3; ++i) {
    const int from = standing.source[i];
    result[i] = standing.flipped[i] ? size[from] - local[from] : local[from];
  }
  return result;
}

}  // namespace parti::grammar
