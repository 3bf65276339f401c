#include "grammar/layers/normalise.h"

#include <unordered_map>
#include <utility>

#include "base/check.h"
#include "grammar/item_make.h"
#include "grammar/layers/merge_layers.h"

namespace parti::grammar {
namespace {

/// Areas below this part of the scene's are none (errata 5).
constexpr double kNegligiblePart = 1e-9;
constexpr std::string_view kBackgroundTag = "background";

Ring Moved(Ring ring, const Vec2& by) {
  for (Vec2& p : ring) p += by;
  return ring;
}

Polygon Moved(const Polygon& polygon, const Vec2& by) {
  Polygon moved{Moved(polygon.outer, by), {}};
  for (const Ring& hole : polygon.holes) moved.holes.push_back(Moved(hole, by));
  return moved;
}

/// The scene of one planar shape: its shapes' regions in the planar shape's coordinates.
class Scene {
 public:
  Scene(const ShapeTree& tree, ShapeIndex planar)
      : tree_(tree), planar_(planar), frame_(tree[planar].item.scope) {
    CHECK(tree[planar].item.type == ItemType::kPlanar, "a planar shape has a scene");
    background_ = OwnRegion(planar);
    const double extent = std::max(frame_.size.x, frame_.size.y);
    negligible_ = {SceneTolerance(extent), kNegligiblePart * AreaOf(background_)};
  }

  const Region& background() const { return background_; }
  const Negligible& negligible() const { return negligible_; }
  const Scope& frame() const { return frame_; }

  Vec2 OffsetOf(const Scope& scope) const {
    const Vec3 origin = frame_.ToLocal(scope.origin);
    return {origin.x, origin.y};
  }

  /// As it was laid out.
  Region OwnRegion(ShapeIndex shape) const {
    const Item& item = tree_[shape].item;
    const Vec2 low = shape == planar_ ? Vec2(0, 0) : OffsetOf(item.scope);
    if (item.polygon) return RegionOf({Moved(*item.polygon, low)});
    return {{low, low + Vec2(item.scope.size.x, item.scope.size.y)}, {}};
  }

  /// Clipped to the 2D shapes it lies below in the tree, and to the planar shape (4.17).
  Result<Region> ClippedRegion(ShapeIndex shape) {
    auto around = RegionAround(shape);
    if (!around) return Fail(around);
    return Shared(OwnRegion(shape), **around, negligible_);
  }

 private:
  /// What the shape is clipped to; kept, as siblings have it in common.
  Result<const Region*> RegionAround(ShapeIndex shape) {
    std::vector<ShapeIndex> unknown;
    const Region* around = &background_;
    for (ShapeIndex i = tree_.node(shape).parent; i != planar_; i = tree_.node(i).parent) {
      CHECK(i != kNoShape, "a shape of a scene lies below its planar shape in the tree");
      if (tree_[i].item.type != ItemType::kShape2D) continue;
      const auto known = clips_.find(i);
      if (known != clips_.end()) {
        around = &known->second;
        break;
      }
      unknown.push_back(i);
    }
    for (; !unknown.empty(); unknown.pop_back()) {
      auto clipped = Shared(OwnRegion(unknown.back()), *around, negligible_);
      if (!clipped) return Fail(clipped);
      around = &clips_.emplace(unknown.back(), std::move(*clipped)).first->second;
    }
    return around;
  }

