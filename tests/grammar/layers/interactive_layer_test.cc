// Jesus 2018, 8.2.1: values, and the same in the text of rules.
#include "grammar/layers/interactive_layer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grammar/layers/interactive_rules.h"
#include "grammar/rules/rule_text.h"

namespace parti::grammar::tests {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

const InteractiveLayer kWindows = {"Windows", "WindowsGrid", 1, 2, 8, 4};
const InteractiveLayer kDoor = {"Door", "DoorElement", 0, 4, 1.5, 2.5};

InteractiveLayer Moved(InteractiveLayer layer, double bottom, double left) {
  layer.bottom = bottom;
  layer.left = left;
  return layer;
}

TEST(InteractiveLayer, DragMovesAndKeepsTheSize) {
  EXPECT_EQ(Drag(kDoor, 0.5, -1), Moved(kDoor, 0.5, 3));  // (8.2)
}

TEST(InteractiveLayer, DragStopsAtTheBorder) { EXPECT_EQ(Drag(kDoor, -3, -9), Moved(kDoor, 0, 0)); }

TEST(InteractiveLayer, ResizeKeepsTheLowerLeftCorner) {
  const InteractiveLayer grown = Resize(kDoor, 1, -0.5);  // (8.3)
  EXPECT_EQ(grown.width, 2.5);
  EXPECT_EQ(grown.height, 2);
  EXPECT_EQ(grown.left, 4);
  EXPECT_EQ(Resize(kDoor, -9, -9).width, kLeastLayerSize_m);
}

TEST(InteractiveLayer, SameSizeTakesTheSizeOnly) {
  const InteractiveLayer same = SameSize(kWindows, kDoor);
  EXPECT_EQ(same.width, 8);
  EXPECT_EQ(same.height, 4);
  EXPECT_EQ(same.left, kDoor.left);
  EXPECT_EQ(same.payload, "DoorElement");
}

TEST(InteractiveLayer, AlignLaysEdgesOnOneLine) {
  EXPECT_EQ(Align(kWindows, kDoor, LayerEdge::kLeft), Moved(kDoor, 0, 2));
  EXPECT_EQ(Align(kWindows, kDoor, LayerEdge::kRight), Moved(kDoor, 0, 8.5));
  EXPECT_EQ(Align(kWindows, kDoor, LayerEdge::kBottom), Moved(kDoor, 1, 4));
  EXPECT_EQ(Align(kWindows, kDoor, LayerEdge::kTop), Moved(kDoor, 2.5, 4));
}

TEST(InteractiveLayer, CenterLaysMiddlesOnOneLine) {
  EXPECT_EQ(Center(kWindows, kDoor, LayerAxis::kHorizontal), Moved(kDoor, 0, 5.25));
  EXPECT_EQ(Center(kWindows, kDoor, LayerAxis::kVertical), Moved(kDoor, 1.75, 4));
}

/// Listing 8.3, expanded; the door's numbers are attributes.
constexpr const char* kFacade = R"(attr door_left = 4   // from the corner
attr door_width = 1.5
Facade --> layers("Windows", "Door") { Windows | Door }
Windows --> segment(x, 2, 8, ~1) { NIL | Tile | NIL }
Tile --> segment(y) { 1: NIL | 4: WindowsGrid | ~1: NIL }
Door --> segment(x, door_left, door_width, ~1) { NIL | DoorVTile | NIL }
DoorVTile --> segment(y, 0, 2.5, ~1) { ε | DoorElement | ε }
DoorElement --> extrude(-0.2)
WindowsGrid --> segment(x) { ~2: Window }*
Window --> extrude(-0.1)
)";

RuleSet Rules(std::string_view text) {
  auto rules = ParseRules(text, "facade.cga");
  EXPECT_TRUE(rules.has_value()) << (rules ? "" : FormatError(rules.error().front()));
  return rules ? std::move(*rules) : RuleSet();
}

TEST(InteractiveRules, AreFoundByTheirForm) {
  const auto found = InteractiveLayersOf(Rules(kFacade));
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].layer, kWindows);
  EXPECT_EQ(found[1].layer, kDoor);
}

