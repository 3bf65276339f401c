// shapeO(frontWidth, rightWidth, backWidth, leftWidth) { shape: A | remainder: B }: wings along all
// sides.
#include <array>

#include "grammar/operations/edge_sides.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyShapeO(const Item& item, const Action& action) {
  const auto width = [&](size_t i) { return std::get<double>(action.arguments[i]); };
  return ShapeOf(item, action,
                 {.front = width(0), .right = width(1), .back = width(2), .left = width(3)});
}

constexpr std::array<Selector::Kind, 2> kSelectors = {Selector::Kind::kShape,
                                                      Selector::Kind::kRemainder};

const std::array<Parameter, 4> kParameters = {
    WingParameter("frontWidth", "of the wing along the front"),
    WingParameter("rightWidth", "of the wing on the right"),
    WingParameter("backWidth", "of the wing along the back"),
    WingParameter("leftWidth", "of the wing on the left")};

}  // namespace

constinit const Operation kShapeO = {
    .name = "shapeO",
    .word = "ShapeO",
    .doc = "Cuts a planar shape into a ring along all its sides, and the remainder.",
    .source = "CGA",
    .parameters = kParameters,
    .braces = Braces::kSelectors,
    .selectors = kSelectors,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kPlanar),
    .in_place = false,
    .sampled = false,
    .apply = ApplyShapeO,
};

}  // namespace parti::grammar
