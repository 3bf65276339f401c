#include "input/palm_arbitration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <utility>

#include "tests/support/events.h"

namespace parti::input {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using tests::Pen;
using Touch = TouchEvent::Kind;
using PenKind = PenEvent::Kind;

constexpr int kTablet = 0, kScreen = 1, kOtherScreen = 2;

TouchEvent Finger(Touch kind, double t_s, int finger = 0, int device = kScreen) {
  return {kind, device, finger, t_s, {100.0 + finger, 50}};
}

/// What of the events is left: everything that passed, with the cancels before it.
std::vector<InputEvent> Filtered(PalmArbitration* palms, const std::vector<InputEvent>& events) {
  std::vector<InputEvent> left;
  for (const InputEvent& event : events) {
    const Passage passage = palms->Feed(event);
    for (const TouchEvent& cancelled : passage.cancelled) left.emplace_back(cancelled);
    if (passage.passes) left.push_back(event);
  }
  return left;
}

std::vector<TouchEvent> TouchesLeft(const std::vector<InputEvent>& events) {
  PalmArbitration palms;
  std::vector<TouchEvent> touches;
  for (const InputEvent& event : Filtered(&palms, events)) {
    if (const auto* touch = std::get_if<TouchEvent>(&event)) touches.push_back(*touch);
  }
  return touches;
}

TEST(PalmArbitration, WithoutAPenFingersPass) {
  const std::vector<InputEvent> events{Finger(Touch::kDown, 1), Finger(Touch::kMotion, 1.1),
                                       Finger(Touch::kUp, 1.2)};
  PalmArbitration palms;
  EXPECT_EQ(Filtered(&palms, events), events);
}

TEST(PalmArbitration, PalmBeforePenIsCancelledWhenThePenComesNear) {
  const auto left = TouchesLeft({Finger(Touch::kDown, 1), Finger(Touch::kMotion, 1.1),
                                 Pen(PenKind::kProximityIn, 1.2, {10, 10}),
                                 Finger(Touch::kMotion, 1.3), Finger(Touch::kUp, 2)});
  EXPECT_THAT(left, ElementsAre(Finger(Touch::kDown, 1), Finger(Touch::kMotion, 1.1),
                                Finger(Touch::kCancel, 1.2)));
}

TEST(PalmArbitration, PalmUnderAPenNeverTouched) {
  EXPECT_THAT(TouchesLeft({Pen(PenKind::kProximityIn, 1, {10, 10}), Finger(Touch::kDown, 1.1),
                           Finger(Touch::kMotion, 1.2), Pen(PenKind::kProximityOut, 1.3, {10, 10}),
                           Finger(Touch::kMotion, 5), Finger(Touch::kUp, 6)}),
              IsEmpty());
}

TEST(PalmArbitration, FingersCountAgainAfterTheGraceTime) {
  const PalmArbitrationParams params;
  const double out_s = 2, late_s = out_s + params.grace_s + 0.001;
  EXPECT_THAT(TouchesLeft({Pen(PenKind::kProximityIn, 1, {10, 10}),
                           Pen(PenKind::kProximityOut, out_s, {10, 10}),
                           Finger(Touch::kDown, out_s + params.grace_s - 0.001, 0),
                           Finger(Touch::kDown, late_s, 1), Finger(Touch::kMotion, 3, 0)}),
              ElementsAre(Finger(Touch::kDown, late_s, 1)));
}

TEST(PalmArbitration, APenWhoseComingGotLostIsNearAllTheSame) {
  EXPECT_THAT(TouchesLeft({Pen(PenKind::kDown, 1, {10, 10}), Finger(Touch::kDown, 1.1)}),
              IsEmpty());
  EXPECT_THAT(TouchesLeft({Pen(PenKind::kMotion, 1, {10, 10}), Finger(Touch::kDown, 1.1)}),
              IsEmpty());
}

TEST(PalmArbitration, AMouseIsNoPen) {
  PenEvent moved = Pen(PenKind::kMotion, 1, {10, 10});
  moved.tool = PenTool::kMouse;
  EXPECT_THAT(TouchesLeft({moved, Finger(Touch::kDown, 1.1)}),
              ElementsAre(Finger(Touch::kDown, 1.1)));
}

TEST(PalmArbitration, APenThatIsUnpluggedGoesLikeOneThatIsLifted) {
  DeviceEvent gone = tests::PenAdded(kTablet, 2);
  gone.kind = DeviceEvent::Kind::kRemoved;
  const auto left = TouchesLeft({Pen(PenKind::kDown, 1, {10, 10}, kTablet), gone,
                                 Finger(Touch::kDown, 2.1, 0), Finger(Touch::kDown, 3, 1)});
  EXPECT_THAT(left, ElementsAre(Finger(Touch::kDown, 3, 1)));
}

TEST(PalmArbitration, OfTwoPensTheLastOneFreesTheFingers) {
  const auto left = TouchesLeft(
      {Pen(PenKind::kProximityIn, 1, {1, 1}, 0), Pen(PenKind::kProximityIn, 1, {1, 1}, 5),
       Pen(PenKind::kProximityOut, 2, {1, 1}, 0), Finger(Touch::kDown, 3, 0),
       Pen(PenKind::kProximityOut, 3, {1, 1}, 5), Finger(Touch::kDown, 3.5, 1)});
  EXPECT_THAT(left, ElementsAre(Finger(Touch::kDown, 3.5, 1)));
}

TEST(PalmArbitration, ATouchScreenThatIsUnpluggedCancelsItsOwnTouches) {
  DeviceEvent gone = tests::PenAdded(kScreen, 2);
  gone.kind = DeviceEvent::Kind::kRemoved;
  const auto left = TouchesLeft(
      {Finger(Touch::kDown, 1, 0, kScreen), Finger(Touch::kDown, 1, 0, kOtherScreen), gone,
       Finger(Touch::kMotion, 3, 0, kOtherScreen), Finger(Touch::kUp, 3, 0, kScreen)});
  EXPECT_THAT(left, ElementsAre(Finger(Touch::kDown, 1, 0, kScreen),
                                Finger(Touch::kDown, 1, 0, kOtherScreen),
                                Finger(Touch::kCancel, 2, 0, kScreen),
                                Finger(Touch::kMotion, 3, 0, kOtherScreen)));
}

TEST(PalmArbitration, APenLaidDownFreesTheFingersUntilItMoves) {
  const auto left =
      TouchesLeft({Pen(PenKind::kProximityIn, 1, {10, 10}), Pen(PenKind::kMotion, 2.9, {10.2, 10}),
                   Finger(Touch::kDown, 3.9, 0), Pen(PenKind::kMotion, 4.5, {10, 10.3}),
                   Finger(Touch::kDown, 4.6, 1), Pen(PenKind::kMotion, 5, {14, 10}),
                   Finger(Touch::kDown, 5.1, 2)});
  EXPECT_THAT(left, ElementsAre(Finger(Touch::kDown, 4.6, 1), Finger(Touch::kCancel, 5, 1)));
}

TEST(PalmArbitration, APenThatIsHeldDownStillIsNotLaidDown) {
  EXPECT_THAT(TouchesLeft({Pen(PenKind::kDown, 1, {10, 10}), Finger(Touch::kDown, 60)}), IsEmpty());
}

TEST(PalmArbitration, AFingerWhoseLiftGotLostIsCancelledBeforeItComesAgain) {
  EXPECT_THAT(
      TouchesLeft({Finger(Touch::kDown, 1), Finger(Touch::kDown, 2)}),
      ElementsAre(Finger(Touch::kDown, 1), Finger(Touch::kCancel, 2), Finger(Touch::kDown, 2)));
}

RC_GTEST_PROP(PalmArbitration, Property1_FingersComeDownBeforeTheyMoveOrLift, ()) {
  const Drawing drawing = *tests::ArbitraryDrawing();
  PalmArbitration palms;
  std::map<std::pair<int, int>, bool> down;
  for (const InputEvent& event : Filtered(&palms, drawing.events)) {
    const auto* touch = std::get_if<TouchEvent>(&event);
    if (!touch) continue;
    bool& is_down = down[{touch->device, touch->finger}];
    RC_ASSERT(is_down == (touch->kind != Touch::kDown));
    is_down = touch->kind == Touch::kDown || touch->kind == Touch::kMotion;
  }
}

RC_GTEST_PROP(PalmArbitration, Property2_NoFingerComesDownWhileAPenDraws, ()) {
  const Drawing drawing = *tests::ArbitraryDrawing();
  PalmArbitration palms;
  std::map<int, bool> draws;
  for (const InputEvent& event : Filtered(&palms, drawing.events)) {
    if (const auto* pen = std::get_if<PenEvent>(&event); pen && pen->tool != PenTool::kMouse) {
      if (pen->kind == PenKind::kDown) draws[pen->device] = true;
      if (pen->kind == PenKind::kUp || pen->kind == PenKind::kProximityIn ||
          pen->kind == PenKind::kProximityOut) {
        draws[pen->device] = false;
      }
    }
    const auto* touch = std::get_if<TouchEvent>(&event);
    if (!touch || touch->kind != Touch::kDown) continue;
    for (const auto& [device, drawing_now] : draws) RC_ASSERT(!drawing_now);
  }
}

}  // namespace
}  // namespace parti::input
