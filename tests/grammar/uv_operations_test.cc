// tileUV, scaleUV, translateUV, rotateUV, normalizeUV, deleteUV, cleanupGeometry, reverseNormals,
// scatter.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "grammar/texture_extent.h"
#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

MATCHER_P(IsNear, v, "") { return glm::distance(arg, v) < 1e-9; }

Item After(const Action& action, const Item& item) { return Apply(action, item)->front().item; }
Item Wall() { return *PlanarFrom({{Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(9, 4, 0), Vec3(0, 4, 0)}}); }
Vec2 UvAt(const Item& item, const Vec3& p) { return item.paint->map->At(p); }
Size Floating(double value) { return {Size::Kind::kFloating, value}; }
Size Part(double value) { return {Size::Kind::kRelative, value}; }
Size Fixed(double value) { return {Size::Kind::kAbsolute, value}; }
Action Tile(Size width, Size height) { return Make("tileUV", {0.0, width, height}); }

TEST(TileUv, RepeatsTheImageAsLargeAsItIs) {
  const Item tiled = After(Tile(Fixed(3), Part(1)), Wall());
  EXPECT_THAT(UvAt(tiled, Vec3(9, 4, 0)), IsNear(Vec2(3, 1)));
  EXPECT_THAT(UvAt(tiled, Vec3(0, 0, 0)), IsNear(Vec2(0, 0)));
}

TEST(TileUv, FloatingSizesFitAWholeNumberOfTimes) {
  EXPECT_THAT(UvAt(After(Tile(Floating(2.1), Floating(50)), Wall()), Vec3(9, 4, 0)),
              IsNear(Vec2(4, 1)));
}

TEST(TileUv, ZeroLeavesACoordinateAsItIs) {
  const Item once = After(Make("scaleUV", {0.0, 2.0, 1.0}), Wall());
  EXPECT_THAT(UvAt(After(Tile(Fixed(0), Fixed(2)), once), Vec3(9, 4, 0)), IsNear(Vec2(18, 2)));
}

TEST(ChangeUv, ScalesMovesAndTurns) {
  const Item wall = After(Tile(Part(1), Part(1)), Wall());
  const Vec3 corner(9, 4, 0);
  EXPECT_THAT(UvAt(After(Make("scaleUV", {0.0, 2.0, -3.0}), wall), corner), IsNear(Vec2(2, -3)));
  EXPECT_THAT(UvAt(After(Make("translateUV", {0.0, 0.5, 1.0}), wall), corner),
              IsNear(Vec2(1.5, 2)));
  EXPECT_THAT(UvAt(After(Make("rotateUV", {0.0, 90.0}), wall), corner), IsNear(Vec2(-1, 1)));
}

TEST(ChangeUv, OtherTextureLayersChangeNothing) {
  const Item wall = After(Tile(Part(1), Part(1)), Wall());
  EXPECT_THAT(UvAt(After(Make("scaleUV", {2.0, 5.0, 5.0}), wall), Vec3(9, 4, 0)),
              IsNear(Vec2(1, 1)));
  EXPECT_TRUE(After(Make("deleteUV", {2.0}), wall).paint->map);
}

TEST(NormalizeUv, FitsTheImageOnce) {
  const Item wall = After(Make("translateUV", {0.0, 7.0, 7.0}), Wall());
  const Item fitted = After(Make("normalizeUV", {0.0, std::string("v")}), wall);
  EXPECT_THAT(UvAt(fitted, Vec3(9, 4, 0)), IsNear(Vec2(16, 1)));
  EXPECT_FALSE(After(Make("deleteUV", {0.0}), fitted).paint->map);
}

TEST(CleanupGeometry, TakesOffCornersThatSayNothing) {
  const Item lot = Lot("0,0 4,0.01 8,0 8,5 7.99,5.01 0,5");
  const auto corners = [](const Item& item) { return PolygonOf(item).outer.size(); };
  const auto cleaned = [&](std::string what) {
    return corners(After(Make("cleanupGeometry", {std::move(what), 0.1}), lot));
  };
  EXPECT_EQ(corners(lot), 6u);
  EXPECT_EQ(cleaned("vertices"), 5u);
  EXPECT_EQ(cleaned("edges"), 5u);
  EXPECT_EQ(cleaned("all"), 4u);
  EXPECT_EQ(cleaned("faces"), 6u);
}

