#include "input/gestures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace parti::input {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Kind = TouchEvent::Kind;

constexpr double kPxPerMm = 4;

ViewTouch Touch(Kind kind, double t_s, Vec2 position_px, int finger = 0) {
  return {{kind, 0, finger, t_s, position_px / kPxPerMm}, position_px, kPxPerMm};
}

/// "orbit begin", "tap 2" …
std::string NameOf(const Gesture& gesture) {
  static constexpr const char* kPhases[] = {" begin", " move", " end", " cancel"};
  const auto phase = [](DragPhase p) { return std::string(kPhases[static_cast<int>(p)]); };
  if (const auto* tap = std::get_if<TapGesture>(&gesture)) {
    return "tap " + std::to_string(tap->fingers);
  }
  if (const auto* orbit = std::get_if<OrbitGesture>(&gesture)) return "orbit" + phase(orbit->phase);
  if (const auto* pan = std::get_if<PanZoomGesture>(&gesture)) return "pan" + phase(pan->phase);
  return "draw" + phase(std::get<FingerDraw>(gesture).phase);
}

std::vector<Gesture> Made(Gestures* gestures, const std::vector<ViewTouch>& touches) {
  std::vector<Gesture> made;
  for (const ViewTouch& touch : touches) {
    for (const Gesture& gesture : gestures->Feed(touch)) made.push_back(gesture);
  }
  return made;
}

std::vector<std::string> NamesOf(const std::vector<ViewTouch>& touches, bool draws = false) {
  Gestures gestures;
  gestures.SetFingerDraws(draws);
  std::vector<std::string> names;
  for (const Gesture& gesture : Made(&gestures, touches)) names.push_back(NameOf(gesture));
  return names;
}

TEST(Gestures, OneFingerOrbitsFromWhereItIsCertain) {
  Gestures gestures;
  const auto made =
      Made(&gestures, {Touch(Kind::kDown, 0, {100, 100}), Touch(Kind::kMotion, 0.1, {105, 100}),
                       Touch(Kind::kMotion, 0.2, {120, 100}), Touch(Kind::kMotion, 0.3, {130, 110}),
                       Touch(Kind::kUp, 0.4, {130, 110})});
  const auto orbit = [](DragPhase phase, Vec2 to) {
    return Gesture(OrbitGesture{phase, {120, 100}, to});
  };
  EXPECT_EQ(made,
            (std::vector{orbit(DragPhase::kBegin, {120, 100}), orbit(DragPhase::kMove, {130, 110}),
                         orbit(DragPhase::kEnd, {130, 110})}));
}

TEST(Gestures, TwoFingersKeepWhatIsUnderThem) {
  Gestures gestures;
  const auto made =
      Made(&gestures,
           {Touch(Kind::kDown, 0, {100, 100}, 0), Touch(Kind::kDown, 0.02, {200, 100}, 1),
            Touch(Kind::kMotion, 0.1, {50, 100}, 0), Touch(Kind::kMotion, 0.1, {250, 120}, 1)});
  ASSERT_THAT(made, SizeIs(2));
  const auto& pan = std::get<PanZoomGesture>(made[1]);
  EXPECT_EQ(pan.from_px, Vec2(150, 100));
  EXPECT_EQ(pan.to_px, Vec2(150, 110));
  EXPECT_NEAR(pan.scale, std::hypot(200, 20) / 100, 1e-12);
}

TEST(Gestures, FingersOfAPinchThatLandOneAfterTheOtherDontOrbit) {
  EXPECT_THAT(
      NamesOf({Touch(Kind::kDown, 0, {100, 100}, 0), Touch(Kind::kMotion, 0.03, {130, 100}, 0),
               Touch(Kind::kDown, 0.05, {200, 100}, 1), Touch(Kind::kMotion, 0.06, {260, 100}, 1)}),
      ElementsAre("pan begin"));
}

TEST(Gestures, ASecondFingerThatComesSoonTakesTheOrbitBack) {
  EXPECT_THAT(
      NamesOf({Touch(Kind::kDown, 0, {100, 100}, 0), Touch(Kind::kMotion, 0.1, {130, 100}, 0),
               Touch(Kind::kDown, 0.2, {200, 100}, 1), Touch(Kind::kMotion, 0.3, {260, 100}, 1)}),
      ElementsAre("orbit begin", "orbit cancel", "pan begin"));
}

TEST(Gestures, ASecondFingerThatComesLateEndsTheOrbit) {
  EXPECT_THAT(
      NamesOf({Touch(Kind::kDown, 0, {100, 100}, 0), Touch(Kind::kMotion, 0.1, {130, 100}, 0),
               Touch(Kind::kDown, 0.9, {200, 100}, 1), Touch(Kind::kMotion, 1, {260, 100}, 1)}),
      ElementsAre("orbit begin", "orbit end", "pan begin"));
}

