// segment(axis) { sizes }: 2D shapes laid out along an axis, over what they are made from. Unlike
// split it cuts nothing: clipping and occlusion wait for the scene's normalisation.
#include <array>

#include "grammar/operations/rows.h"
#include "grammar/operations/scene_item.h"
#include "grammar/operations/split_axis.h"
#include "grammar/operations/split_sizes.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplySegment(const Item& item, const Action& action) {
  const auto axis = AxisIn(item, action);
  if (!axis) return Fail(axis);
  std::vector<SplitPiece> pieces;
  pieces.reserve(action.successors.size());
  const auto resolved = ResolveSplit(action.successors, item.scope.size[*axis], &pieces);
  if (!resolved) return Fail(resolved);
  std::vector<Product> products;
  products.reserve(pieces.size());
  for (const SplitPiece& piece : pieces) {
    if (piece.nil) continue;
    Vec2 low(0, 0), size(item.scope.size.x, item.scope.size.y);
    low[*axis] = piece.low;
    size[*axis] = piece.high - piece.low;
    products.push_back({SceneItem(item, low, size), piece.successor});
  }
  return products;
}

const std::array<Parameter, 1> kParameters = {{{
    .name = "axis",
    .kind = ParameterKind::kAxis,
    .default_value = Axis::kX,
    .doc = "of the shape's scope: x along its first edge, y up",
}}};

}  // namespace

constinit const Operation kSegment = {
    .name = kSegmentName,
    .word = "Segment",
    .doc =
        "Lays 2D shapes out along an axis without cutting anything: sizes as for split; { … }* "
        "repeats. Each lies over what it was made from, and is clipped to it.",
    .source = "Jesus 2018, (4.12), Listing 4.3; errata 2, 7",
    .parameters = kParameters,
    .braces = Braces::kSizes,
    .takes = kSceneItemTypes,
    .gives = Types(ItemType::kShape2D),
    .in_place = false,
    .sampled = false,
    .apply = ApplySegment,
};

}  // namespace parti::grammar