TEST(CleanupGeometry, LeavesWhatItWouldDestroy) {
  const Item lot = Lot("0,0 0.3,0 0.3,0.2 0,0.3");
  EXPECT_NEAR(AreaOf(After(Make("cleanupGeometry", {std::string("all"), 9.0}), lot)), AreaOf(lot),
              1e-12);
}

TEST(ReverseNormals, LooksTheOtherWayFromTheSamePlace) {
  const Item lot = Lot("0,0 8,0 5,5");
  const Item reversed = After(Make("reverseNormals", {}), lot);
  EXPECT_THAT(reversed.facing, IsNear(Vec3(0, -1, 0)));
  EXPECT_THAT(reversed.scope.z, IsNear(Vec3(0, -1, 0)));
  EXPECT_GT(SignedArea(reversed.polygon->outer), 0);
  const Item back = After(Make("reverseNormals", {}), reversed);
  EXPECT_THAT(back.scope.origin, IsNear(lot.scope.origin));
  EXPECT_EQ(back.polygon->outer, lot.polygon->outer);
}

TEST(Scatter, PutsPointsOnTheSurface) {
  const Item lot = Lot("0,0 8,0 0,5");
  const auto points =
      Apply(Make("scatter", {std::string("surface"), 200.0, std::string("uniform")}), lot);
  ASSERT_TRUE(points.has_value());
  ASSERT_EQ(points->size(), 200u);
  for (const Product& point : *points) {
    EXPECT_EQ(point.item.type, ItemType::kPoint);
    const Vec3 local = lot.scope.ToLocal(point.item.scope.origin);
    EXPECT_TRUE(Contains(*lot.polygon, Vec2(local.x, local.y)));
  }
}

TEST(Scatter, SeedsAndBellsMatter) {
  const Item lot = Lot("0,0 20,0 20,20 0,20");
  const auto spread = [&](std::string distribution, double seed) {
    Action action = Make("scatter", {std::string("surface"), 500.0, std::move(distribution)});
    action.arguments.back() = seed;
    double sum = 0;
    const auto points = Apply(action, lot);
    for (const Product& p : *points) {
      sum += glm::distance(p.item.scope.origin, Vec3(10, 0, -10));
    }
    return sum / 500;
  };
  EXPECT_EQ(spread("uniform", 1), spread("uniform", 1));
  EXPECT_NE(spread("uniform", 1), spread("uniform", 2));
  EXPECT_LT(spread("gaussian", 1), 0.9 * spread("uniform", 1));
}

/// Mean place and spread of many points of a bell on a lot of 20 by 40, along its x.
std::array<double, 2> BellOf(std::string center, const Size& deviation) {
  const Item lot = Lot("0,0 20,0 20,40 0,40");
  const Action action = Make("scatter", {std::string("surface"), 4000.0, std::string("gaussian"),
                                         std::move(center), deviation, 3.0});
  const auto points = Apply(action, lot);
  EXPECT_TRUE(points.has_value());
  double sum = 0, squares = 0;
  for (const Product& p : *points) {
    const double x = p.item.scope.origin.x;
    sum += x / 4000;
    squares += x * x / 4000;
  }
  return {sum, std::sqrt(squares - sum * sum)};
}

TEST(Scatter, DeviatesByMetresOrByPartsOfTheScope) {
  const auto part = BellOf("center", {Size::Kind::kRelative, 0.1});
  EXPECT_NEAR(part[0], 10, 0.2);
  EXPECT_NEAR(part[1], 2, 0.1) << "a tenth of 20 m";
  EXPECT_NEAR(BellOf("center", {Size::Kind::kAbsolute, 1})[1], 1, 0.1);
  EXPECT_LT(BellOf("left", {Size::Kind::kRelative, 0.1})[0], 2) << "half of a bell, from x = 0";
  EXPECT_GT(BellOf("right", {Size::Kind::kRelative, 0.1})[0], 18);
  EXPECT_LT(BellOf("center", {Size::Kind::kRelative, 0.005})[1], 2) << "none far out";
}

}  // namespace
}  // namespace parti::grammar::tests
