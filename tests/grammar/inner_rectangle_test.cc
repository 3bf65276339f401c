// innerRectangle: the largest rectangle that fits.
#include "grammar/inner_rectangle.h"

#include <gtest/gtest.h>

#include "grammar/action_text.h"
#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"

namespace parti::grammar::tests {
namespace {

TEST(InnerRectangle, OfAnLIsItsLargerWing) {
  const Polygon l{RingFrom("0,0 20,0 20,8 8,8 8,20 0,20"), {}};
  const auto found = InnerRectangle(l, Vec2(1, 0));
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(SignedArea(*found), 160, 1e-6);
}

TEST(InnerRectangle, OfATriangleIsHalfOfIt) {
  const Polygon triangle{RingFrom("0,0 20,0 7,12"), {}};
  EXPECT_NEAR(SignedArea(*InnerRectangle(triangle, Vec2(1, 0))), 60, 0.01);
}

TEST(InnerRectangle, KeepsClearOfHoles) {
  const auto polygon = PolygonFrom({RingFrom("0,0 20,0 20,20 0,20"), RingFrom("6,6 8,6 8,8 6,8")});
  EXPECT_NEAR(SignedArea(*InnerRectangle(*polygon, Vec2(1, 0))), 12 * 20, 1e-6);
}

TEST(InnerRectangle, AlongEdgesFindsTheTurnedOne) {
  const Polygon turned{RingFrom("0,0 16,12 10,20 -6,8"), {}};
  EXPECT_NEAR(SignedArea(*InnerRectangleAlongEdges(turned)), 200, 0.01);
  EXPECT_LT(SignedArea(*InnerRectangle(turned, Vec2(1, 0))), 150);
}

TEST(InnerRectangle, PropertyLiesInside) {
  for (uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const Polygon polygon = AnyPolygon(&random);
    const auto found = InnerRectangle(polygon, Vec2(0.6, 0.8));
    ASSERT_TRUE(found.has_value()) << seed;
    EXPECT_GT(SignedArea(*found), 0.02 * Area(polygon)) << seed;
    for (size_t i = 0; i < 4; ++i) {
      for (const double t : {0.0, 0.25, 0.5, 0.75}) {
        const Vec2 p = (*found)[i] + ((*found)[(i + 1) % 4] - (*found)[i]) * t;
        EXPECT_TRUE(Contains(polygon, p)) << seed;
      }
    }
  }
}

TEST(InnerRectangleRow, GivesTheRectangleAndTheRest) {
  const Item lot = Lot("0,0 20,0 20,8 8,8 8,20 0,20");
  const auto action = ParseAction("innerRectangle(scope) { shape: House | remainder: Garden }");
  const auto parts = Apply(*action, lot);
  ASSERT_TRUE(parts.has_value());
  ASSERT_EQ(parts->size(), 2u);
  EXPECT_EQ(parts->at(0).item.polygon, nullptr);
  EXPECT_NEAR(AreaOf(parts->at(0).item) + AreaOf(parts->at(1).item), AreaOf(lot), 1e-6);
}

}  // namespace
}  // namespace parti::grammar::tests