  const ShapeTree& tree_;
  ShapeIndex planar_;
  Scope frame_;
  Region background_;
  Negligible negligible_;
  std::unordered_map<ShapeIndex, Region> clips_;
};

/// A piece of a 2D shape or layer as a planar item (4.3.2).
Item PieceItem(const Scope& frame, const Region& piece, const Item& shape) {
  if (!piece.polygons.empty()) return PlanarItem(frame, piece.polygons[0], shape);
  Item item;
  item.scope = frame;
  item.scope.origin = frame.ToWorld(Vec3(piece.bounds.low.x, piece.bounds.low.y, 0));
  const Vec2 size = piece.bounds.high - piece.bounds.low;
  item.scope.size = Vec3(size.x, size.y, 0);
  item.facing = frame.z;
  item.color_rgb = shape.color_rgb;
  return item;
}

/// The first piece in place of the shape, the others beside it.
std::vector<ShapeIndex> Place(std::vector<Item> pieces, ShapeIndex shape, ShapeTree* tree) {
  std::vector<ShapeIndex> placed;
  for (Item& piece : pieces) {
    if (placed.empty()) {
      tree->SetItem(shape, std::move(piece));
      placed.push_back(shape);
      continue;
    }
    const Shape& first = (*tree)[shape];
    const ShapeIndex parent = tree->node(shape).parent;
    const NameId symbol = first.symbol;
    const Operation* operation = first.operation;
    std::vector<NameId> tags = first.tags;
    placed.push_back(tree->Append(parent, std::move(piece), symbol, operation, std::move(tags)));
  }
  return placed;
}

/// What a shape becomes when this much of it is visible.
std::vector<Item> PiecesOf(const Region& visible, const Region& own, const Item& shape,
                           const Scope& frame) {
  std::vector<Item> pieces;
  if (visible == own) {
    pieces.push_back(shape);
    pieces[0].type = ItemType::kPlanar;
    pieces[0].fixed_geometry = true;
    pieces[0].layer = 0;
    pieces[0].depth = 0;
    return pieces;
  }
  for (Polygon& polygon : PolygonsOf(visible)) {
    pieces.push_back(PieceItem(frame, RegionOf({std::move(polygon)}), shape));
  }
  return pieces;
}

/// The planar shape in whose scene a shape lies.
ShapeIndex PlanarOf(const ShapeTree& tree, ShapeIndex shape) {
  ShapeIndex i = tree.node(shape).parent;
  while (i != kNoShape && tree[i].item.type != ItemType::kPlanar) i = tree.node(i).parent;
  CHECK(i != kNoShape, "a layer or 2D shape lies in the scene of a planar shape");
  return i;
}

}  // namespace

Result<NormalisedScene> Normalise(ShapeTree* tree, ShapeIndex planar,
                                  std::span<const ShapeIndex> shapes) {
  Scene scene(*tree, planar);
  std::vector<SceneShape> placed;
  placed.reserve(shapes.size());
  for (const ShapeIndex i : shapes) {
    const Item& item = (*tree)[i].item;
    CHECK(item.type == ItemType::kShape2D, "the shapes of a scene are 2D shapes");
    auto region = scene.ClippedRegion(i);
    if (!region) return Fail(region);
    placed.push_back({std::move(*region), item.fixed_geometry, item.layer, item.depth});
  }
  auto merged = MergeLayers(scene.background(), placed, scene.negligible());
  if (!merged) return Fail(merged);
  NormalisedScene normalised;
  normalised.pieces.reserve(shapes.size());
  // All regions are known before the first shape changes: what they are clipped to is read above.
  std::vector<std::vector<Item>> pieces(shapes.size());
  for (size_t k = 0; k < shapes.size(); ++k) {
    if (IsEmpty(merged->visible[k])) continue;
    pieces[k] = PiecesOf(merged->visible[k], scene.OwnRegion(shapes[k]), (*tree)[shapes[k]].item,
                         scene.frame());
  }
  for (size_t k = 0; k < shapes.size(); ++k) {
    normalised.pieces.push_back(Place(std::move(pieces[k]), shapes[k], tree));
  }
  for (Polygon& polygon : merged->uncovered) {
    normalised.uncovered.push_back({planar, std::move(polygon)});
  }
  return normalised;
}

Result<std::vector<ShapeIndex>> PlaceDeferred(ShapeTree* tree, ShapeIndex deferred,
                                              std::vector<Uncovered>* uncovered) {
  Scene scene(*tree, PlanarOf(*tree, deferred));
  const auto wanted = scene.ClippedRegion(deferred);
  if (!wanted) return Fail(wanted);
  std::vector<Polygon> taken;
  std::vector<Uncovered> left;
  for (Uncovered& free : *uncovered) {
    const Vec2 offset = scene.OffsetOf((*tree)[free.planar].item.scope);
    const Region region = RegionOf({Moved(free.polygon, offset)});
    const auto part = Shared(region, *wanted, scene.negligible());
    if (!part) return Fail(part);
    if (AreaOf(*part) < scene.negligible().area_m2) {
      left.push_back(std::move(free));
      continue;
    }
    const Region rest = Without(region, std::span(&*part, 1), scene.negligible());
    for (const Polygon& polygon : PolygonsOf(rest)) {
      left.push_back({free.planar, Moved(polygon, -offset)});
    }
    for (Polygon& polygon : PolygonsOf(*part)) taken.push_back(std::move(polygon));
  }
  std::vector<Item> pieces;
  for (Polygon& piece : Stitch(taken, {}, scene.negligible())) {
    pieces.push_back(
        PieceItem(scene.frame(), RegionOf({std::move(piece)}), (*tree)[deferred].item));
  }
  *uncovered = std::move(left);
  return Place(std::move(pieces), deferred, tree);
}

void AppendBackground(ShapeTree* tree, std::span<const Uncovered> uncovered) {
  const NameId tag = tree->Intern(kBackgroundTag);
  for (const Uncovered& free : uncovered) {
    const Item& planar = (*tree)[free.planar].item;
    Item item = PieceItem(planar.scope, RegionOf({free.polygon}), planar);
    const ShapeIndex first = tree->node(free.planar).first_child;
    const Operation* operation = first == kNoShape ? nullptr : (*tree)[first].operation;
    tree->Append(free.planar, std::move(item), kNoName, operation, {tag});
  }
}

}  // namespace parti::grammar