TEST(Gestures, AFingerThatStaysWhenTheOtherLiftsDoesNotOrbit) {
  const std::vector<ViewTouch> pinch{
      Touch(Kind::kDown, 0, {100, 100}, 0),     Touch(Kind::kDown, 0.02, {200, 100}, 1),
      Touch(Kind::kMotion, 0.1, {260, 100}, 1), Touch(Kind::kUp, 0.2, {260, 100}, 1),
      Touch(Kind::kMotion, 0.3, {150, 100}, 0), Touch(Kind::kMotion, 0.9, {250, 100}, 0)};
  EXPECT_THAT(NamesOf(pinch), ElementsAre("pan begin", "pan end"));
  std::vector<ViewTouch> again = pinch;
  again.push_back(Touch(Kind::kDown, 1, {350, 100}, 2));
  again.push_back(Touch(Kind::kMotion, 1.1, {390, 100}, 2));
  EXPECT_THAT(NamesOf(again), ElementsAre("pan begin", "pan end", "pan begin"));
}

TEST(Gestures, AThirdFingerDoesNotDisturbAPinch) {
  EXPECT_THAT(
      NamesOf({Touch(Kind::kDown, 0, {100, 100}, 0), Touch(Kind::kDown, 0.02, {200, 100}, 1),
               Touch(Kind::kMotion, 0.1, {260, 100}, 1), Touch(Kind::kDown, 0.2, {300, 300}, 2),
               Touch(Kind::kMotion, 0.3, {400, 300}, 2), Touch(Kind::kMotion, 0.4, {280, 100}, 1),
               Touch(Kind::kUp, 0.5, {400, 300}, 2), Touch(Kind::kUp, 0.6, {280, 100}, 1)}),
      ElementsAre("pan begin", "pan move", "pan end"));
}

std::vector<ViewTouch> TapOf(int fingers, double lasts_s, double moves_px) {
  std::vector<ViewTouch> touches;
  for (int i = 0; i < fingers; ++i)
    touches.push_back(Touch(Kind::kDown, 0.01 * i, {60.0 * i, 9}, i));
  touches.push_back(Touch(Kind::kMotion, 0.05, {moves_px, 9}, 0));
  for (int i = 0; i < fingers; ++i) touches.push_back(Touch(Kind::kUp, lasts_s, {60.0 * i, 9}, i));
  return touches;
}

TEST(Gestures, UpToThreeFingersTap) {
  EXPECT_THAT(NamesOf(TapOf(1, 0.1, 2)), ElementsAre("tap 1"));
  EXPECT_THAT(NamesOf(TapOf(2, 0.1, 2)), ElementsAre("tap 2"));
  EXPECT_THAT(NamesOf(TapOf(3, 0.1, 2)), ElementsAre("tap 3"));
  EXPECT_THAT(NamesOf(TapOf(4, 0.1, 2)), IsEmpty());
}

TEST(Gestures, ATapIsWhereItsFingersCameDown) {
  Gestures gestures;
  EXPECT_THAT(Made(&gestures, TapOf(2, 0.1, 2)), ElementsAre(Gesture(TapGesture{2, {30, 9}})));
}

TEST(Gestures, SlowOrMovingFingersDontTap) {
  const GestureParams params;
  EXPECT_THAT(NamesOf(TapOf(2, params.tap_s - 0.001, 0)), ElementsAre("tap 2"));
  EXPECT_THAT(NamesOf(TapOf(2, params.tap_s + 0.001, 0)), IsEmpty());
  EXPECT_THAT(NamesOf(TapOf(3, 0.1, params.slop_mm * kPxPerMm + 0.1)), IsEmpty());
  EXPECT_THAT(NamesOf(TapOf(3, 0.1, params.slop_mm * kPxPerMm - 0.1)), ElementsAre("tap 3"));
}

TEST(Gestures, TapsFromOneHandAfterTheOtherAreTapsOfOne) {
  EXPECT_THAT(NamesOf({Touch(Kind::kDown, 0, {1, 1}, 0), Touch(Kind::kUp, 0.05, {1, 1}, 0),
                       Touch(Kind::kDown, 0.1, {9, 1}, 1), Touch(Kind::kUp, 0.15, {9, 1}, 1)}),
              ElementsAre("tap 1", "tap 1"));
}

