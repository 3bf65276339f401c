#include "sketch/speed_curvature.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace parti::sketch {
namespace {

using testing::Each;
using testing::SizeIs;

const SegmentationParameters kDefaults;

StrokePath PathOf(const Stroke& stroke) { return *FilterStroke(stroke, kDefaults); }

// 100 right, 100 down at constant speed, but for a rest of `rest_s` at the corner.
Stroke CornerWithRest(double rest_s) {
  Stroke stroke;
  for (int i = 0; i <= 100; ++i) stroke.push_back({Vec2(i, 0), 0.01 * i});
  for (int i = 1; i <= 100; ++i) stroke.push_back({Vec2(100, i), 1 + rest_s + 0.01 * i});
  return stroke;
}

TEST(TurnAt, IsTheAngleBetweenTheChords) {
  const StrokePath path = PathOf(StrokeFrom("0,0 100,0 100,100"));
  const int corner = path.size() / 2;
  EXPECT_NEAR(TurnAt(path, corner, 4), kPi / 2, 1e-6);
  EXPECT_NEAR(TurnAt(path, corner / 2, 4), 0, 1e-9);
  EXPECT_EQ(TurnAt(path, 0, 4), 0) << "no chord reaches the first point";
  EXPECT_EQ(TurnAt(path, path.size() - 1, 4), 0);
}

TEST(TurnAt, ACuspIsAHalfTurnNotAStraightRun) {
  const StrokePath path = PathOf(StrokeFrom("0,0 100,0 0,0"));
  EXPECT_NEAR(TurnAt(path, path.size() / 2, 4), kPi, 1e-6);
}

TEST(Slowness, ConstantSpeedIsZeroEverywhere) {
  EXPECT_THAT(Slowness(PathOf(CornerWithRest(0)), kDefaults), Each(testing::DoubleNear(0, 1e-6)));
}

TEST(Slowness, ARestStandsOutAndIsBounded) {
  const StrokePath path = PathOf(CornerWithRest(60));
  const auto slowness = Slowness(path, kDefaults);
  EXPECT_EQ(*std::max_element(slowness.begin(), slowness.end()), kDefaults.most_slowness);
  EXPECT_NEAR(slowness[20], 0, 1e-6);
}

TEST(Slowness, AStrokeWithoutTimeSaysNothing) {
  Stroke stroke = CornerWithRest(0);
  for (auto& sample : stroke) sample.t_s = 7;
  EXPECT_THAT(Slowness(PathOf(stroke), kDefaults), Each(0.0));
}

TEST(Slowness, MostSamplesAtOneTimeDivideByNothing) {
  Stroke stroke = CornerWithRest(0);
  for (auto& sample : stroke) sample.t_s = 0;
  stroke.back().t_s = 1;
  EXPECT_THAT(Slowness(PathOf(stroke), kDefaults),
              Each(testing::AllOf(testing::Ge(kDefaults.least_slowness),
                                  testing::Le(kDefaults.most_slowness))));
}

TEST(EvidenceOf, ASlowCornerIsCheaperThanAFastOne) {
  const StrokePath slow = PathOf(CornerWithRest(0.5));
  Stroke hasty = CornerWithRest(0);
  for (auto& sample : hasty) {  // rests in the middle of its first line, so that its speed tells
    if (sample.position.x > 50) sample.t_s += 0.5;
  }
  const StrokePath fast = PathOf(hasty);
  const int corner = slow.size() / 2;
  EXPECT_LT(EvidenceOf(slow, kDefaults).price[corner], 0);
  EXPECT_GT(EvidenceOf(fast, kDefaults).price[corner],
            EvidenceOf(slow, kDefaults).price[corner] + 1);
}

TEST(EvidenceOf, WhereSpeedSaysNothingTheUsualSlownessIsAssumed) {
  const StrokePath path = PathOf(CornerWithRest(0));
  const CornerEvidence evidence = EvidenceOf(path, kDefaults);
  EXPECT_LT(evidence.price[path.size() / 2], 0);
  EXPECT_NEAR(evidence.price[path.size() / 4], kDefaults.corner_price, 1e-6);
}

TEST(CornerCandidates, TheCornerAndNothingElseOfACleanStroke) {
  const StrokePath path = PathOf(CornerWithRest(0.1));
  const auto candidates = CornerCandidates(path, EvidenceOf(path, kDefaults), kDefaults);
  ASSERT_THAT(candidates, SizeIs(1));
  EXPECT_NEAR(path.sample[candidates[0]], 100, 1);
}

TEST(CornerCandidates, HooksAtTheEndsAreNone) {
  const StrokePath path = PathOf(StrokeFrom("0,5 5,0 100,0 97,6"));
  EXPECT_THAT(CornerCandidates(path, EvidenceOf(path, kDefaults), kDefaults), SizeIs(0));
}

TEST(CornerCandidates, SparseSamplesGiveOneEach) {
  const StrokePath path = PathOf(StrokeFrom("0,0 100,0 100,80 0,80"));
  const auto candidates = CornerCandidates(path, EvidenceOf(path, kDefaults), kDefaults);
  ASSERT_THAT(candidates, SizeIs(2));
  EXPECT_EQ(path.sample[candidates[0]], 1);
  EXPECT_EQ(path.sample[candidates[1]], 2);
}

TEST(CornerCandidates, AZigzagKeepsTheBestInOrder) {
  Stroke stroke;
  for (int i = 0; i < 400; ++i) stroke.push_back({Vec2(i, 20 * (i % 2)), 0.1 * i});
  SegmentationParameters parameters;
  parameters.most_steps = 4096;
  parameters.most_candidates = 7;
  const auto path = FilterStroke(stroke, parameters);
  ASSERT_TRUE(path);
  const auto candidates = CornerCandidates(*path, EvidenceOf(*path, parameters), parameters);
  EXPECT_THAT(candidates, SizeIs(7));
  EXPECT_TRUE(std::is_sorted(candidates.begin(), candidates.end()));
}

}  // namespace
}  // namespace parti::sketch
