#include "input/stroke_predictor.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "base/random.h"

namespace parti::input {
namespace {

constexpr double kStep_s = 0.005;

/// A predictor after n samples of a motion, 5 ms apart.
template <typename Motion>
StrokePredictor After(int n, const Motion& motion) {
  StrokePredictor predictor;
  for (int i = 0; i < n; ++i) predictor.Add(motion(i * kStep_s), i * kStep_s);
  return predictor;
}

TEST(StrokePredictor, KnowsNothingBeforeTheFirstSample) {
  EXPECT_EQ(StrokePredictor().Predict(0.01), std::nullopt);
  StrokePredictor predictor = After(9, [](double t) { return Vec2(t, 0); });
  predictor.Begin();
  EXPECT_EQ(predictor.Predict(0.01), std::nullopt);
}

TEST(StrokePredictor, APenThatJustCameDownStays) {
  EXPECT_EQ(After(1, [](double) { return Vec2(3, 4); }).Predict(0.016), Vec2(3, 4));
}

TEST(StrokePredictor, APenThatStandsStillStays) {
  EXPECT_EQ(After(40, [](double) { return Vec2(3, 4); }).Predict(0.016), Vec2(3, 4));
}

TEST(StrokePredictor, ASteadyHandIsFollowedMoreAndMore) {
  const auto motion = [](double t) { return Vec2(300 * t, 0); };
  double before_mm = 9;
  for (const int n : {3, 6, 12, 40}) {
    const double ahead_s = 0.016;
    const Vec2 truth = motion((n - 1) * kStep_s + ahead_s);
    const double error_mm = glm::distance(*After(n, motion).Predict(ahead_s), truth);
    EXPECT_LT(error_mm, before_mm);
    before_mm = error_mm;
  }
  EXPECT_LT(before_mm, 0.4);  // of 4.8 mm
}

TEST(StrokePredictor, AHandThatTremblesIsNotFollowed) {
  // 1 mm to and fro at every report: every prediction was wrong.
  const auto motion = [](double t) {
    return Vec2(std::lround(t / kStep_s) % 2 == 0 ? 0.0 : 1.0, 0);
  };
  const Vec2 predicted = *After(41, motion).Predict(0.008);
  EXPECT_LT(glm::distance(predicted, motion(40 * kStep_s)), 0.15);
}

TEST(StrokePredictor, AHandThatStopsIsBelievedAtOnce) {
  StrokePredictor predictor;
  double t_s = 0;
  for (int i = 0; i < 20; ++i) predictor.Add({2.0 * i, 0}, t_s += kStep_s);
  predictor.Add({38, 0}, t_s += kStep_s);
  EXPECT_EQ(*predictor.Predict(0.016), Vec2(38, 0));
}

TEST(StrokePredictor, InkNeverRunsBackwardsFromAHandThatBrakes) {
  StrokePredictor predictor;
  double x_mm = 0, t_s = 0;
  for (double step_mm = 2; step_mm > 0.01; step_mm *= 0.7) {
    for (int i = 0; i < 6; ++i) predictor.Add({x_mm += step_mm, 0}, t_s += kStep_s);
    for (const double ahead_s : {0.004, 0.016, 0.032}) {
      EXPECT_GE(predictor.Predict(ahead_s)->x, x_mm);
    }
  }
}

TEST(StrokePredictor, AfterARestItStartsAnew) {
  StrokePredictor predictor = After(20, [](double t) { return Vec2(400 * t, 0); });
  predictor.Add({38, 1}, 1.0);
  EXPECT_EQ(predictor.Predict(0.016), Vec2(38, 1));
}

TEST(StrokePredictor, NoFurtherThanItSays) {
  const StrokePredictor predictor = After(20, [](double t) { return Vec2(400 * t, 0); });
  EXPECT_EQ(predictor.Predict(1), predictor.Predict(StrokePredictor::kFarthest_s));
  EXPECT_EQ(predictor.Predict(-1), predictor.Predict(0));
}

TEST(StrokePredictor, SkipsWhatIsNoNumberAndTakesTheLaterOfTwoAtOneTime) {
  const auto motion = [](double t) { return Vec2(100 * t, 50 * t); };
  StrokePredictor predictor = After(20, motion);
  const auto before = predictor.Predict(0.01);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  predictor.Add({kNaN, 0}, 0.1);
  predictor.Add({0, 0}, kNaN);
  EXPECT_EQ(predictor.Predict(0.01), before);
  EXPECT_EQ(predictor.Predict(kNaN), motion(19 * kStep_s));
  predictor.Add({1, 2}, 19 * kStep_s);
  EXPECT_EQ(predictor.Predict(0), Vec2(1, 2));
}

/// A wandering hand with uneven times.
struct Hand {
  std::vector<Vec2> at_mm;
  std::vector<double> t_s;
};
Hand AnyHand(uint64_t seed) {
  Random random(seed);
  Hand hand{{{0, 0}}, {0}};
  Vec2 velocity(0, 0);
  for (int i = 0; i < 60; ++i) {
    const double step_s = random.Uniform(0.0005, 0.03);
    velocity += Vec2(random.Uniform(-200, 200), random.Uniform(-200, 200));
    velocity *= 0.8;
    hand.at_mm.push_back(hand.at_mm.back() + velocity * step_s);
    hand.t_s.push_back(hand.t_s.back() + step_s);
  }
  return hand;
}

RC_GTEST_PROP(StrokePredictor, Property1_MovesAndTurnsWithTheStroke, (uint64_t seed)) {
  const Hand hand = AnyHand(seed);
  const auto moved = [](const Vec2& p) { return Vec2(-p.y + 70, p.x - 30); };
  StrokePredictor plain, turned;
  for (size_t i = 0; i < hand.t_s.size(); ++i) {
    plain.Add(hand.at_mm[i], hand.t_s[i]);
    turned.Add(moved(hand.at_mm[i]), hand.t_s[i] + 5);
    RC_ASSERT(glm::distance(*turned.Predict(0.016), moved(*plain.Predict(0.016))) < 1e-6);
  }
}

RC_GTEST_PROP(StrokePredictor, Property2_IsFiniteAndAtOnceTheLastSample, (uint64_t seed)) {
  Random random(seed);
  StrokePredictor predictor;
  double t_s = 0;
  for (int i = 0; i < 100; ++i) {
    const double far = std::pow(10, random.Uniform(-9, 12));
    const Vec2 at(random.Uniform(-far, far), random.Uniform(-far, far));
    t_s += std::pow(10, random.Uniform(-9, 0));
    predictor.Add(at, t_s);
    RC_ASSERT(predictor.Predict(0) == at);
    RC_ASSERT(IsFinite(*predictor.Predict(0.016)));
  }
}

}  // namespace
}  // namespace parti::input
