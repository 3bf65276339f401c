// offset: inside and border of planar shapes, CGA's sign.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

using Kind = Selector::Kind;
MATCHER_P(IsNear, v, "") { return glm::distance(arg, v) < 1e-9; }

TEST(Offset, InwardOfARectangleIsARectangleAndARing) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const auto parts = Apply(OffsetBy(-1), lot);
  ASSERT_TRUE(parts.has_value());
  ASSERT_EQ(parts->size(), 2u);
  const Item& inside = parts->at(0).item;
  EXPECT_EQ(inside.polygon, nullptr);
  EXPECT_THAT(inside.scope.size, IsNear(Vec3(8, 6, 0)));
  EXPECT_THAT(inside.scope.origin, IsNear(lot.scope.ToWorld(Vec3(1, 1, 0))));
  EXPECT_THAT(inside.facing, IsNear(lot.facing));
  const Item& border = parts->at(1).item;
  EXPECT_EQ(parts->at(1).successor, 1);
  EXPECT_EQ(border.polygon->holes.size(), 1u);
  EXPECT_NEAR(AreaOf(border), 80 - 48, 1e-12);
}

TEST(Offset, OutwardGrowsAndRingsTheOriginal) {
  for (const std::string outline : {"0,0 10,0 10,8 0,8", "0,0 10,0 10,8 5,8 5,4 0,4"}) {
    const Item lot = Lot(outline);
    const auto parts = Apply(OffsetBy(1), lot);
    ASSERT_TRUE(parts.has_value());
    ASSERT_EQ(parts->size(), 2u);
    EXPECT_NEAR(AreaOf(parts->at(0).item) - AreaOf(parts->at(1).item), AreaOf(lot), 1e-9);
    EXPECT_THAT(parts->at(0).item.scope.size, IsNear(Vec3(12, 10, 0)));
    EXPECT_THAT(parts->at(0).item.scope.origin, IsNear(lot.scope.ToWorld(Vec3(-1, -1, 0))));
  }
}

TEST(Offset, TooFarInwardIsAllBorder) {
  for (const std::string outline : {"0,0 10,0 10,8 0,8", "0,0 10,0 10,8 5,8 5,4 0,4"}) {
    const Item lot = Lot(outline);
    const auto parts = Apply(OffsetBy(-50), lot);
    ASSERT_TRUE(parts.has_value());
    ASSERT_EQ(parts->size(), 1u);
    EXPECT_EQ(parts->front().successor, 1);
    EXPECT_NEAR(AreaOf(parts->front().item), AreaOf(lot), 1e-12);
  }
}

TEST(Offset, ByZeroIsAllInside) {
  const auto parts = Apply(OffsetBy(0), Lot("0,0 10,0 10,8 5,8 5,4 0,4"));
  ASSERT_EQ(parts->size(), 1u);
  EXPECT_EQ(parts->front().successor, 0);
}

TEST(Offset, OnlyWhatIsAskedForIsMade) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const auto border = Apply(Make("offset", {-1.0}, {Selected(Kind::kBorder, "B")}), lot);
  ASSERT_EQ(border->size(), 1u);
  EXPECT_NE(border->front().item.polygon, nullptr);
  const auto nil = Apply(
      Make("offset", {-1.0}, {Selected(Kind::kInside, "NIL"), Selected(Kind::kBorder, "B")}), lot);
  ASSERT_EQ(nil->size(), 1u);
  EXPECT_EQ(nil->front().successor, 1);
}

TEST(Offset, EveryPieceOfWhatFallsApartIsInside) {
  const Item lot = Lot("0,0 8,0 8,3 12,3 12,0 20,0 20,8 12,8 12,5 8,5 8,8 0,8");
  const auto parts = Apply(OffsetBy(-1.5), lot);
  ASSERT_EQ(parts->size(), 3u);
  EXPECT_EQ(parts->at(0).successor, 0);
  EXPECT_EQ(parts->at(1).successor, 0);
  EXPECT_EQ(parts->at(0).item.polygon, nullptr);  // squares
  EXPECT_EQ(parts->at(2).item.polygon->holes.size(), 2u);
}

TEST(Offset, AThinRingCanBeOffsetAgain) {
  const auto parts = Apply(OffsetBy(-1), Lot("0,0 10,0 10,8 0,8"));
  const auto again = Apply(OffsetBy(-0.25), parts->at(1).item);
  ASSERT_TRUE(again.has_value());
  EXPECT_NEAR(AreaOf(again->at(0).item), 9.5 * 7.5 - 8.5 * 6.5, 1e-6);
  EXPECT_EQ(again->size(), 3u);
}

}  // namespace
}  // namespace parti::grammar::tests
