// offset(distance) { inside: A | border: B }: a planar shape's outline moved, and the ring between.
#include <array>
#include <utility>

#include "grammar/item_make.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

using Kind = Selector::Kind;

/// The rectangle of a planar scope grown by distance on all sides; no area: it vanishes.
Polygon GrownRectangle(const Scope& scope, double distance) {
  const Vec2 low(-distance, -distance), high(scope.size.x + distance, scope.size.y + distance);
  if (high.x - low.x <= kLengthTolerance_m || high.y - low.y <= kLengthTolerance_m) return {};
  return {{low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)}, {}};
}

Result<std::vector<Polygon>> Moved(const Item& item, double distance) {
  if (item.polygon) return Offset(*item.polygon, -distance);
  std::vector<Polygon> pieces;
  Polygon grown = GrownRectangle(item.scope, distance);
  if (!grown.outer.empty()) pieces.push_back(std::move(grown));
  return pieces;
}

Result<std::vector<Product>> ApplyOffset(const Item& item, const Action& action) {
  const double distance = std::get<double>(action.arguments[0]);
  const int inside = SuccessorFor(action, Kind::kInside);
  const int border = SuccessorFor(action, Kind::kBorder);
  auto moved = Moved(item, distance);
  if (!moved) return Fail(moved);
  std::vector<Polygon> ring;
  if (border >= 0 && distance < 0) ring = Border(PolygonOf(item), *moved);
  if (border >= 0 && distance > 0 && !moved->empty()) {
    ring = Border(moved->front(), {PolygonOf(item)});
  }
  std::vector<Product> products;
  products.reserve(moved->size() + ring.size());
  for (Polygon& piece : *moved) {
    if (inside < 0) break;
    products.push_back({PlanarItem(item.scope, std::move(piece), item), inside});
  }
  for (Polygon& piece : ring) {
    products.push_back({PlanarItem(item.scope, std::move(piece), item), border});
  }
  return products;
}

constexpr std::array<Kind, 2> kSelectors = {Kind::kInside, Kind::kBorder};

const std::array<Parameter, 1> kParameters = {{{
    .name = "distance",
    .kind = ParameterKind::kLength,
    .low = -1e4,
    .high = 1e4,
    .default_value = -0.5,
    .doc = "by which the outline moves: negative inward, positive outward",
}}};

}  // namespace

constinit const Operation kOffset = {
    .name = "offset",
    .word = "Offset",
    .doc =
        "Moves the outline of a planar shape: inside is what it then encloses, border the ring "
        "between the old outline and the new.",
    .source = "Jesus 2018, 6.5.2; errata 22",
    .parameters = kParameters,
    .braces = Braces::kSelectors,
    .selectors = kSelectors,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kPlanar),
    .in_place = false,
    .apply = ApplyOffset,
};

}  // namespace parti::grammar