TEST(Gestures, FingersThatTakeTurnsDontTap) {
  EXPECT_THAT(NamesOf({Touch(Kind::kDown, 0, {1, 1}, 0), Touch(Kind::kDown, 0.02, {9, 1}, 1),
                       Touch(Kind::kUp, 0.05, {1, 1}, 0), Touch(Kind::kDown, 0.1, {19, 1}, 2),
                       Touch(Kind::kUp, 0.15, {9, 1}, 1), Touch(Kind::kUp, 0.15, {19, 1}, 2)}),
              IsEmpty());
}

TEST(Gestures, APalmThatIsFoundOutTakesBackWhatItDid) {
  EXPECT_THAT(NamesOf({Touch(Kind::kDown, 0, {100, 100}), Touch(Kind::kMotion, 0.1, {150, 100}),
                       Touch(Kind::kCancel, 0.2, {150, 100})}),
              ElementsAre("orbit begin", "orbit cancel"));
  EXPECT_THAT(NamesOf({Touch(Kind::kDown, 0, {100, 100}), Touch(Kind::kCancel, 0.1, {100, 100})}),
              IsEmpty());
  EXPECT_THAT(
      NamesOf({Touch(Kind::kDown, 0, {100, 100}, 0), Touch(Kind::kDown, 0, {200, 100}, 1),
               Touch(Kind::kMotion, 0.1, {150, 100}, 0), Touch(Kind::kCancel, 0.2, {150, 100}, 1)}),
      ElementsAre("pan begin", "pan cancel"));
}

TEST(Gestures, ADrawingFingerIsAPenFromItsFirstTouchOn) {
  Gestures gestures;
  gestures.SetFingerDraws(true);
  const auto made =
      Made(&gestures, {Touch(Kind::kDown, 0, {100, 100}), Touch(Kind::kMotion, 0.02, {108, 100}),
                       Touch(Kind::kMotion, 0.04, {116, 100}),
                       Touch(Kind::kMotion, 0.08, {140, 100}), Touch(Kind::kUp, 0.1, {140, 100})});
  ASSERT_THAT(made, SizeIs(5));
  const std::vector<double> x_mm{25, 27, 29, 35, 35}, t_s{0, 0.02, 0.04, 0.08, 0.1};
  for (size_t i = 0; i < made.size(); ++i) {
    const auto& [phase, event] = std::get<FingerDraw>(made[i]);
    EXPECT_EQ(event.position_mm, Vec2(x_mm[i], 25));
    EXPECT_EQ(event.t_s, t_s[i]);
    EXPECT_EQ(event.tool, PenTool::kPen);
  }
  EXPECT_EQ(std::get<FingerDraw>(made[0]).event.kind, PenEvent::Kind::kDown);
  EXPECT_EQ(std::get<FingerDraw>(made[1]).event.kind, PenEvent::Kind::kMotion);
  EXPECT_EQ(std::get<FingerDraw>(made[4]).event.kind, PenEvent::Kind::kUp);
}

TEST(Gestures, ADrawingFingerMakesDotsAndQuickLines) {
  EXPECT_THAT(NamesOf({Touch(Kind::kDown, 0, {100, 100}), Touch(Kind::kUp, 0.9, {100, 100})}, true),
              ElementsAre("draw begin", "draw end"));
  EXPECT_THAT(NamesOf({Touch(Kind::kDown, 0, {100, 100}), Touch(Kind::kMotion, 0.02, {150, 100}),
                       Touch(Kind::kUp, 0.03, {150, 100})},
                      true),
              ElementsAre("draw begin", "draw move", "draw end"));
}

TEST(Gestures, TwoFingersStillPinchWhereOneDraws) {
  EXPECT_THAT(
      NamesOf({Touch(Kind::kDown, 0, {100, 100}, 0), Touch(Kind::kMotion, 0.03, {130, 100}, 0),
               Touch(Kind::kDown, 0.05, {200, 100}, 1), Touch(Kind::kMotion, 0.06, {260, 100}, 1)},
              true),
      ElementsAre("pan begin"));
  EXPECT_THAT(NamesOf(TapOf(2, 0.1, 0), true), ElementsAre("tap 2"));
}

TEST(Gestures, AHandThatRestsBesideADrawingFingerDoesNotDisturbIt) {
  EXPECT_THAT(
      NamesOf({Touch(Kind::kDown, 0, {100, 100}, 0), Touch(Kind::kMotion, 0.1, {150, 100}, 0),
               Touch(Kind::kDown, 0.2, {300, 300}, 1), Touch(Kind::kMotion, 0.3, {400, 300}, 1),
               Touch(Kind::kMotion, 0.4, {200, 100}, 0), Touch(Kind::kUp, 0.5, {200, 100}, 0),
               Touch(Kind::kMotion, 0.6, {300, 300}, 1)},
              true),
      ElementsAre("draw begin", "draw move", "draw move", "draw end"));
}

