#include "grammar/texture_extent.h"

namespace parti::grammar {

TextureMap TextureMapOf(const Item& item) {
  if (item.paint && item.paint->map) return *item.paint->map;
  TextureMap map;
  const Scope& s = item.scope;
  map.u = s.x;
  map.v = s.y;
  map.offset = -Vec2(glm::dot(s.x, s.origin), glm::dot(s.y, s.origin));
  return map;
}

Box2 TextureExtent(const Item& item, const TextureMap& map) {
  const std::vector<Segment3> edges = EdgesOf(item);
  if (edges.empty()) return {};
  Box2 box{map.At(edges[0].a), map.At(edges[0].a)};
  for (const Segment3& edge : edges) {
    for (const Vec3& corner : {edge.a, edge.b}) {
      const Vec2 uv = map.At(corner);
      box.low = glm::min(box.low, uv);
      box.high = glm::max(box.high, uv);
    }
  }
  return box;
}

}  // namespace parti::grammar
