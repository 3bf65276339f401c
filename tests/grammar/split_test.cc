// split and repeat: sizes along the axis, and the pieces they make.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

Item Strip(double length) {
  return LotFrom({{Vec2(0, 0), Vec2(length, 0), Vec2(length, 2), Vec2(0, 2)}}).value();
}

MATCHER(NearlyEqual, "") { return std::abs(std::get<0>(arg) - std::get<1>(arg)) < 1e-9; }

/// "A3 B2": symbols and sizes of what a split of a strip makes.
void ExpectPieces(const Action& action, double length, const std::string& symbols,
                  const std::vector<double>& sizes) {
  const Item strip = Strip(length);
  const auto products = Apply(action, strip);
  ASSERT_TRUE(products.has_value()) << products.error().message;
  std::string got;
  double end = 0;
  for (const Product& p : *products) {
    got += SuccessorAt(action, p.successor).symbol;
    EXPECT_EQ(p.item.polygon, nullptr);
    EXPECT_GE(strip.scope.ToLocal(p.item.scope.origin).x, end - 1e-9);
    end = strip.scope.ToLocal(p.item.scope.origin).x + p.item.scope.size.x;
  }
  EXPECT_EQ(got, symbols);
  EXPECT_THAT(SizesOf(*products, 0), Pointwise(NearlyEqual(), sizes));
}

TEST(Split, AbsoluteSizesKeepTheirsAndTheRestStaysEmpty) {
  ExpectPieces(Split(Axis::kX, {Metres(3, "A"), Metres(1, "B")}), 5, "AB", {3, 1});
}

TEST(Split, WhatDoesNotFitIsCutAndLaterOnesGetNothing) {
  const Action action = Split(
      Axis::kX, {Metres(2, "G"), Metres(1, "H"), Metres(1, "B"), Metres(2, "Y"), Metres(1, "X")});
  ExpectPieces(action, 5, "GHBY", {2, 1, 1, 1});
}

TEST(Split, SizesOfZeroOrLessMakeNothing) {
  const Action action = Split(Axis::kX, {Metres(1.5, "A"), Metres(-2, "N"), Metres(1.5, "B"),
                                         Metres(0, "Z"), Metres(1.5, "C")});
  ExpectPieces(action, 5, "ABC", {1.5, 1.5, 1.5});
}

TEST(Split, RelativeSizesAreSharesOfTheWhole) {
  ExpectPieces(Split(Axis::kX, {Share(0.25, "A"), Floating(1, "B")}), 8, "AB", {2, 6});
}

TEST(Split, FloatingSizesShareTheRestInProportion) {
  ExpectPieces(Split(Axis::kX, {Floating(1, "A"), Metres(4, "B"), Floating(2, "C")}), 10, "ABC",
               {2, 4, 4});
}

TEST(Split, FloatingSizesWithoutRoomMakeNothing) {
  ExpectPieces(Split(Axis::kX, {Metres(5, "A"), Floating(1, "B")}), 5, "A", {5});
}

TEST(Split, NilLeavesAGap) {
  ExpectPieces(Split(Axis::kX, {Metres(1, "A"), Metres(2, "NIL"), Floating(1, "B")}), 5, "AB",
               {1, 2});
}

TEST(Split, GroupFillsWhatItsNeighboursLeave) {
  const Action action = Split(Axis::kX, {Metres(4, "G"), Group({Floating(3, "F")})});
  ExpectPieces(action, 13.5, "GFFF", {4, 9.5 / 3, 9.5 / 3, 9.5 / 3});
}

TEST(Split, AbsoluteGroupLeavesTheRestToFloatingNeighbours) {
  const Action action =
      Split(Axis::kX, {Floating(1, "W"), Group({Metres(3, "T")}), Floating(1, "W")});
  ExpectPieces(action, 10, "WTTW", {2, 3, 3, 2});
}

TEST(Split, TwoGroupsShareEqually) {
  const Action action =
      Split(Axis::kX, {Group({Floating(3, "A")}), Metres(4, "B"), Group({Floating(3, "C")})});
  ExpectPieces(action, 16, "AABCC", {3, 3, 4, 3, 3});
}

TEST(Split, PatternKeepsAbsoluteParts) {
  const Action action =
      Split(Axis::kX, {Group({Floating(1, "L"), Metres(1.2, "W"), Floating(1, "R")})});
  ExpectPieces(action, 10, "LWRLWRLWR",
               {16.0 / 15, 1.2, 16.0 / 15, 16.0 / 15, 1.2, 16.0 / 15, 16.0 / 15, 1.2, 16.0 / 15});
}

