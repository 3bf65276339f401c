#include "grammar/operations/scene_item.h"

namespace parti::grammar {

Item SceneItem(const Item& predecessor, const Vec2& low, const Vec2& size) {
  Item item;
  item.type = ItemType::kShape2D;
  item.fixed_geometry = predecessor.fixed_geometry;
  item.layer = predecessor.layer;
  item.depth = predecessor.depth - 1;
  item.scope = predecessor.scope;
  item.scope.origin = predecessor.scope.ToWorld(Vec3(low.x, low.y, 0));
  item.scope.size = Vec3(size.x, size.y, 0);
  item.facing = predecessor.scope.z;
  item.color_rgb = predecessor.color_rgb;
  return item;
}

}  // namespace parti::grammar
