// t(tx, ty, tz): a shape moved along the axes of its scope.
#include <array>

#include "grammar/item_place.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyTranslate(const Item& item, const Action& action) {
  const Scope named = NamedScope(item);
  Scope moved = named;
  for (int i = 0; i < 3; ++i) {
    const auto& size = std::get<Size>(action.arguments[static_cast<size_t>(i)]);
    moved.origin += named.axis(i) * Metres(size, named.size[i]);
  }
  return std::vector<Product>{{Placed(item, moved), -1}};
}

constexpr Parameter Along(std::string_view name, std::string_view doc) {
  return {.name = name,
          .kind = ParameterKind::kSize,
          .low = -1e6,
          .high = 1e6,
          .default_value = Size{Size::Kind::kAbsolute, 0},
          .doc = doc};
}

const std::array<Parameter, 3> kParameters = {
    Along("tx", "along the scope's x; '0.5 is half its width"),
    Along("ty", "along its y; '0.5 is half its height"),
    Along("tz", "along its z; '0.5 is half its depth")};

}  // namespace

constinit const Operation kTranslate = {
    .name = "t",
    .word = "Translate",
    .doc = "Moves a shape along the axes of its scope.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kMovable,
    .gives = kMovable,
    .in_place = true,
    .apply = ApplyTranslate,
};

}  // namespace parti::grammar
