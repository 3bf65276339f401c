// split(axis) { sizes } and repeat: a shape cut into slabs along an axis of its scope.
#include <array>
#include <utility>

#include "grammar/item_make.h"
#include "grammar/operations/rows.h"
#include "grammar/operations/split_axis.h"
#include "grammar/operations/split_sizes.h"

namespace parti::grammar {
namespace {

/// The same item with its mesh in the scope's coordinates, where it has one.
Item WithOwnMesh(Item item) {
  if (!item.mesh_is_unit) return item;
  item.mesh = std::make_shared<const Mesh>(MeshOf(item));
  item.mesh_is_unit = false;
  return item;
}

/// The part of a rectangle or box: the same axes, a stretch of one of them.
Item Stretch(const Item& whole, int axis, const SplitPiece& piece) {
  Item part = whole;
  part.scope.origin += whole.scope.axis(axis) * piece.low;
  part.scope.size[axis] = piece.high - piece.low;
  if (part.type == ItemType::kPlanar) part.scope.size.z = 0;
  if (part.type == ItemType::kEdge) part.scope.size.y = part.scope.size.z = 0;
  part.anchor.reset();
  return part;
}

void AddParts(const Item& item, int axis, const SplitPiece& piece, std::vector<Product>* products) {
  if (item.polygon) {
    for (Polygon& part : Slab(*item.polygon, axis, piece.low, piece.high)) {
      products->push_back({PlanarItem(item.scope, std::move(part), item), piece.successor});
    }
  } else if (item.mesh) {
    Mesh part = Slab(*item.mesh, axis, piece.low, piece.high);
    if (part.faces.empty()) return;
    products->push_back({VolumeItem(item.scope, std::move(part), item), piece.successor});
  } else {
    products->push_back({Stretch(item, axis, piece), piece.successor});
  }
}

/// Along z what lies is cut from the back to the front, as CGA has it; along y from its first edge.
bool RunsToTheFront(const Item& item, const Action& action) {
  const bool is_z = std::get<Axis>(action.arguments[0]) == Axis::kZ;
  return is_z && item.type == ItemType::kPlanar && item.scope.z.y > 0;
}

void Reverse(double extent_m, std::vector<SplitPiece>* pieces) {
  for (SplitPiece& piece : *pieces) {
    const double low = extent_m - piece.high;
    piece.high = extent_m - piece.low;
    piece.low = low;
  }
}

using Resolve = Result<void> (*)(std::span<const Successor>, double, std::vector<SplitPiece>*);

Result<std::vector<Product>> Cut(const Item& item, const Action& action, Resolve resolve) {
  const auto axis_in = AxisIn(item, action);
  if (!axis_in) return Fail(axis_in);
  const int axis = *axis_in;
  std::vector<SplitPiece> pieces;
  pieces.reserve(action.successors.size());
  const auto resolved = resolve(action.successors, item.scope.size[axis], &pieces);
  if (!resolved) return Fail(resolved);
  if (RunsToTheFront(item, action)) Reverse(item.scope.size[axis], &pieces);
  const Item whole = WithOwnMesh(item);
  std::vector<Product> products;
  products.reserve(pieces.size());
  for (const SplitPiece& piece : pieces) {
    if (!piece.nil) AddParts(whole, axis, piece, &products);
  }
  return products;
}

Result<std::vector<Product>> ApplySplit(const Item& item, const Action& action) {
  return Cut(item, action, ResolveSplit);
}

Result<std::vector<Product>> ApplyRepeat(const Item& item, const Action& action) {
  return Cut(item, action, ResolveRepeat);
}

const std::array<Parameter, 1> kParameters = {{{
    .name = "axis",
    .kind = ParameterKind::kAxis,
    .default_value = Axis::kX,
    .doc = "of the shape's scope: x along its first edge, y up",
}}};

constexpr ItemTypes kDivisible = Types(ItemType::kVolume, ItemType::kPlanar, ItemType::kEdge);

}  // namespace

constinit const Operation kSplit = {
    .name = kSplitName,
    .word = "Split",
    .doc =
        "Cuts a shape into slabs along an axis: sizes in metres, '0.5 of the whole, ~1 a share "
        "of the rest; { … }* repeats.",
    .source = "Müller et al. 2006; Jesus 2018, 4.2",
    .parameters = kParameters,
    .braces = Braces::kSizes,
    .takes = kDivisible,
    .gives = kDivisible,
    .in_place = false,
    .apply = ApplySplit,
};

constinit const Operation kRepeat = {
    .name = kRepeatName,
    .word = "Repeat",
    .doc = "Cuts a shape into as many equal patterns as fit; written split(axis) { ~size: X }*.",
    .source = "Müller et al. 2006; Jesus 2018, 6.5.3; errata 7",
    .parameters = kParameters,
    .braces = Braces::kSizes,
    .takes = kDivisible,
    .gives = kDivisible,
    .in_place = false,
    .written = kSplitName,
    .apply = ApplyRepeat,
};

}  // namespace parti::grammar
