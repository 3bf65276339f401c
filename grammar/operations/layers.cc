// layers("floors", "door") { Floors | Door }: the scene of a planar shape as a stack of layers.
// What lies in them is the business of segment and vectorial; merging them, of the normalisation.
#include <limits>

#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyLayers(const Item& item, const Action& action) {
  const size_t count = action.successors.size();
  if (count > std::numeric_limits<decltype(Item::layer)>::max()) {
    return Fail(ErrorCode::kLimitReached, "a scene has more than 65535 layers");
  }
  std::vector<Product> products;
  products.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    if (action.successors[i].symbol == kNil) continue;
    Item layer = item;
    layer.type = ItemType::kLayer;
    layer.polygon = nullptr;
    layer.layer = static_cast<decltype(Item::layer)>(i);
    layer.depth = 0;
    products.push_back({std::move(layer), static_cast<int>(i)});
  }
  return products;
}

}  // namespace

constinit const Operation kLayers = {
    .name = "layers",
    .word = "Layers",
    .doc =
        "Stacks named layers over a planar shape, the first one undermost; 2D shapes are laid out "
        "in them.",
    .source = "Jesus 2018, (4.11), Listing 4.2",
    .parameters = {},
    .braces = Braces::kNames,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kLayer),
    .in_place = false,
    .sampled = false,
    .apply = ApplyLayers,
};

}  // namespace parti::grammar
