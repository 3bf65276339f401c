// shapeU(frontWidth, rightWidth, leftWidth) { shape: A | remainder: B }: wings along the front and
// both sides.
#include <array>

#include "grammar/operations/edge_sides.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyShapeU(const Item& item, const Action& action) {
  const auto width = [&](size_t i) { return std::get<double>(action.arguments[i]); };
  return ShapeOf(item, action, {.front = width(0), .right = width(1), .back = 0, .left = width(2)});
}

constexpr std::array<Selector::Kind, 2> kSelectors = {Selector::Kind::kShape,
                                                      Selector::Kind::kRemainder};

const std::array<Parameter, 3> kParameters = {
    WingParameter("frontWidth", "of the wing along the front"),
    WingParameter("rightWidth", "of the wing on the right"),
    WingParameter("leftWidth", "of the wing on the left")};

}  // namespace

constinit const Operation kShapeU = {
    .name = "shapeU",
    .word = "ShapeU",
    .doc = "Cuts a planar shape into a U along its front and sides, and the remainder.",
    .source = "CGA",
    .parameters = kParameters,
    .braces = Braces::kSelectors,
    .selectors = kSelectors,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kPlanar),
    .in_place = false,
    .sampled = false,
    .apply = ApplyShapeU,
};

}  // namespace parti::grammar
