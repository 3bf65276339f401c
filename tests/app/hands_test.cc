#include "app/hands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace parti::app {
namespace {

using input::DragPhase;
using input::PenAct;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

constexpr int kPen = 0, kTouch = 1, kMouse = 2;

/// A pen tablet of 160 x 100 mm, a touch screen and a mouse on a view of 1600 x 1000 px: 10 px to
/// the millimetre everywhere. A panel covers the top 100 px.
class HandsTest : public testing::Test {
 protected:
  HandsTest() {
    hands_.SetView(Camera{}, {});
    DeviceFacts pen, touch, mouse;
    pen.has_pen = touch.has_touch = mouse.has_pointer = true;
    pen.size_mm = touch.size_mm = Vec2(160, 100);
    mouse.view_px_per_mm = 10;
    Feed(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kPen, pen});
    Feed(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kTouch, touch});
    Feed(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kMouse, mouse});
  }

  std::vector<Act> Feed(const InputEvent& event) {
    return hands_.Feed(event, [](const Vec2& px) { return px.y < 100; });
  }
  std::vector<Act> Pen(PenEvent::Kind kind, const Vec2& px, int device = kPen) {
    t_s_ += 0.01;
    PenEvent event;
    event.kind = kind;
    event.device = device;
    event.t_s = t_s_;
    event.position_mm = px / 10.0;
    if (device == kMouse) event.tool = PenTool::kMouse;
    return Feed(event);
  }
  std::vector<Act> Touch(TouchEvent::Kind kind, const Vec2& px, int finger = 0) {
    t_s_ += 0.01;
    return Feed(TouchEvent{kind, kTouch, finger, t_s_, px / 10.0});
  }

  Hands hands_;
  double t_s_ = 1;
};

/// Drags among acts, as "begin draw", in order; others as their name.
std::vector<std::string> Words(const std::vector<Act>& acts) {
  std::vector<std::string> words;
  for (const Act& act : acts) {
    if (const auto* drag = std::get_if<DragAct>(&act)) {
      const char* phases[] = {"begin", "move", "end", "cancel"};
      const char* names[] = {"none", "draw", "erase", "select", "orbit", "pan", "zoom"};
      words.emplace_back(std::string(phases[static_cast<int>(drag->phase)]) + " " +
                         names[static_cast<int>(drag->act)]);
    } else if (const auto* panel = std::get_if<PanelAct>(&act)) {
      const auto* pointer = std::get_if<PanelPointer>(&panel->event);
      words.emplace_back(pointer ? pointer->down ? "press" : "point"
                         : std::holds_alternative<PanelPointerGone>(panel->event) ? "gone"
                                                                                  : "panel");
    } else if (std::holds_alternative<HoverAct>(act)) {
      words.emplace_back("hover");
    } else if (std::holds_alternative<HoverEndAct>(act)) {
      words.emplace_back("hover end");
    } else if (const auto* orbit = std::get_if<input::OrbitGesture>(&act)) {
      words.emplace_back(orbit->phase == DragPhase::kCancel ? "orbit cancelled" : "orbit");
    } else if (const auto* tap = std::get_if<input::TapGesture>(&act)) {
      words.emplace_back("tap " + std::to_string(tap->fingers));
    } else {
      words.emplace_back("other");
    }
  }
  return words;
}

TEST_F(HandsTest, APenHoversAndDrawsInPixelsOfTheView) {
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kProximityIn, {800, 500})), ElementsAre("point", "hover"));
  const auto began = Pen(PenEvent::Kind::kDown, {800, 500});
  EXPECT_THAT(Words(began), ElementsAre("hover end", "begin draw"));
  EXPECT_EQ(std::get<DragAct>(began[1]).px, Vec2(800, 500));
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kMotion, {900, 50})), ElementsAre("move draw"))
      << "it stays the drawing's, over panels too";
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kUp, {900, 300})),
              ElementsAre("end draw", "point", "hover"));
}

TEST_F(HandsTest, WhatComesDownOnAPanelIsThePanels) {
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kDown, {800, 50})), ElementsAre("press"));
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kMotion, {800, 500})), ElementsAre("press"));
  const auto up = Pen(PenEvent::Kind::kUp, {800, 500});
  EXPECT_EQ(Words(up)[0], "point") << "let go";
}

TEST_F(HandsTest, AToolThatWasChosenIsWhatThePenDoes) {
  hands_.SetMode(PenAct::kErase);
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kDown, {800, 500})), ElementsAre("begin erase"));
  hands_.SetMode(PenAct::kDraw);
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kUp, {800, 500})),
              ElementsAre("end erase", "point", "hover"))
      << "a drag stays what it began as";
}

TEST_F(HandsTest, AMouseDrawsWithItsLeftButton) {
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kMotion, {500, 500}, kMouse)),
              ElementsAre("point", "hover"));
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kDown, {500, 500}, kMouse)),
              ElementsAre("hover end", "begin draw"));
}

TEST_F(HandsTest, WhatComesDownBesideAPenThatDrawsDoesNothing) {
  Pen(PenEvent::Kind::kDown, {800, 500});
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kDown, {300, 500}, kMouse)), IsEmpty());
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kMotion, {320, 500}, kMouse)), IsEmpty());
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kMotion, {810, 500})), ElementsAre("move draw"));
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kUp, {320, 500}, kMouse)), Not(Contains("end draw")));
  EXPECT_TRUE(hands_.dragging());
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kUp, {820, 500})), Contains("end draw"));
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kDown, {300, 500}, kMouse)), Contains("begin draw"))
      << "its turn";
}

