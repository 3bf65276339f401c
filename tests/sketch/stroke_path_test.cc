#include "sketch/stroke_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace parti::sketch {
namespace {

using testing::ElementsAre;

Stroke WithTimes(const std::vector<double>& times_s) {
  Stroke stroke;
  for (const double t : times_s) stroke.push_back({Vec2(stroke.size(), 0), t});
  return stroke;
}

TEST(SpreadTimes, DistinctTimesStayAsTheyAre) {
  EXPECT_THAT(SpreadTimes(WithTimes({0, 1, 4})), ElementsAre(0, 1, 4));
}

TEST(SpreadTimes, ABatchIsSpreadAroundItsTime) {
  EXPECT_THAT(SpreadTimes(WithTimes({0, 3, 3, 3, 6})), ElementsAre(0, 1.5, 3, 4.5, 6));
}

TEST(SpreadTimes, BatchesAtTheEndsKeepTheirTimeOutwards) {
  EXPECT_THAT(SpreadTimes(WithTimes({0, 0, 0, 4, 4, 4})),
              ElementsAre(0, 0, 4.0 / 3, 8.0 / 3, 4, 4));
}

TEST(SpreadTimes, OneTimeForAllStaysOne) {
  EXPECT_THAT(SpreadTimes(WithTimes({5, 5, 5})), ElementsAre(5, 5, 5));
  EXPECT_THAT(SpreadTimes({}), ElementsAre());
}

TEST(FilterStroke, PointsAreEvenlySpacedFromFirstSampleToLast) {
  const Stroke stroke = StrokeFrom("0,0 30,0 30,0 31,0 100,0");
  const auto path = FilterStroke(stroke, {});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->size(), 81);
  EXPECT_EQ(path->position.front(), Vec2(0, 0));
  EXPECT_EQ(path->position.back(), Vec2(100, 0));
  for (int i = 1; i < path->size(); ++i) {
    EXPECT_NEAR(path->position[i].x - path->position[i - 1].x, path->step, 1e-9);
  }
  EXPECT_TRUE(std::is_sorted(path->t_s.begin(), path->t_s.end()));
  EXPECT_TRUE(std::is_sorted(path->sample.begin(), path->sample.end()));
  EXPECT_EQ(path->sample.back(), 4);
}

TEST(FilterStroke, ALongScribbleGetsWiderStepsNotMorePoints) {
  Stroke stroke;
  for (int i = 0; i < 5000; ++i) stroke.push_back({Vec2(i % 2, 0.001 * i), 0.01 * i});
  const SegmentationParameters parameters;
  const auto path = FilterStroke(stroke, parameters);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->size(), parameters.most_steps + 1);
}

TEST(FilterStroke, ARestKeepsItsTimeAtItsPlace) {
  Stroke stroke = StrokeFrom("0,0 50,0 50,0 100,0");
  stroke[1].t_s = 1, stroke[2].t_s = 9, stroke[3].t_s = 10;
  const auto path = FilterStroke(stroke, {});
  ASSERT_TRUE(path);
  EXPECT_LE(path->t_s[40], 1 + 1e-9);
  EXPECT_GE(path->t_s[41], 9);
}

TEST(FilterStroke, ATapIsTooShort) {
  for (const char* tap : {"", "5,5", "5,5 5,5 5,5"}) {
    const auto path = FilterStroke(StrokeFrom(tap), {});
    ASSERT_FALSE(path) << tap;
    EXPECT_EQ(path.error().code, ErrorCode::kTooShort);
    EXPECT_FALSE(path.error().hint.empty());
  }
}

TEST(FilterStroke, WhatIsNotFiniteIsRefused) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Stroke place = StrokeFrom("0,0 10,0 20,0"), time = place;
    place[1].position.y = bad;
    time[2].t_s = bad;
    for (const Stroke& stroke : {place, time}) {
      const auto path = FilterStroke(stroke, {});
      ASSERT_FALSE(path);
      EXPECT_EQ(path.error().code, ErrorCode::kBadNumber);
    }
  }
}

}  // namespace
}  // namespace parti::sketch
