// geometry.area(top), geometry.nFaces(side): what some of a shape's faces are like, chosen by
// comp's selectors.
#include <algorithm>

#include "grammar/front_edge.h"
#include "grammar/item_place.h"
#include "grammar/operations/comp_selectors.h"
#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

constexpr std::array<std::string_view, 23> kWords = {
    "all",          "front",       "back",        "left",         "right",       "top",
    "bottom",       "side",        "vertical",    "horizontal",   "aslant",      "nutant",
    "street.front", "street.back", "street.left", "street.right", "street.side", "world.south",
    "world.north",  "world.west",  "world.east",  "world.up",     "world.down"};

/// Those that the selector takes; none where there is no such selector.
std::vector<Item> Taken(const Item& item, const std::string& word) {
  std::vector<Item> taken;
  const auto kind = SelectorNamed(word);
  if (!kind || !HasSurface(item.type)) return taken;
  const bool street = word.starts_with("street");
  const CompFrame frame{NamedScope(item), street ? FrontOf(item) : Vec3(0, 0, 0)};
  for (Item& face : FacesOf(item)) {
    const Component component{face.facing, 0, item.type == ItemType::kPlanar, nullptr};
    if (Matches(Selector{*kind}, component, frame)) taken.push_back(std::move(face));
  }
  return taken;
}

Value AreaOfFaces(Values values, const Situation& situation) {
  double area_m2 = 0;
  for (const Item& face : Taken(*situation.item, TextOf(values[0]))) area_m2 += AreaOf(face);
  return area_m2;
}

Value CountOfFaces(Values values, const Situation& situation) {
  return static_cast<double>(Taken(*situation.item, TextOf(values[0])).size());
}

constexpr BuiltIn kRows[] = {
    {"geometry.area", First(kTexts, 1), kNumber,
     "the area of the faces that a selector of comp takes: geometry.area(top)", AreaOfFaces,
     kWords},
    {"geometry.nFaces", First(kTexts, 1), kNumber, "how many faces the selector takes",
     CountOfFaces, kWords},
};

}  // namespace

std::span<const BuiltIn> Faces() { return kRows; }

}  // namespace parti::grammar::built_ins
