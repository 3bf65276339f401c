// innerRectangle(alignment) { shape: A | remainder: B }: the largest rectangle in a shape.
#include "grammar/inner_rectangle.h"

#include <array>
#include <string>
#include <utility>

#include "grammar/item_make.h"
#include "grammar/operations/rows.h"
#include "grammar/polygon_cut.h"

namespace parti::grammar {
namespace {

using Kind = Selector::Kind;
constexpr std::array<std::string_view, 2> kAlignments = {"scope", "edge"};

std::optional<Ring> LargestIn(const Polygon& polygon, std::string_view alignment) {
  if (alignment == kAlignments[1]) return InnerRectangleAlongEdges(polygon);
  return InnerRectangle(polygon, Vec2(1, 0));
}

Result<std::vector<Product>> ApplyInnerRectangle(const Item& item, const Action& action) {
  const Polygon polygon = PolygonOf(item);
  auto rectangle = LargestIn(polygon, std::get<std::string>(action.arguments[0]));
  if (!rectangle) {
    return Fail(ErrorCode::kDegenerateGeometry, "no rectangle fits into the shape",
                "give a larger shape");
  }
  const int shape = SuccessorFor(action, Kind::kShape);
  const int remainder = SuccessorFor(action, Kind::kRemainder);
  std::vector<Polygon> rest;
  const Polygon inner{std::move(*rectangle), {}};
  if (remainder >= 0) {
    auto left = Without(polygon, std::array{inner}, CutGrid(polygon));
    if (!left) return Fail(left);
    rest = std::move(*left);
  }
  std::vector<Product> products;
  if (shape >= 0) products.push_back({PlanarItem(item.scope, inner, item), shape});
  for (Polygon& piece : rest) {
    products.push_back({PlanarItem(item.scope, std::move(piece), item), remainder});
  }
  return products;
}

constexpr std::array<Kind, 2> kSelectors = {Kind::kShape, Kind::kRemainder};

const std::array<Parameter, 1> kParameters = {{{
    .name = "alignment",
    .kind = ParameterKind::kWord,
    .default_value = std::string(kAlignments[0]),
    .doc = "scope: along the shape's axes; edge: along one of its longer edges",
    .words = kAlignments,
}}};

}  // namespace

constinit const Operation kInnerRectangle = {
    .name = "innerRectangle",
    .word = "InnerRectangle",
    .doc = "Cuts the largest rectangle out of a planar shape.",
    .source = "CGA",
    .parameters = kParameters,
    .braces = Braces::kSelectors,
    .selectors = kSelectors,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kPlanar),
    .in_place = false,
    .sampled = false,
    .apply = ApplyInnerRectangle,
};

}  // namespace parti::grammar
