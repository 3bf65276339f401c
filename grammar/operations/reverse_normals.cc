// reverseNormals(): a planar shape that looks the other way.
#include <algorithm>
#include <utility>

#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

void Flip(double width_m, Ring* ring) {
  for (Vec2& p : *ring) p.x = width_m - p.x;
  std::reverse(ring->begin(), ring->end());
  std::rotate(ring->begin(), ring->end() - 2, ring->end());  // the first edge stays the first
}

Result<std::vector<Product>> ApplyReverse(const Item& item, const Action&) {
  Item reversed = item;
  Scope& s = reversed.scope;
  s.origin += s.x * s.size.x;
  s.x = -s.x;
  s.z = -s.z;
  reversed.facing = -item.facing;
  if (item.polygon) {
    Polygon polygon = *item.polygon;
    Flip(s.size.x, &polygon.outer);
    for (Ring& hole : polygon.holes) Flip(s.size.x, &hole);
    reversed.polygon = std::make_shared<const Polygon>(std::move(polygon));
  }
  return std::vector<Product>{{std::move(reversed), -1}};
}

}  // namespace

constinit const Operation kReverseNormals = {
    .name = "reverseNormals",
    .word = "ReverseNormals",
    .doc =
        "Turns the front of a planar shape to the back: a bottom face looks up then, and extrudes "
        "upward.",
    .source = "CGA",
    .parameters = {},
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kPlanar),
    .in_place = true,
    .sampled = false,
    .apply = ApplyReverse,
};

}  // namespace parti::grammar
