// mirror(xFlip, yFlip, zFlip): the geometry of a shape mirrored in its scope, which stays.
#include <algorithm>
#include <array>
#include <utility>

#include "grammar/item_place.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

/// Flips by the scope's own axes. NamedScope calls them otherwise where a planar shape faces up.
struct Flips {
  bool own[3];
};

Flips FlipsOf(const Item& item, const Action& action) {
  const Scope named = NamedScope(item);
  Flips flips{};
  for (int i = 0; i < 3; ++i) {
    if (!std::get<bool>(action.arguments[static_cast<size_t>(i)])) continue;
    for (int own = 0; own < 3; ++own) {
      flips.own[own] |= std::abs(glm::dot(named.axis(i), item.scope.axis(own))) > 0.5;
    }
  }
  return flips;
}

void MirrorPolygon(const Flips& flips, Item* item) {
  Polygon polygon = *item->polygon;
  const auto mirror = [&](Ring* ring) {
    for (Vec2& p : *ring) {
      if (flips.own[0]) p.x = item->scope.size.x - p.x;
      if (flips.own[1]) p.y = item->scope.size.y - p.y;
    }
    if (flips.own[0] == flips.own[1]) return;
    std::reverse(ring->begin(), ring->end());
    std::rotate(ring->begin(), ring->end() - 2, ring->end());  // the first edge stays the first
  };
  mirror(&polygon.outer);
  for (Ring& hole : polygon.holes) mirror(&hole);
  item->polygon = std::make_shared<const Polygon>(std::move(polygon));
}

void MirrorTexture(const Flips& flips, Item* item) {
  if (!item->paint || !item->paint->map) return;
  Paint paint = *item->paint;
  const Scope& s = item->scope;
  const TextureMap local = LocalIn(*paint.map, s.origin, s.x, s.y, s.z);
  paint.map = InFrame(Mirrored(local, s.size, flips.own), s.origin, s.x, s.y, s.z);
  item->paint = std::make_shared<const Paint>(std::move(paint));
}

Result<std::vector<Product>> ApplyMirror(const Item& item, const Action& action) {
  const Flips flips = FlipsOf(item, action);
  Item mirrored = item;
  if (item.polygon) MirrorPolygon(flips, &mirrored);
  if (item.mesh) {
    const Vec3 size = item.mesh_is_unit ? Vec3(1, 1, 1) : item.scope.size;
    mirrored.mesh = std::make_shared<const Mesh>(Mirrored(*item.mesh, size, flips.own));
  }
  MirrorTexture(flips, &mirrored);
  return std::vector<Product>{{std::move(mirrored), -1}};
}

Parameter Flip(std::string_view name, std::string_view doc) {
  return {.name = name, .kind = ParameterKind::kBool, .default_value = false, .doc = doc};
}

const std::array<Parameter, 3> kParameters = {Flip("xFlip", "whether left becomes right"),
                                              Flip("yFlip", "whether top becomes bottom"),
                                              Flip("zFlip", "whether front becomes back")};

}  // namespace

constinit const Operation kMirror = {
    .name = "mirror",
    .word = "Mirror",
    .doc = "Mirrors the geometry of a shape and its texture; the scope stays as it is.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kMovable,
    .gives = kMovable,
    .in_place = true,
    .apply = ApplyMirror,
};

}  // namespace parti::grammar
