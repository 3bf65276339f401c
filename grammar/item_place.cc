#include "grammar/item_place.h"

#include <utility>

#include "grammar/item_make.h"

namespace parti::grammar {
namespace {

constexpr double kFlat = 0.70710678118654752;  // elevation of 45 deg, as for :up (errata 10)

/// How a planar shape that faces up is named; nothing for other items.
std::optional<Standing> NamingOf(const Item& item) {
  const bool lies = item.type == ItemType::kPlanar && item.scope.z.y >= kFlat - 1e-9;
  if (!lies) return std::nullopt;
  return Standing{{0, 2, 1}, {false, false, true}};
}

Standing Inverse(const Standing& standing) {
  Standing inverse;
  for (int i = 0; i < 3; ++i) {
    inverse.source[standing.source[i]] = i;
    inverse.flipped[standing.source[i]] = standing.flipped[i];
  }
  return inverse;
}

Vec3 Turned(const Vec3& v, const Scope& from, const Scope& to) {
  return to.x * glm::dot(v, from.x) + to.y * glm::dot(v, from.y) + to.z * glm::dot(v, from.z);
}

/// What sizes are multiplied by; 1 where there was none.
Vec3 StretchOf(const Vec3& from, const Vec3& to) {
  Vec3 stretch(1, 1, 1);
  for (int i = 0; i < 3; ++i) {
    if (from[i] > 0) stretch[i] = to[i] / from[i];
  }
  return stretch;
}

void StretchPolygon(const Vec3& stretch, Item* item) {
  if (stretch.x == 0 || stretch.y == 0) {
    item->polygon = nullptr;
    return;
  }
  Polygon polygon = *item->polygon;
  const auto scale = [&](Ring* ring) {
    for (Vec2& p : *ring) p *= Vec2(stretch.x, stretch.y);
  };
  scale(&polygon.outer);
  for (Ring& hole : polygon.holes) scale(&hole);
  item->polygon = std::make_shared<const Polygon>(std::move(polygon));
}

/// A mesh that collapses is kept in its unit form, so that it can be drawn out again.
void StretchMesh(const Vec3& before, const Vec3& stretch, Item* item) {
  const bool collapses = stretch.x == 0 || stretch.y == 0 || stretch.z == 0;
  Vec3 scale = stretch;
  if (collapses) scale = StretchOf(before, Vec3(1, 1, 1));
  item->mesh = std::make_shared<const Mesh>(Rescaled(*item->mesh, Vec3(0, 0, 0), scale));
  item->mesh_is_unit = collapses;
}

void CarryTexture(const Scope& before, const Vec3& stretch, Item* item) {
  if (!item->paint || !item->paint->map) return;
  Paint paint = *item->paint;
  const Scope& now = item->scope;
  TextureMap map = LocalIn(*paint.map, before.origin, before.x, before.y, before.z);
  map = Rescaled(map, Vec3(0, 0, 0), stretch);
  paint.map = InFrame(map, now.origin, now.x, now.y, now.z);
  item->paint = std::make_shared<const Paint>(std::move(paint));
}

}  // namespace

Scope NamedScope(const Item& item) {
  const auto naming = NamingOf(item);
  return naming ? StandUp(item.scope, *naming) : item.scope;
}

Item Placed(const Item& item, const Scope& named) {
  Item placed = item;
  const auto naming = NamingOf(item);
  placed.scope = naming ? StandUp(named, Inverse(*naming)) : named;
  const Scope &before = item.scope, &now = placed.scope;
  if (!placed.anchor) {
    placed.anchor = before.ToWorld(before.size * 0.5);
  }
  if (placed.facing != Vec3(0, 0, 0)) placed.facing = Turned(item.facing, before, now);
  const Vec3 stretch = StretchOf(before.size, now.size);
  if (stretch != Vec3(1, 1, 1)) {
    if (placed.polygon) StretchPolygon(stretch, &placed);
    if (placed.mesh && !placed.mesh_is_unit) StretchMesh(before.size, stretch, &placed);
  }
  CarryTexture(before, stretch, &placed);
  return placed;
}

double Metres(const Size& size, double length_m) {
  return size.kind == Size::Kind::kRelative ? size.value * length_m : size.value;
}

}  // namespace parti::grammar
