// Rules with layers and 2D shapes: Listing 4.9's order as errata 1 and 9a have it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "grammar/rules/layer_edits.h"
#include "tests/grammar/rules/derived_by_rules.h"

namespace parti::grammar {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Area by symbol of what is visible: "background" for what has that tag.
double AreaOfAll(const ShapeTree& tree, std::string_view symbol) {
  double area = 0;
  for (const ShapeIndex i : tree.Leaves()) {
    const Shape& shape = tree[i];
    const bool is_background = !shape.tags.empty() && tree.Name(shape.tags[0]) == "background";
    const std::string_view name = is_background ? "background" : tree.Name(shape.symbol);
    if (name == symbol) area += AreaOf(shape.item);
  }
  return area;
}

TEST(SceneDerivation, WhatStaysFlatIsAPlaceholderAndTheRestIsCutOut) {
  const ShapeTree tree = ByRules(R"(
    Lot --> segment(x) { 5: Never | 5: Bed | ~1: NIL }
    Bed --> color("#00ff00") Flowers
  )");
  EXPECT_NEAR(AreaOfAll(tree, "Flowers"), 50, 1e-9);
  EXPECT_NEAR(AreaOfAll(tree, "background"), 150, 1e-9);
  EXPECT_EQ(tree.Find("Never") == kNoName, false) << "a shape, but none that is seen";
  EXPECT_NEAR(AreaOfAll(tree, "Never"), 0, 1e-9);
}

TEST(SceneDerivation, ALaterLayerLiesOverAnEarlierOne) {
  constexpr std::string_view kRules = R"(
    Lot --> layers("low", "high") { Low | High }
    Low --> segment(x) { 10: set_property("fixed_geometry", false) color("#ff0000") Left | ~1: NIL }
    High --> segment(y) { 5: color("#0000ff") Strip | ~1: NIL }
  )";
  const ShapeTree tree = ByRules(kRules);
  EXPECT_NEAR(AreaOfAll(tree, "Strip"), 100, 1e-9);
  EXPECT_NEAR(AreaOfAll(tree, "Left"), 50, 1e-9);
  EXPECT_NEAR(AreaOfAll(tree, "background"), 50, 1e-9);
}

TEST(SceneDerivation, OperationsThatNeedASurfaceRunOnWhatTheFlatOnesMade) {
  const ShapeTree tree = ByRules(R"(
    Lot --> segment(x) { 10: Arch | ~1: NIL }
    Arch --> vectorial("M0,0 L0,0.5 L0.5,1 L1,0.5 L1,0Z") extrude(2) Block
  )");
  EXPECT_THAT(Outline(tree), HasSubstr("0 Arch, 0/0 Block"));
  double volume = 0;
  for (const ShapeIndex i : tree.Leaves()) volume += VolumeOf(tree[i].item);
  EXPECT_NEAR(volume, 75 * 2, 1e-6) << "the arch alone, not its rectangle";
  EXPECT_NEAR(AreaOfAll(tree, "background"), 125, 1e-6);
}

TEST(SceneDerivation, ASuccessorInPlaceBecomesItsShape) {
  const ShapeTree tree = ByRules("Lot --> segment(x) { 10: extrude(3) Block | ~1: NIL }");
  EXPECT_EQ(Outline(tree), ". Lot, 0 Block, 1 -");
  EXPECT_EQ(tree[1].item.type, ItemType::kVolume);
}

TEST(SceneDerivation, PiecesOfOneShapeEachGoOn) {
  const ShapeTree tree = ByRules(R"(
    Lot --> layers("band", "gap") { Band | Gap }
    Band --> segment(y) { 4: set_property("fixed_geometry", false) Plank | ~1: NIL }
    Plank --> extrude(1) Wood
    Gap --> segment(x) { ~1: NIL | 2: color("#000000") Hole | ~1: NIL }
  )");
  size_t wood = 0;
  for (const std::string& symbol : Visible(tree)) wood += symbol == "Wood" ? 1 : 0;
  EXPECT_EQ(wood, 2u);
}

TEST(SceneDerivation, ADeferredLayerTakesWhatNothingCovers) {
  const ShapeTree tree = ByRules(R"(
    Lot --> layers("windows", "frames") { @Windows | Frames }
    Frames --> segment(x) { 1: color("#aaaaaa") Frame | ~1: NIL | 1: color("#aaaaaa") Frame }
    Windows --> segment(x) { ~1: NIL | 6: color("#0000ff") Window | ~1: NIL }
  )");
  EXPECT_NEAR(AreaOfAll(tree, "Frame"), 20, 1e-9);
  EXPECT_NEAR(AreaOfAll(tree, "Window"), 60, 1e-9);
  EXPECT_NEAR(AreaOfAll(tree, "background"), 120, 1e-9);
  const ShapeIndex window = tree.Leaves()[0];
  EXPECT_EQ(tree.Name(tree[window].symbol), "Window");
  EXPECT_NEAR(tree[window].item.scope.origin.x, 7, 1e-9) << "in the middle of what is left";
}

