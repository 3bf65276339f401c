// Arranging an element by others: their numbers in, the text of the rules out.
#include "app/placing/layer_arranging.h"

#include <gmock/gmock.h>

#include "app/placing/held_element.h"
#include "tests/app/placing_support.h"

namespace parti::app::tests {
namespace {

using grammar::InteractiveLayer;
using testing::ElementsAre;

std::vector<std::string> NamesOf(const std::vector<InteractiveLayer>& layers) {
  std::vector<std::string> names;
  for (const InteractiveLayer& layer : layers) names.push_back(layer.name);
  return names;
}

constexpr size_t kDoor = 0, kWindows = 1;

TEST(LayerArranging, ElementsFallInWithOthersOfTheirFaceAndWithTheFace) {
  const auto placed = PlacedBy(kPlacedRules);
  EXPECT_THAT(NamesOf(LayersBeside(*placed, kDoor)), ElementsAre("Windows", ""));
  const InteractiveLayer face = LayersBeside(*placed, kDoor).back();
  EXPECT_NEAR(face.width, 20, 1e-9);
  EXPECT_NEAR(face.height, 9, 1e-9);
}

TEST(LayerArranging, WhatSharesNumbersIsNotArrangedByEachOther) {
  std::string text = kPlacedRules;
  text.replace(text.find("segment(x, 2, 14"), 16, "segment(x, door_left, 14");
  EXPECT_THAT(NamesOf(LayersBeside(*PlacedBy(text), kDoor)), ElementsAre(""));
}

TEST(LayerArranging, EachArrangementIsThatOfTheGrammar) {
  const InteractiveLayer door{"Door", "D", 0, 4, 1.5, 2.5}, by{"Windows", "W", 4, 2, 14, 4};
  const auto arranged = [&](ElementCommand how) { return Arranged(door, how, by); };
  using C = ElementCommand;
  EXPECT_EQ(arranged(C::kSameSize), (InteractiveLayer{"Door", "D", 0, 4, 14, 4}));
  EXPECT_EQ(arranged(C::kAlignLeft).left, 2);
  EXPECT_EQ(arranged(C::kCenterAcross).left, 8.25);
  EXPECT_EQ(arranged(C::kAlignRight).left, 14.5);
  EXPECT_EQ(arranged(C::kAlignTop).bottom, 5.5);
  EXPECT_EQ(arranged(C::kCenterUp).bottom, 4.75);
  EXPECT_EQ(arranged(C::kAlignBottom).bottom, 4);
  EXPECT_EQ(arranged(C::kByNext), door);
}

TEST(LayerArranging, WhatIsInLineAlreadyChangesNothing) {
  const auto placed = PlacedBy(kPlacedRules);
  const InteractiveLayer door = placed->layers[kDoor].rules.layer;
  EXPECT_FALSE(ChangeBetween(door, door));
  EXPECT_THAT(ChangesOf(*placed, kDoor, LayersBeside(*placed, kDoor).back()),
              ElementsAre(true, true, true, true, true, true, false))
      << "it stands on the ground";
}

TEST(HeldElementTest, IsArrangedByTheOneHeldBeforeElseByTheUppermost) {
  const auto placed = PlacedBy(kPlacedRules);
  HeldElement held;
  EXPECT_EQ(held.In(*placed), std::nullopt);
  held.Hold(*placed, kWindows);
  EXPECT_EQ(held.ByIn(*placed).name, "Door");
  held.TakeNext(*placed);
  EXPECT_EQ(held.ByIn(*placed).name, "");
  held.Hold(*placed, kWindows);
  EXPECT_EQ(held.ByIn(*placed).name, "") << "what was chosen stays";
  held.Hold(*placed, kDoor);
  EXPECT_EQ(held.In(*placed), kDoor);
  EXPECT_EQ(held.ByIn(*placed).name, "Windows");
  held.LetGo();
  EXPECT_EQ(held.In(*placed), std::nullopt);
}

TEST(HeldElementTest, OutlivesAChangeOfItsNumbersButNotOfItsRules) {
  HeldElement held;
  held.Hold(*PlacedBy(kPlacedRules), kDoor);
  std::string moved = kPlacedRules;
  moved.replace(moved.find("= 4 "), 3, "= 9");
  EXPECT_EQ(held.In(*PlacedBy(moved)), kDoor);
  std::string plain = kPlacedRules;
  plain.replace(plain.find("segment(y, 0, 2.5, ~1)"), 22, "segment(y, 0, 2.5, 4)");
  const auto without = PlacedBy(plain);
  ASSERT_EQ(without->layers.size(), 1u);
  EXPECT_EQ(held.In(*without), std::nullopt);
}

}  // namespace
}  // namespace parti::app::tests
