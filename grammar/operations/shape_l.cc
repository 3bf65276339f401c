// shapeL(frontWidth, leftWidth) { shape: A | remainder: B }: wings along the front and the left.
#include <array>

#include "grammar/operations/edge_sides.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyShapeL(const Item& item, const Action& action) {
  const auto width = [&](size_t i) { return std::get<double>(action.arguments[i]); };
  return ShapeOf(item, action, {.front = width(0), .right = 0, .back = 0, .left = width(1)});
}

constexpr std::array<Selector::Kind, 2> kSelectors = {Selector::Kind::kShape,
                                                      Selector::Kind::kRemainder};

const std::array<Parameter, 2> kParameters = {
    WingParameter("frontWidth", "of the wing along the front"),
    WingParameter("leftWidth", "of the wing on the left")};

}  // namespace

constinit const Operation kShapeL = {
    .name = "shapeL",
    .word = "ShapeL",
    .doc = "Cuts a planar shape into an L along its front and left, and the remainder.",
    .source = "CGA",
    .parameters = kParameters,
    .braces = Braces::kSelectors,
    .selectors = kSelectors,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kPlanar),
    .in_place = false,
    .sampled = false,
    .apply = ApplyShapeL,
};

}  // namespace parti::grammar