TEST(SceneDerivation, DeferredLayersFollowOneAnother) {
  const ShapeTree tree = ByRules(R"(
    Lot --> layers("a", "b", "c") { @First | @Second | Third }
    Third --> segment(x) { 10: color("#0000ff") Blue | ~1: NIL }
    First --> segment(y) { 5: color("#ff0000") Red | ~1: NIL }
    Second --> color("#00ff00") Green
  )");
  EXPECT_NEAR(AreaOfAll(tree, "Blue"), 100, 1e-9);
  EXPECT_NEAR(AreaOfAll(tree, "Red"), 50, 1e-9);
  EXPECT_NEAR(AreaOfAll(tree, "Green"), 50, 1e-9);
  EXPECT_NEAR(AreaOfAll(tree, "background"), 0, 1e-9);
}

TEST(SceneDerivation, ASceneInsideAPieceOfAScene) {
  const ShapeTree tree = ByRules(R"(
    Lot --> segment(x) { 10: color("#ffffff") Court | ~1: NIL }
    Court --> layers("bed") { Beds }
    Beds --> segment(y) { 2: color("#00ff00") Bed | ~1: NIL }
  )");
  EXPECT_NEAR(AreaOfAll(tree, "Bed"), 20, 1e-9);
  EXPECT_NEAR(AreaOfAll(tree, "background"), 180, 1e-9);
}

constexpr std::string_view kLayered = R"(
  Lot --> layers("paths", "beds") { Paths | Beds }
  Paths --> segment(x) { 4: color("#888888") Path | ~1: NIL }
  Beds --> segment(x) { ~1: NIL | 5: color("#00ff00") Bed }
  Pond --> segment(y) { 2: color("#0000ff") Water | ~1: NIL }
)";

ShapeTree Edited(const LayerEdits& edits) {
  const auto rules = WithLayers(RulesFrom(kLayered), edits);
  EXPECT_TRUE(rules) << FormatError(rules.error());
  const Item lot = LotOf(20, 10)[0].item;
  auto trees = DeriveRules(*rules, {}, {&lot, 1}, {});
  EXPECT_TRUE(trees) << FormatError(trees.error());
  return std::move(trees->front());
}

TEST(LayerEdits, LayersAreKnownByTheirCompositeNames) {
  EXPECT_THAT(LayerNames(RulesFrom(kLayered)), ElementsAre("Lot.paths", "Lot.beds"));
}

TEST(LayerEdits, SwitchedOffOrGivenAnotherRule) {
  LayerEdits edits;
  EXPECT_NEAR(AreaOfAll(Edited(edits), "Bed"), 50, 1e-9);
  edits.off = {"Lot.beds"};
  EXPECT_NEAR(AreaOfAll(Edited(edits), "Bed"), 0, 1e-9);
  EXPECT_NEAR(AreaOfAll(Edited(edits), "Path"), 40, 1e-9);
  edits.off.clear();
  edits.rules = {{"Lot.beds", "Pond"}};
  EXPECT_NEAR(AreaOfAll(Edited(edits), "Water"), 40, 1e-9);
}

TEST(LayerEdits, WithAllOffTheShapeIsAsItWas) {
  LayerEdits edits;
  edits.off = {"Lot.beds", "Lot.paths"};
  EXPECT_EQ(Outline(Edited(edits)), ". Lot");
}

TEST(LayerEdits, AnotherOrderChangesWhatLiesOnTop) {
  LayerEdits edits;
  edits.rules = {{"Lot.beds", "Pond"}};
  EXPECT_NEAR(AreaOfAll(Edited(edits), "Path"), 0, 1e-9) << "fixed, and covered in part";
  edits.order = {{"Lot", {"beds", "paths"}}};
  EXPECT_NEAR(AreaOfAll(Edited(edits), "Path"), 40, 1e-9);
}

TEST(LayerEdits, UnknownNamesAreRefused) {
  LayerEdits edits;
  edits.off = {"Lot.bed"};
  EXPECT_THAT(WithLayers(RulesFrom(kLayered), edits).error().hint, HasSubstr("Lot.beds"));
  edits.off.clear();
  edits.rules = {{"Lot.beds", "Pomd"}};
  EXPECT_THAT(WithLayers(RulesFrom(kLayered), edits).error().hint, HasSubstr("Pond"));
}

}  // namespace
}  // namespace parti::grammar
