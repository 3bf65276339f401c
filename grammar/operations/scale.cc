// s(sx, sy, sz): another size for a shape's scope, and for its geometry with it.
#include <algorithm>
#include <array>

#include "grammar/item_place.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyScale(const Item& item, const Action& action) {
  const Scope named = NamedScope(item);
  Scope resized = named;
  for (int i = 0; i < 3; ++i) {
    const auto& size = std::get<Size>(action.arguments[static_cast<size_t>(i)]);
    resized.size[i] = std::max(0.0, Metres(size, named.size[i]));
  }
  return std::vector<Product>{{Placed(item, resized), -1}};
}

constexpr Parameter Along(std::string_view name, std::string_view doc) {
  return {.name = name,
          .kind = ParameterKind::kSize,
          .low = 0,
          .high = 1e6,
          .default_value = Size{Size::Kind::kRelative, 1},
          .doc = doc};
}

const std::array<Parameter, 3> kParameters = {
    Along("sx", "its width: metres, or '0.5 of what it was; 0 leaves it to i()"),
    Along("sy", "its height, in the same ways"), Along("sz", "its depth, in the same ways")};

}  // namespace

constinit const Operation kScale = {
    .name = "s",
    .word = "Scale",
    .doc =
        "Gives a scope another size and stretches the geometry with it; what lies flat gets a "
        "depth for what is inserted next.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kMovable,
    .gives = kMovable,
    .in_place = true,
    .apply = ApplyScale,
};

}  // namespace parti::grammar