TEST(Split, NestedGroupsRepeatWithinTheirPattern) {
  // 2 + 1 nominal: four patterns of 3 m, and in each the inner group fills 1 m with two of 0.5.
  const Action action =
      Split(Axis::kX, {Group({Metres(2, "A"), Group({Floating(0.5, "B"), Floating(0.5, "C")})})});
  ExpectPieces(action, 12, "ABCABCABCABC", {2, .5, .5, 2, .5, .5, 2, .5, .5, 2, .5, .5});
}

TEST(Repeat, StretchesToTheNearestWholeNumber) {
  ExpectPieces(Repeat(Axis::kX, {Floating(2.1, "A")}), 10, "AAAAA", {2, 2, 2, 2, 2});
  ExpectPieces(Repeat(Axis::kX, {Floating(7, "A")}), 3, "A", {3});
}

TEST(Repeat, AbsoluteSizesAreKeptAndTheLastIsCut) {
  ExpectPieces(Repeat(Axis::kX, {Metres(3, "A")}), 10, "AAAA", {3, 3, 3, 1});
  ExpectPieces(Repeat(Axis::kX, {Metres(2, "A"), Metres(1, "B")}), 7.5, "ABABA", {2, 1, 2, 1, 1.5});
}

TEST(Repeat, WholeCountsAreExact) {
  for (const double length : {60.0, 90.0, 0.3, 299.99999999999994, 2.4 * 7}) {
    for (const auto kind : {Size::Kind::kAbsolute, Size::Kind::kFloating}) {
      const double size = length == 0.3 ? 0.1 : length == 2.4 * 7 ? 2.4 : 3.0;
      const auto products = Apply(Repeat(Axis::kX, {Sized(kind, size, "A")}), Strip(length));
      ASSERT_TRUE(products.has_value());
      EXPECT_EQ(products->size(), std::lround(length / size)) << length;
      for (const double s : SizesOf(*products, 0)) EXPECT_NEAR(s, size, 1e-9);
    }
  }
}

TEST(Repeat, TooManyPiecesAreALimitNotAHang) {
  for (const auto kind : {Size::Kind::kAbsolute, Size::Kind::kFloating}) {
    const auto products = Apply(Repeat(Axis::kX, {Sized(kind, 1e-5, "A")}), Strip(1e4));
    ASSERT_FALSE(products.has_value());
    EXPECT_EQ(products.error().code, ErrorCode::kLimitReached);
  }
  // Nested groups, each within its limit.
  const Action nested =
      Split(Axis::kX, {Group({Metres(1, "A"), Group({Metres(1e-3, "B"), Metres(1e-3, "C")})})});
  EXPECT_TRUE(Apply(nested, Strip(1e4)).has_value());
  std::vector<Successor> many(1000, Floating(1, "A"));
  EXPECT_EQ(Apply(Repeat(Axis::kX, many), Strip(2e5)).error().code, ErrorCode::kLimitReached);
}

TEST(Repeat, PatternWithoutSizeIsRefused) {
  EXPECT_EQ(Apply(Repeat(Axis::kX, {Metres(0, "A")}), Strip(5)).error().code,
            ErrorCode::kBadArguments);
  EXPECT_EQ(Apply(Split(Axis::kX, {Group({Floating(-1, "A")})}), Strip(5)).error().code,
            ErrorCode::kBadArguments);
}

TEST(Split, YAndZNameTheDepthOfAFlatShapeAlike) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const auto by_y = Apply(Split(Axis::kY, {Metres(3, "A"), Floating(1, "B")}), lot);
  const auto by_z = Apply(Split(Axis::kZ, {Metres(3, "A"), Floating(1, "B")}), lot);
  ASSERT_TRUE(by_y && by_z);
  EXPECT_THAT(SizesOf(*by_y, 1), ElementsAre(DoubleNear(3, 1e-9), DoubleNear(5, 1e-9)));
  EXPECT_EQ(SizesOf(*by_y, 1), SizesOf(*by_z, 1));
}

TEST(Split, UprightShapeHasNoDepth) {
  const Item mass = Apply(Extrude(6), Lot("0,0 10,0 10,8 0,8"))->front().item;
  const Item facade = Apply(AllFaces(), mass)->at(2).item;
  EXPECT_EQ(Apply(Split(Axis::kZ, {Metres(3, "A")}), facade).error().code,
            ErrorCode::kBadArguments);
}

TEST(Split, AlongZALotIsCutFromTheBackToTheFront) {
  const Item lot = Lot("0,0 8,0 8,10 0,10");
  const auto along = [&](Axis axis) {
    return Apply(Split(axis, {Metres(2, "A"), Floating(1, "B")}), lot)->front().item.scope;
  };
  EXPECT_NEAR(along(Axis::kZ).origin.z, -8, 1e-9);
  EXPECT_NEAR(along(Axis::kY).origin.z, 0, 1e-9);
  EXPECT_NEAR(along(Axis::kZ).size.y, 2, 1e-9);
}

}  // namespace
}  // namespace parti::grammar::tests