TEST(InteractiveRules, NumbersChangeWhereTheyStand) {
  const RuleSet rules = Rules(kFacade);
  const auto found = InteractiveLayersOf(rules);
  ASSERT_THAT(found, SizeIs(2));
  const std::string text = TextWith(rules, found[1], Drag(kDoor, 0.1234567, -1));
  EXPECT_THAT(text, HasSubstr("attr door_left = 3   // from the corner"));
  EXPECT_THAT(text, HasSubstr("segment(y, 0.123, 2.5, ~1)"));
  EXPECT_EQ(InteractiveLayersOf(Rules(text)).at(0).layer, kWindows);
  EXPECT_EQ(InteractiveLayersOf(Rules(text)).at(1).layer, Moved(kDoor, 0.123, 3));
}

TEST(InteractiveRules, UnchangedLayersLeaveTheTextAsItIs) {
  const RuleSet rules = Rules(kFacade);
  for (const InteractiveRules& found : InteractiveLayersOf(rules)) {
    EXPECT_EQ(TextWith(rules, found, found.layer), kFacade);
  }
}

TEST(InteractiveRules, NumbersThatShareAnAttributeChangeItOnce) {
  const RuleSet rules = Rules(
      "attr side = 1.5\n"
      "A --> segment(x, 2, side, ~1) { NIL | T | NIL }\n"
      "T --> segment(y, 1, side, ~1) { NIL | P | NIL }\n");
  const auto found = InteractiveLayersOf(rules);
  ASSERT_THAT(found, SizeIs(1));
  const std::string text = TextWith(rules, found[0], Resize(found[0].layer, 10.125, 0.5));
  EXPECT_THAT(text, HasSubstr("attr side = 11.625\n"));
  EXPECT_THAT(TextWith(rules, found[0], Resize(found[0].layer, 0, 0.5)),
              HasSubstr("attr side = 2\n"));
}

TEST(InteractiveRules, WhatSharesANumberFollows) {
  const RuleSet rules = Rules(
      "attr sill = 1\nattr side = 1.5\n"
      "A --> segment(x, 2, side, ~1) { NIL | T | NIL }\n"
      "T --> segment(y, sill, side, ~1) { NIL | P | NIL }\n"
      "B --> segment(x, 5, 2, ~1) { NIL | S | NIL }\n"
      "S --> segment(y, sill, 2, ~1) { NIL | P | NIL }\n");
  const auto found = InteractiveLayersOf(rules);
  ASSERT_THAT(found, SizeIs(2));
  const InteractiveLayer moved = Resize(Drag(found[0].layer, 0.5, 1), 0, 0.25);
  for (const InteractiveRules& one : found) {
    const auto read = InteractiveLayersOf(Rules(TextWith(rules, found[0], moved)));
    EXPECT_EQ(Following(one, found[0], moved), read.at(&one - found.data()).layer);
  }
  EXPECT_EQ(Following(found[1], found[0], moved).bottom, 1.5);
  EXPECT_EQ(Following(found[1], found[0], found[0].layer), found[1].layer);
}

TEST(InteractiveRules, ReadBackFromTheirText) {
  const auto found = InteractiveLayersOf(Rules(RulesTextOf(kWindows) + RulesTextOf(kDoor)));
  ASSERT_THAT(found, SizeIs(2));
  EXPECT_EQ(found[0].layer, kWindows);
  EXPECT_EQ(found[1].layer, kDoor);
}

TEST(InteractiveRules, OtherFormsAreNone) {
  for (const char* rule : {
           "A --> segment(x, 2, 8, ~1) { NIL | T | B }",
           "A --> segment(x, 2, ~8, ~1) { NIL | T | NIL }",
           "A --> segment(x, 2, 8) { NIL | T }",
           "A --> split(x) { 2: NIL | 8: T | ~1: NIL }",
           "A --> segment(x, 2, 4 + 4, ~1) { NIL | T | NIL }",
           "A --> segment(x, 2, 8, ~1) { NIL | @T | NIL }",
           "A --> segment(x, 2, 8, ~1) { NIL | tag(\"t\") T | NIL }",
           "A --> segment(x, 2, 8, ~1) { NIL | Other | NIL }",
       }) {
    const std::string text =
        std::string(rule) + "\nT --> segment(y, 1, 2, ~1) { NIL | P | NIL }\nB --> NIL\n";
    EXPECT_THAT(InteractiveLayersOf(Rules(text)), SizeIs(0)) << rule;
  }
}

}  // namespace
}  // namespace parti::grammar::tests
