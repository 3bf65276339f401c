// A house whose front has elements that can be placed by hand, for tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "app/placing/placed_layers.h"

namespace parti::app::tests {

inline constexpr const char* kPlacedRules = R"(attr door_left = 4   // from the corner
Lot --> extrude(9) Mass
Mass --> comp(faces) { front: Facade | all: Wall }
Facade --> layers("windows", "door") { Windows | Door }
Windows --> segment(x, 2, 14, ~1) { NIL | Tile | NIL }
Tile --> segment(y, 4, 4, ~1) { NIL | Grid | NIL }
Grid --> segment(x) { ~2: Window }*
Window --> extrude(-0.1)
Door --> segment(x, door_left, 1.5, ~1) { NIL | DoorVTile | NIL }
DoorVTile --> segment(y, 0, 2.5, ~1) { NIL | DoorElement | NIL }
DoorElement --> extrude(-0.2)
)";

inline std::shared_ptr<const RuleSource> SourceOf(const std::string& text) {
  RuleSource source;
  source.files = {{"house.cga", text}};
  return std::make_shared<const RuleSource>(std::move(source));
}

/// On a lot of 20 by 14 m; the front is the longer side at z = 14, seen from the south.
inline Model HouseBy(std::shared_ptr<const RuleSource> source) {
  auto lots = ParseLots("rect(20,14)");
  EXPECT_TRUE(lots);
  auto ground = GroundOf(std::move(*lots), std::move(source));
  EXPECT_TRUE(ground) << (ground ? "" : FormatError(ground.error()));
  auto model = Derived(*ground, std::make_shared<const grammar::Trees>(), nullptr);
  EXPECT_TRUE(model) << (model ? "" : FormatError(model.error()));
  return std::move(*model);
}

/// The first visible shape below one of this symbol, or it.
inline ShapeRef VisibleIn(const Model& model, std::string_view symbol) {
  const grammar::ShapeTree& tree = model.derived[0]->tree;
  for (const ShapeRef& ref : VisibleShapes(model)) {
    for (auto at = ref.shape; at != grammar::kNoShape; at = tree.node(at).parent) {
      if (tree.Name(tree[at].symbol) == symbol) return ref;
    }
  }
  ADD_FAILURE() << "nothing is visible of " << symbol;
  return {};
}

/// The elements of the front of the house by these rules, its door in hand.
inline std::shared_ptr<const PlacedLayers> PlacedBy(const std::string& text) {
  const auto source = SourceOf(text);
  const Model model = HouseBy(source);
  return std::make_shared<const PlacedLayers>(
      PlacedLayersOf(model, {VisibleIn(model, "Facade")}, RulesInReach(*source)));
}

/// Some 20 m in front of the façade, askew.
inline Camera CameraBefore() {
  Camera camera;
  camera.eye = {6, 7, 36};
  camera.target = {9.5, 4, 14};
  return camera;
}

}  // namespace parti::app::tests
