#include "base/stroke.h"

#include <gtest/gtest.h>

namespace parti {
namespace {

TEST(Stroke, LengthFollowsThePathAndDiagonalTheBox) {
  const Stroke stroke = StrokeFrom("0,0 3,0 3,4 0,0");
  EXPECT_EQ(PathLength(stroke), 12);
  EXPECT_EQ(Diagonal(stroke), 5);
}

TEST(Stroke, AnEmptyStrokeAndATapHaveNoExtent) {
  EXPECT_EQ(PathLength({}), 0);
  EXPECT_EQ(Diagonal({}), 0);
  EXPECT_EQ(PathLength(StrokeFrom("5,5")), 0);
  EXPECT_EQ(Diagonal(StrokeFrom("5,5 5,5")), 0);
}

TEST(Stroke, TextIsSampledEveryTenMilliseconds) {
  const Stroke stroke = StrokeFrom("0,0 -1.5,2e1");
  ASSERT_EQ(stroke.size(), 2u);
  EXPECT_EQ(stroke[1], (StrokeSample{Vec2(-1.5, 20), 0.01}));
  EXPECT_TRUE(StrokeFrom("").empty());
}

TEST(StrokeDeathTest, AMisspeltFixtureIsABrokenInvariant) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH(StrokeFrom("0,0 1;1"), "broken invariant");
  EXPECT_DEATH(StrokeFrom("0,0 abc"), "broken invariant");
}

}  // namespace
}  // namespace parti
