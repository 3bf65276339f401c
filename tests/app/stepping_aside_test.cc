#include "app/stepping_aside.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace parti::app {
namespace {

using testing::ElementsAre;
using testing::FloatNear;

constexpr double kReach_px = 100;

/// A bar at the left of the view and one at its right.
std::vector<PanelSheet> TwoBars() {
  return {{"Left", {0, 0}, {50, 1000}}, {"Right", {1550, 0}, {1600, 1000}}};
}

class SteppingAsideTest : public testing::Test {
 protected:
  SteppingAsideTest() { aside_.SetSheets(TwoBars()); }
  /// A line from the middle to here.
  void Draw(const Vec2& to, double now_s) {
    aside_.PenAt({800, 500}, kReach_px, 1, now_s);
    aside_.PenAt(to, kReach_px, 1, now_s);
  }
  std::vector<float> At(double now_s) {
    aside_.Step(now_s);
    return {aside_.opacities().begin(), aside_.opacities().end()};
  }
  SteppingAside aside_{SteppingAsideParams{0.12, 6, 6}};
};

TEST_F(SteppingAsideTest, ASheetThatTheLineRunsTowardsFadesAndTheOtherStays) {
  Draw({140, 500}, 1);
  EXPECT_THAT(At(1), ElementsAre(1, 1));
  EXPECT_THAT(At(1.061), ElementsAre(FloatNear(0.5f, 1e-6f), 1));
  EXPECT_THAT(At(1.121), ElementsAre(0, 1));
  EXPECT_FALSE(aside_.next_s());
}

TEST_F(SteppingAsideTest, WhatIsAsideStaysThereUntilThePenIsLiftedAndComesBack) {
  Draw({140, 500}, 1);
  aside_.PenAt({900, 500}, kReach_px, 1, 2);
  EXPECT_THAT(At(3), ElementsAre(0, 1));
  aside_.PenLifted(4);
  EXPECT_THAT(At(4.061), ElementsAre(FloatNear(0.5f, 1e-6f), 1));
  EXPECT_THAT(At(4.121), ElementsAre(1, 1));
}

TEST_F(SteppingAsideTest, APenThatIsLiftedHalfWayLetsItComeBackFromThere) {
  Draw({140, 500}, 1);
  aside_.Step(1.041);
  aside_.PenLifted(1.041);
  EXPECT_THAT(At(1.041), ElementsAre(FloatNear(4 / 6.0f, 1e-6f), 1)) << "no jump";
  EXPECT_THAT(At(1.082), ElementsAre(1, 1));
  EXPECT_FALSE(aside_.next_s());
}

TEST_F(SteppingAsideTest, ATapMovesNothing) {
  aside_.PenAt({60, 500}, kReach_px, 1, 1);
  aside_.PenAt({63, 502}, kReach_px, 1, 1.1);
  EXPECT_FALSE(aside_.next_s());
  EXPECT_THAT(At(2), ElementsAre(1, 1));
  aside_.PenAt({67, 503}, kReach_px, 1, 2.1);
  EXPECT_THAT(At(3), ElementsAre(0, 1)) << "a line does";
}

TEST_F(SteppingAsideTest, AtTwiceTheScaleTheSlackIsTwiceAsWide) {
  aside_.PenAt({60, 500}, kReach_px, 2, 1);
  aside_.PenAt({68, 500}, kReach_px, 2, 1);
  EXPECT_THAT(At(2), ElementsAre(1, 1));
  aside_.PenAt({73, 500}, kReach_px, 2, 2);
  EXPECT_THAT(At(3), ElementsAre(0, 1));
}

TEST_F(SteppingAsideTest, OnlyWhatIsThereTakesTaps) {
  EXPECT_TRUE(aside_.IsOverSheet({20, 500}));
  EXPECT_FALSE(aside_.IsOverSheet({60, 500}));
  Draw({140, 500}, 1);
  EXPECT_FALSE(aside_.IsOverSheet({20, 500})) << "from when it begins to go";
  EXPECT_TRUE(aside_.IsOverSheet({1560, 500}));
  aside_.PenLifted(2);
  EXPECT_TRUE(aside_.IsOverSheet({20, 500})) << "from when it begins to come back";
}

TEST_F(SteppingAsideTest, SheetsKeepTheirPlaceByNameAndNewOnesAreThere) {
  Draw({140, 500}, 1);
  aside_.Step(2);
  std::vector<PanelSheet> sheets = TwoBars();
  sheets.insert(sheets.begin(), {"Cards", {600, 400}, {800, 600}});
  aside_.SetSheets(sheets);
  EXPECT_THAT(At(2), ElementsAre(1, 0, 1));
  aside_.SetSheets({});
  EXPECT_TRUE(aside_.opacities().empty());
}

TEST_F(SteppingAsideTest, WithoutAFadeItIsGoneAtOnce) {
  aside_ = SteppingAside({.fade_s = 0});
  aside_.SetSheets(TwoBars());
  Draw({140, 500}, 1);
  EXPECT_THAT(At(1), ElementsAre(0, 1));
  EXPECT_FALSE(aside_.next_s());
}

RC_GTEST_PROP(SteppingAsideAtAnyTime, Properties1To4, ()) {
  const SteppingAsideParams params;
  SteppingAside aside(params);
  aside.SetSheets(TwoBars());
  double now_s = 0;
  std::optional<Vec2> begun;
  std::vector<bool> met(2, false);
  int turned = 0, changes = 0;
  for (int n = *rc::gen::inRange(1, 60); n > 0; --n) {
    now_s += *rc::gen::inRange(0, 80) * 1e-3;
    const Vec2 px(*rc::gen::inRange(0, 1600), *rc::gen::inRange(0, 1000));
    if (*rc::gen::inRange(0, 4)) {
      const bool draws = begun && glm::distance(*begun, px) > params.slack_px;
      if (!begun) begun = px;
      // A line, once it is one, stays one; here each place lies far enough from the first.
      if (!draws) continue;
      aside.PenAt(*begun, 0, 1, now_s);
      aside.PenAt(px, kReach_px, 1, now_s);
      for (const bool right : {false, true}) {
        const bool near = right ? px.x > 1550 - kReach_px : px.x < 50 + kReach_px;
        if (near && !met[right]) ++turned;
        met[right] = met[right] || near;
      }
    } else {
      aside.PenLifted(now_s);
      begun.reset();
      turned += static_cast<int>(std::count(met.begin(), met.end(), true));
      met.assign(2, false);
    }
    if (*rc::gen::arbitrary<bool>()) changes += aside.Step(now_s);
    for (const float opacity : aside.opacities()) RC_ASSERT(opacity >= 0 && opacity <= 1);
  }
  while (const auto next = aside.next_s()) {  // (4)
    now_s = std::max(now_s, *next);
    RC_ASSERT(aside.Step(now_s));
    ++changes;
  }
  RC_ASSERT(changes <= params.levels * turned);
  for (const size_t i : {0, 1}) RC_ASSERT(aside.opacities()[i] == (met[i] ? 0 : 1));  // (1) (2)
  aside.PenLifted(now_s);
  aside.Step(now_s + params.fade_s + 1e-9);
  for (const float opacity : aside.opacities()) RC_ASSERT(opacity == 1);  // (3)
}

}  // namespace
}  // namespace parti::app
