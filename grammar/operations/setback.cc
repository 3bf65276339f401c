// setback(distance) { selector: A | remainder: B }: some edges moved inward, and what they sweep.
#include <array>
#include <utility>

#include "grammar/operations/edge_sides.h"

namespace parti::grammar {
namespace {

using Kind = Selector::Kind;

/// The successor that takes each edge: the first whose selector does, made or not; -1: none.
std::vector<int> TakersOf(const Item& item, const Action& action) {
  const std::vector<EdgeSide> sides = SidesOf(item);
  std::vector<int> takers(sides.size(), -1);
  for (size_t e = 0; e < sides.size(); ++e) {
    for (size_t s = 0; s < action.successors.size() && takers[e] < 0; ++s) {
      const Selector& selector = std::get<Selector>(action.successors[s].key);
      if (Selects(selector, sides[e], e)) takers[e] = static_cast<int>(s);
    }
  }
  return takers;
}

Result<std::vector<Product>> ApplySetback(const Item& item, const Action& action) {
  const double distance = std::get<double>(action.arguments[0]);
  std::vector<EdgeSetback> setbacks;
  for (const int taker : TakersOf(item, action)) {
    setbacks.push_back({taker < 0 ? 0 : distance, taker});
  }
  auto parts = Setback(PolygonOf(item), setbacks);
  if (!parts) return Fail(parts);
  std::vector<int> successors;
  for (size_t s = 0; s < action.successors.size(); ++s) {
    successors.push_back(action.successors[s].symbol == kNil ? -1 : static_cast<int>(s));
  }
  return ProductsOf(item, std::move(*parts), successors, SuccessorFor(action, Kind::kRemainder));
}

constexpr std::array<Kind, 15> kSelectors = {
    Kind::kAll,        Kind::kFront,      Kind::kBack,        Kind::kLeft,       Kind::kRight,
    Kind::kTop,        Kind::kBottom,     Kind::kSide,        Kind::kIndex,      Kind::kStreetFront,
    Kind::kStreetBack, Kind::kStreetLeft, Kind::kStreetRight, Kind::kStreetSide, Kind::kRemainder};

const std::array<Parameter, 1> kParameters = {{{
    .name = "distance",
    .kind = ParameterKind::kLength,
    .low = 0,
    .high = 1e4,
    .default_value = 3.0,
    .doc = "by which the selected edges move inward",
}}};

}  // namespace

constinit const Operation kSetback = {
    .name = "setback",
    .word = "Setback",
    .doc =
        "Moves edges of a planar shape inward: each selector gets what its edges sweep, and "
        "remainder what is left. The front is the street's side, else the longest.",
    .source = "CGA",
    .parameters = kParameters,
    .braces = Braces::kSelectors,
    .selectors = kSelectors,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kPlanar),
    .in_place = false,
    .sampled = false,
    .apply = ApplySetback,
};

}  // namespace parti::grammar
