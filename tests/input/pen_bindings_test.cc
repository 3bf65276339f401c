#include "input/pen_bindings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "tests/support/events.h"

namespace parti::input {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using tests::Pen;
using Kind = PenEvent::Kind;

/// `act` with the phases that came of it, as "draw begin".
std::vector<std::string> DragsOf(PenBindings* bindings, const std::vector<InputEvent>& events) {
  static constexpr const char* kPhases[] = {"begin", "move", "end", "cancel"};
  static constexpr const char* kActs[] = {"none",  "draw", "erase", "select",
                                          "orbit", "pan",  "zoom"};
  std::vector<std::string> drags;
  for (const InputEvent& event : events) {
    for (const PenDrag& drag : bindings->Feed(event)) {
      drags.push_back(std::string(kActs[static_cast<int>(drag.act)]) + ' ' +
                      kPhases[static_cast<int>(drag.phase)]);
    }
  }
  return drags;
}

std::vector<std::string> DragsOf(const std::vector<InputEvent>& events) {
  PenBindings bindings;
  return DragsOf(&bindings, events);
}

PenEvent With(PenEvent event, PenTool tool) {
  event.tool = tool;
  return event;
}

PenEvent Button(uint32_t button, bool pressed, PenTool tool = PenTool::kPen) {
  PenEvent event = With(Pen(Kind::kButton, 1, {1, 1}), tool);
  event.button = button;
  event.pressed = pressed;
  return event;
}

PenEvent Mouse(Kind kind) { return With(Pen(kind, 1, {1, 1}), PenTool::kMouse); }
PenEvent MouseButton(uint32_t button, bool pressed) {
  return Button(button, pressed, PenTool::kMouse);
}
KeyEvent Key(uint32_t code, bool pressed) { return {9, 1, code, pressed}; }

TEST(PenBindings, APenDrawsAndItsOtherEndErases) {
  for (const auto& [tool, act] : {std::pair(PenTool::kPen, "draw"), {PenTool::kEraser, "erase"}}) {
    EXPECT_THAT(
        DragsOf({With(Pen(Kind::kProximityIn, 1, {1, 1}), tool),
                 With(Pen(Kind::kMotion, 1, {1, 1}), tool), With(Pen(Kind::kDown, 1, {1, 1}), tool),
                 With(Pen(Kind::kMotion, 1, {2, 1}), tool), With(Pen(Kind::kUp, 1, {2, 1}), tool)}),
        ElementsAre(std::string(act) + " begin", std::string(act) + " move",
                    std::string(act) + " end"));
  }
}

TEST(PenBindings, TheLowerButtonErasesAndTheUpperOneSelects) {
  EXPECT_THAT(
      DragsOf({Button(BTN_STYLUS, true), Pen(Kind::kDown, 1, {1, 1}), Pen(Kind::kUp, 1, {1, 1}),
               Button(BTN_STYLUS, false), Button(BTN_STYLUS2, true), Pen(Kind::kDown, 1, {1, 1}),
               Pen(Kind::kUp, 1, {1, 1})}),
      ElementsAre("erase begin", "erase end", "select begin", "select end"));
}

TEST(PenBindings, WhatAStrokeDoesIsSettledWhenItBegins) {
  EXPECT_THAT(DragsOf({Pen(Kind::kDown, 1, {1, 1}), Button(BTN_STYLUS, true),
                       Pen(Kind::kMotion, 1, {2, 1}), Pen(Kind::kUp, 1, {2, 1})}),
              ElementsAre("draw begin", "draw move", "draw end"));
}

TEST(PenBindings, AMouseDrawsPansAndOrbits) {
  EXPECT_THAT(
      DragsOf({Mouse(Kind::kMotion), Mouse(Kind::kDown), Mouse(Kind::kMotion), Mouse(Kind::kUp),
               MouseButton(BTN_MIDDLE, true), Mouse(Kind::kMotion), MouseButton(BTN_MIDDLE, false),
               MouseButton(BTN_RIGHT, true), MouseButton(BTN_RIGHT, false)}),
      ElementsAre("draw begin", "draw move", "draw end", "pan begin", "pan move", "pan end",
                  "orbit begin", "orbit end"));
}

TEST(PenBindings, KeysThatAreHeldChangeWhatAMouseDoes) {
  EXPECT_THAT(DragsOf({Key(KEY_RIGHTSHIFT, true), MouseButton(BTN_MIDDLE, true),
                       MouseButton(BTN_MIDDLE, false), Mouse(Kind::kDown), Mouse(Kind::kUp),
                       Key(KEY_RIGHTSHIFT, false), Key(KEY_LEFTCTRL, true), Mouse(Kind::kDown),
                       Mouse(Kind::kUp)}),
              ElementsAre("pan begin", "pan end", "select begin", "select end", "erase begin",
                          "erase end"));
}

TEST(PenBindings, KeysOfAKeyboardThatGoesAreHeldNoMore) {
  DeviceEvent gone;
  gone.kind = DeviceEvent::Kind::kRemoved;
  gone.device = 9;
  EXPECT_THAT(DragsOf({Key(KEY_LEFTCTRL, true), gone, Mouse(Kind::kDown), Mouse(Kind::kUp)}),
              ElementsAre("draw begin", "draw end"));
}

TEST(PenBindings, OneDragAtATime) {
  EXPECT_THAT(DragsOf({MouseButton(BTN_RIGHT, true), Mouse(Kind::kDown), Mouse(Kind::kUp),
                       MouseButton(BTN_MIDDLE, true), MouseButton(BTN_MIDDLE, false),
                       Mouse(Kind::kMotion), MouseButton(BTN_RIGHT, false)}),
              ElementsAre("orbit begin", "orbit move", "orbit end"));
}

TEST(PenBindings, AnUnpluggedDeviceEndsItsDragWhereItWas) {
  DeviceEvent gone = tests::PenAdded(0, 3);
  gone.kind = DeviceEvent::Kind::kRemoved;
  PenBindings bindings;
  bindings.Feed(Pen(Kind::kDown, 1, {1, 1}));
  bindings.Feed(Pen(Kind::kMotion, 2, {5, 6}));
  const auto drags = bindings.Feed(gone);
  ASSERT_EQ(drags.size(), 1u);
  EXPECT_EQ(drags[0].phase, DragPhase::kEnd);
  EXPECT_EQ(drags[0].event.position_mm, Vec2(5, 6));
  EXPECT_EQ(drags[0].event.t_s, 3);
  EXPECT_EQ(bindings.Doing(0), std::nullopt);
}

TEST(PenBindings, AnUpThatGotLostEndsTheStrokeBeforeTheNext) {
  EXPECT_THAT(DragsOf({Pen(Kind::kDown, 1, {1, 1}), Pen(Kind::kDown, 1, {2, 1}),
                       Pen(Kind::kProximityOut, 1, {2, 1})}),
              ElementsAre("draw begin", "draw end", "draw begin", "draw end"));
}

TEST(PenBindings, HoveringSaysWhatTheTipWouldDo) {
  PenBindings bindings;
  EXPECT_EQ(bindings.WouldDo(0), PenAct::kDraw);
  bindings.Feed(Button(BTN_STYLUS, true));
  EXPECT_EQ(bindings.WouldDo(0), PenAct::kErase);
  bindings.Feed(Button(BTN_STYLUS, false));
  bindings.Feed(With(Pen(Kind::kProximityIn, 1, {1, 1}), PenTool::kEraser));
  EXPECT_EQ(bindings.WouldDo(0), PenAct::kErase);
  EXPECT_EQ(bindings.Doing(0), std::nullopt);
}

TEST(PenBindings, TheWheelZoomsAndWithShiftPans) {
  PenBindings bindings;
  EXPECT_EQ(bindings.WheelDoes(), PenAct::kZoom);
  bindings.Feed(Key(KEY_LEFTSHIFT, true));
  EXPECT_EQ(bindings.WheelDoes(), PenAct::kPan);
}

TEST(PenBindings, AnotherTableTakesHoldWithTheNextStroke) {
  PenBindings bindings;
  bindings.Feed(Pen(Kind::kDown, 1, {1, 1}));
  bindings.SetTable(*ReadBindings("pen=erase pen+lower=orbit"));
  EXPECT_THAT(DragsOf(&bindings, {Pen(Kind::kUp, 1, {1, 1}), Pen(Kind::kDown, 1, {1, 1}),
                                  Pen(Kind::kUp, 1, {1, 1}), Button(BTN_STYLUS, true),
                                  Pen(Kind::kDown, 1, {1, 1})}),
              ElementsAre("draw end", "erase begin", "erase end", "orbit begin"));
}

TEST(PenBindings, WhatIsNotBoundDoesNothing) {
  PenBindings bindings(BindingTable{});
  EXPECT_THAT(DragsOf(&bindings, tests::StrokeEvents("0,0 1,1", 0)), IsEmpty());
}

RC_GTEST_PROP(PenBindings, Property1_EachDeviceDragsOneThingFromBeginToEnd, ()) {
  const Drawing drawing = *tests::ArbitraryDrawing();
  PenBindings bindings;
  std::map<int, PenAct> acts;
  for (const InputEvent& event : drawing.events) {
    for (const PenDrag& drag : bindings.Feed(event)) {
      PenAct& act = acts[drag.event.device];
      RC_ASSERT(drag.act != PenAct::kNone);
      RC_ASSERT(act == (drag.phase == DragPhase::kBegin ? PenAct::kNone : drag.act));
      act = drag.phase == DragPhase::kEnd ? PenAct::kNone : drag.act;
      RC_ASSERT(bindings.Doing(drag.event.device).value_or(PenAct::kNone) == act ||
                drag.phase == DragPhase::kEnd);
    }
  }
}

RC_GTEST_PROP(PenBindings, Property2_PensDragExactlyTheirStrokes, ()) {
  Drawing drawing = *tests::ArbitraryDrawing();
  PenBindings bindings;
  PenContacts contacts;
  for (InputEvent& event : drawing.events) {
    if (auto* pen = std::get_if<PenEvent>(&event)) pen->tool = PenTool::kPen;
    const ContactChange contact = contacts.Feed(event);
    bool began = false, moved = false, ended = false;
    for (const PenDrag& drag : bindings.Feed(event)) {
      began = began || drag.phase == DragPhase::kBegin;
      moved = moved || drag.phase == DragPhase::kMove;
      ended = ended || drag.phase == DragPhase::kEnd;
    }
    RC_ASSERT(began == contact.began);
    RC_ASSERT(moved == contact.moved);
    RC_ASSERT(ended == contact.ended.has_value());
  }
}

}  // namespace
}  // namespace parti::input