TEST_F(HandsTest, APenTakesOverFromAMouseThatDraws) {
  Pen(PenEvent::Kind::kDown, {300, 500}, kMouse);
  Pen(PenEvent::Kind::kMotion, {320, 500}, kMouse);
  const auto began = Pen(PenEvent::Kind::kDown, {800, 500});
  ASSERT_THAT(Words(began), ElementsAre("end draw", "begin draw"));
  EXPECT_EQ(std::get<DragAct>(began[0]).device, kMouse);
  EXPECT_EQ(std::get<DragAct>(began[0]).px, Vec2(320, 500));
  EXPECT_EQ(std::get<DragAct>(began[1]).device, kPen);
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kMotion, {330, 500}, kMouse)), IsEmpty());
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kMotion, {810, 500})), ElementsAre("move draw"));
}

TEST_F(HandsTest, AnUnpluggedPenEndsItsStrokeAndKeepsIt) {
  Pen(PenEvent::Kind::kDown, {800, 500});
  Pen(PenEvent::Kind::kMotion, {810, 500});
  EXPECT_THAT(Words(Feed(DeviceEvent{DeviceEvent::Kind::kRemoved, 9, kPen, {}})),
              ElementsAre("end draw"));
  EXPECT_FALSE(hands_.dragging());
  EXPECT_FALSE(hands_.pen_present());
}

TEST_F(HandsTest, AnUnpluggedPenPressesNoButton) {
  Pen(PenEvent::Kind::kDown, {800, 50});
  EXPECT_THAT(Words(Feed(DeviceEvent{DeviceEvent::Kind::kRemoved, 9, kPen, {}})),
              ElementsAre("gone"));
  t_s_ = 10;  // when no palm of that hand is to be expected any more
  EXPECT_THAT(Words(Touch(TouchEvent::Kind::kDown, {800, 50})), ElementsAre("press"))
      << "the panels are free again";
}

TEST_F(HandsTest, APalmThatWasThereBeforeThePenTakesItsOrbitBack) {
  Touch(TouchEvent::Kind::kDown, {800, 500});
  for (int i = 1; i < 30; ++i) Touch(TouchEvent::Kind::kMotion, {800.0 + 5 * i, 500});
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kProximityIn, {300, 500})),
              ElementsAre("orbit cancelled", "point", "hover"));
  EXPECT_THAT(Words(Touch(TouchEvent::Kind::kMotion, {900, 600})), IsEmpty());
}

TEST_F(HandsTest, TwoFingersTap) {
  Touch(TouchEvent::Kind::kDown, {800, 500}, 0);
  Touch(TouchEvent::Kind::kDown, {900, 500}, 1);
  Touch(TouchEvent::Kind::kUp, {800, 500}, 0);
  EXPECT_THAT(Words(Touch(TouchEvent::Kind::kUp, {900, 500}, 1)), ElementsAre("tap 2"));
}

TEST_F(HandsTest, AFingerOnAPanelIsAPointerAndNoGesture) {
  EXPECT_THAT(Words(Touch(TouchEvent::Kind::kDown, {800, 50}, 0)), ElementsAre("press"));
  EXPECT_THAT(Words(Touch(TouchEvent::Kind::kDown, {900, 50}, 1)), IsEmpty()) << "one pointer";
  EXPECT_THAT(Words(Touch(TouchEvent::Kind::kUp, {800, 50}, 0)), ElementsAre("point", "gone"));
  EXPECT_THAT(Words(Touch(TouchEvent::Kind::kUp, {900, 50}, 1)), IsEmpty());
}

TEST_F(HandsTest, AFingerDrawsWhereThatIsSwitchedOn) {
  hands_.SetFingerDraws(true);
  std::vector<std::string> words;
  const auto note = [&](const std::vector<Act>& acts) {
    for (const std::string& word : Words(acts)) words.emplace_back(word);
  };
  note(Touch(TouchEvent::Kind::kDown, {800, 500}));
  for (int i = 1; i < 20; ++i) note(Touch(TouchEvent::Kind::kMotion, {800.0 + 10 * i, 500}));
  note(Touch(TouchEvent::Kind::kUp, {990, 500}));
  ASSERT_FALSE(words.empty());
  EXPECT_EQ(words.front(), "begin draw");
  EXPECT_EQ(words.back(), "end draw");
}

TEST_F(HandsTest, LiftingEverythingKeepsWhatIsDrawn) {
  Pen(PenEvent::Kind::kDown, {800, 500});
  EXPECT_THAT(Words(hands_.LiftAll()), ElementsAre("end draw"));
  EXPECT_THAT(Words(Pen(PenEvent::Kind::kMotion, {900, 500})), IsEmpty());
}

TEST_F(HandsTest, PositionsThatAreNoneStayWhereTheyWere) {
  Pen(PenEvent::Kind::kDown, {800, 500});
  const auto moved = Pen(PenEvent::Kind::kMotion, {NAN, 500});
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(std::get<DragAct>(moved[0]).px, Vec2(800, 500));
}

}  // namespace
}  // namespace parti::app
