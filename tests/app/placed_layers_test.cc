// Which elements of a face can be placed by hand, and where the model has them.
#include "app/placing/placed_layers.h"

#include <gmock/gmock.h>

#include "tests/app/placing_support.h"

namespace parti::app::tests {
namespace {

using testing::ElementsAre;

std::vector<std::string> NamesOf(const PlacedLayers& placed) {
  std::vector<std::string> names;
  for (const PlacedLayer& layer : placed.layers) names.push_back(layer.rules.layer.name);
  return names;
}

std::vector<std::string> NamesAt(const RuleSource& source, std::string_view symbol) {
  const Model model = HouseBy(std::make_shared<const RuleSource>(source));
  return NamesOf(PlacedLayersOf(model, {VisibleIn(model, symbol)}, RulesInReach(source)));
}

TEST(PlacedLayers, AnyPartOfTheFaceShowsAllOfItsElementsTheUppermostFirst) {
  const RuleSource source = *SourceOf(kPlacedRules);
  for (const char* part : {"Facade", "DoorElement", "Window"}) {
    EXPECT_THAT(NamesAt(source, part), ElementsAre("Door", "Windows")) << part;
  }
}

TEST(PlacedLayers, OtherFacesHaveNone) {
  EXPECT_THAT(NamesAt(*SourceOf(kPlacedRules), "Wall"), ElementsAre());
}

TEST(PlacedLayers, TheShapeSelectedLastCounts) {
  const auto source = SourceOf(kPlacedRules);
  const Model model = HouseBy(source);
  const ShapeRef wall = VisibleIn(model, "Wall"), door = VisibleIn(model, "DoorElement");
  const auto rules = RulesInReach(*source);
  EXPECT_THAT(NamesOf(PlacedLayersOf(model, {wall, door}, rules)), ElementsAre("Door", "Windows"));
  EXPECT_THAT(NamesOf(PlacedLayersOf(model, {door, wall}, rules)), ElementsAre());
  EXPECT_THAT(NamesOf(PlacedLayersOf(model, {}, rules)), ElementsAre());
  EXPECT_THAT(NamesOf(PlacedLayersOf(model, {door}, nullptr)), ElementsAre());
}

TEST(PlacedLayers, LieOnTheFaceAsTheModelHasIt) {
  const auto placed = PlacedBy(kPlacedRules);
  ASSERT_EQ(placed->layers.size(), 2u);
  const PlacedLayer& door = placed->layers[0];
  EXPECT_EQ(door.rules.layer.left, 4);
  const Vec3 corner = door.frame.ToWorld({door.rules.layer.left, door.rules.layer.bottom, 0});
  EXPECT_LT(glm::distance(corner, Vec3(4, 0, 14)), 1e-9);
  EXPECT_LT(glm::distance(placed->face.z, Vec3(0, 0, 1)), 1e-9);
}

TEST(PlacedLayers, LayersThatAreOffAreNotThere) {
  RuleSource source = *SourceOf(kPlacedRules);
  source.layers.off = {"Facade.door"};
  EXPECT_THAT(NamesAt(source, "Window"), ElementsAre("Windows"));
}

TEST(PlacedLayers, TheOrderIsThatOfTheEdits) {
  RuleSource source = *SourceOf(kPlacedRules);
  source.layers.order = {{"Facade", {"door", "windows"}}};
  EXPECT_THAT(NamesAt(source, "Window"), ElementsAre("Windows", "Door"));
}

TEST(PlacedLayers, NumbersThatTheSettingsFixAreOutOfReach) {
  RuleSource source = *SourceOf(kPlacedRules);
  source.settings.attributes = {{"door_left", "6"}};
  EXPECT_THAT(NamesAt(source, "Window"), ElementsAre("Windows"));
}

TEST(PlacedLayers, ElementsOnAFaceWithoutLayersLieInItsOwnFrame) {
  const std::string rules =
      "Lot --> extrude(9) Mass\n"
      "Mass --> comp(faces) { front: Door | all: Wall }\n"
      "Door --> segment(x, 4, 1.5, ~1) { NIL | T | NIL }\n"
      "T --> segment(y, 0, 2.5, ~1) { NIL | DoorElement | NIL }\n"
      "DoorElement --> extrude(-0.2)\n";
  EXPECT_THAT(NamesAt(*SourceOf(rules), "DoorElement"), ElementsAre("Door"));
}

TEST(PlacedLayers, TextsThatCantBeReadHaveNoRules) {
  EXPECT_EQ(RulesInReach(*SourceOf("Lot --> extrude(")), nullptr);
}

}  // namespace
}  // namespace parti::app::tests