TEST(Gestures, ACancelledDrawingFingerLeavesNoStroke) {
  Gestures gestures;
  gestures.SetFingerDraws(true);
  const auto made =
      Made(&gestures, {Touch(Kind::kDown, 0, {100, 100}), Touch(Kind::kMotion, 0.1, {150, 100}),
                       Touch(Kind::kCancel, 0.2, {150, 100})});
  ASSERT_THAT(made, SizeIs(3));
  EXPECT_EQ(NameOf(made.back()), "draw cancel");
  EXPECT_EQ(std::get<FingerDraw>(made.back()).event.kind, PenEvent::Kind::kProximityOut);
}

TEST(Gestures, TheModeChangesWithTheNextFinger) {
  Gestures gestures;
  Made(&gestures, {Touch(Kind::kDown, 0, {100, 100})});
  gestures.SetFingerDraws(true);
  EXPECT_THAT(NameOf(Made(&gestures, {Touch(Kind::kMotion, 0.1, {150, 100})}).at(0)),
              "orbit begin");
}

TEST(Gestures, FingersOnOneSpotZoomWithinReason) {
  Gestures gestures;
  const auto made =
      Made(&gestures, {Touch(Kind::kDown, 0, {100, 100}, 0), Touch(Kind::kDown, 0, {100, 100}, 1),
                       Touch(Kind::kMotion, 0.1, {500, 100}, 1)});
  EXPECT_NEAR(std::get<PanZoomGesture>(made.at(0)).scale,
              400 / (GestureParams().nearest_mm * kPxPerMm), 1e-12);
}

/// Any stream, sensible or not: repeated downs, ups of nobody, numbers that are none.
std::vector<ViewTouch> AnyTouches() {
  const auto number = [](int low, int high) { return *rc::gen::inRange(low, high + 1); };
  std::vector<ViewTouch> touches;
  double t_s = 0;
  const int count = number(0, 60);
  for (int i = 0; i < count; ++i) {
    t_s += number(0, 120) * 1e-3;
    Vec2 at(number(0, 100), number(0, 100));
    if (number(0, 30) == 0) at.x = std::numeric_limits<double>::quiet_NaN();
    if (number(0, 30) == 0) at.y = 1e300;
    touches.push_back(Touch(static_cast<Kind>(number(0, 3)), t_s, at, number(0, 3)));
  }
  return touches;
}

RC_GTEST_PROP(Gestures, Property1And3_OneAtATimeFromBeginToEndAndScalesAreSane, (bool draws)) {
  Gestures gestures;
  gestures.SetFingerDraws(draws);
  std::string going;  // "" or the name of the gesture that goes on
  for (const Gesture& gesture : Made(&gestures, AnyTouches())) {
    const std::string name = NameOf(gesture);
    const std::string kind = name.substr(0, name.find(' ')),
                      phase = name.substr(name.find(' ') + 1);
    if (kind == "tap") {
      RC_ASSERT(going.empty());
      continue;
    }
    RC_ASSERT(going == (phase == "begin" ? "" : kind));
    going = phase == "begin" || phase == "move" ? kind : "";
    if (const auto* pan = std::get_if<PanZoomGesture>(&gesture)) {
      RC_ASSERT(std::isfinite(pan->scale) && pan->scale > 0);
      RC_ASSERT(IsFinite(pan->from_px) && IsFinite(pan->to_px));
    }
  }
}

RC_GTEST_PROP(Gestures, Property2_AnEmptyScreenIsANewOne, (bool draws)) {
  Gestures gestures;
  gestures.SetFingerDraws(draws);
  Made(&gestures, AnyTouches());
  Made(&gestures, {Touch(Kind::kUp, 90, {1, 1}, 0), Touch(Kind::kUp, 90, {1, 1}, 1),
                   Touch(Kind::kCancel, 90, {1, 1}, 2), Touch(Kind::kUp, 90, {1, 1}, 3)});
  Gestures fresh;
  fresh.SetFingerDraws(draws);
  RC_ASSERT(gestures == fresh);
}

RC_GTEST_PROP(Gestures, Property4_CancelledTouchesNeverTap, ()) {
  Gestures gestures;
  std::vector<ViewTouch> touches = AnyTouches();
  for (ViewTouch& touch : touches) {
    if (touch.touch.kind == Kind::kUp) touch.touch.kind = Kind::kCancel;
  }
  for (const Gesture& gesture : Made(&gestures, touches)) {
    RC_ASSERT(!std::holds_alternative<TapGesture>(gesture));
    RC_ASSERT(!NameOf(gesture).ends_with(" end") || NameOf(gesture).starts_with("orbit"));
  }
}

}  // namespace
}  // namespace parti::input
