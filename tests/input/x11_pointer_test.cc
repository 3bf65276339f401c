// Reports of X's pens, erasers and mice as events, without a server.
#include "input/x11_pointer.h"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include <limits>

#include "input/x11_clock.h"
#include "input/x11_devices.h"

namespace parti::input {
namespace {

using Kind = X11PointerReport::Kind;

/// A pen as the wacom driver describes it, in a view of 4 px a millimetre.
X11Pointer Pen(PenTool tool = PenTool::kPen) {
  return {{7,
           tool,
           {{2, X11Role::kPressure, 0, 65536},
            {3, X11Role::kTiltX, -64, 63},
            {4, X11Role::kTiltY, -64, 63}}},
          4};
}

X11PointerReport At(Kind kind, double t_s, const Vec2& px,
                    std::vector<std::pair<int, double>> values = {}) {
  X11PointerReport report;
  report.kind = kind;
  report.t_s = t_s;
  report.position_px = px;
  report.values = std::move(values);
  return report;
}

X11PointerReport Button(Kind kind, int button, double t_s = 1) {
  X11PointerReport report = At(kind, t_s, {40, 80});
  report.button = button;
  return report;
}

const PenEvent& PenAt(const std::vector<InputEvent>& events, size_t i) {
  return std::get<PenEvent>(events.at(i));
}

TEST(X11Pointers, AStrokeHasPressureAndTilt) {
  X11Pointer pen = Pen();
  const auto near = pen.Feed(At(Kind::kMotion, 1, {40, 80}, {{2, 0}, {3, 10}, {4, -20}}));
  ASSERT_EQ(near.size(), 2u);
  EXPECT_EQ(PenAt(near, 0).kind, PenEvent::Kind::kProximityIn);
  EXPECT_EQ(PenAt(near, 1).kind, PenEvent::Kind::kMotion);
  EXPECT_EQ(PenAt(near, 1).position_mm, Vec2(10, 20));
  EXPECT_EQ(PenAt(near, 1).tilt_deg, Vec2(10, -20));
  EXPECT_EQ(PenAt(near, 1).pressure, 0.0);
  EXPECT_EQ(PenAt(near, 1).device, 7);
  const auto down = pen.Feed(Button(Kind::kPress, 1));
  ASSERT_EQ(down.size(), 1u);
  EXPECT_EQ(PenAt(down, 0).kind, PenEvent::Kind::kDown);
  EXPECT_TRUE(pen.is_down());
  const auto moved = pen.Feed(At(Kind::kMotion, 2, {44, 80}, {{2, 32768}}));
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(PenAt(moved, 0).pressure, 0.5);
  EXPECT_EQ(PenAt(moved, 0).tilt_deg, Vec2(10, -20)) << "valuators that did not change stay";
  EXPECT_EQ(PenAt(pen.Feed(Button(Kind::kRelease, 1)), 0).kind, PenEvent::Kind::kUp);
}

TEST(X11Pointers, APenThatGoesAwayIsLiftedFirst) {
  X11Pointer pen = Pen(PenTool::kEraser);
  pen.Feed(Button(Kind::kPress, 1));
  const auto left = pen.Feed(At(Kind::kProximityOut, 3, {0, 0}));
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(PenAt(left, 0).kind, PenEvent::Kind::kUp);
  EXPECT_EQ(PenAt(left, 1).kind, PenEvent::Kind::kProximityOut);
  EXPECT_EQ(PenAt(left, 1).tool, PenTool::kEraser);
  EXPECT_EQ(PenAt(left, 1).position_mm, Vec2(10, 20));
  EXPECT_TRUE(pen.Leave(4).empty()) << "only once";
}

TEST(X11Pointers, TheEdgeOfTheWindowDoesNotEndAStroke) {
  X11Pointer pen = Pen();
  pen.Feed(Button(Kind::kPress, 1));
  EXPECT_TRUE(pen.Feed(At(Kind::kLeave, 2, {-5, 10})).empty());
  EXPECT_EQ(pen.Feed(At(Kind::kMotion, 2, {-20, 10})).size(), 1u);
  pen.Feed(Button(Kind::kRelease, 1));
  EXPECT_EQ(pen.Feed(At(Kind::kLeave, 3, {-5, 10})).size(), 1u);
}

TEST(X11Pointers, ButtonsOfPensAndMiceHaveTheirKernelCodes) {
  const std::vector<std::pair<int, uint32_t>> pens = {
      {2, BTN_STYLUS}, {3, BTN_STYLUS2}, {8, BTN_STYLUS3}};
  const std::vector<std::pair<int, uint32_t>> mice = {
      {2, BTN_MIDDLE}, {3, BTN_RIGHT}, {8, BTN_SIDE}, {9, BTN_EXTRA}};
  for (const bool mouse : {false, true}) {
    X11Pointer pointer = mouse ? X11Pointer({1, PenTool::kMouse, {}}, 4) : Pen();
    pointer.Feed(At(Kind::kMotion, 1, {0, 0}));
    for (const auto& [number, code] : mouse ? mice : pens) {
      const auto events = pointer.Feed(Button(Kind::kPress, number));
      ASSERT_EQ(events.size(), 1u);
      EXPECT_EQ(PenAt(events, 0).kind, PenEvent::Kind::kButton);
      EXPECT_EQ(PenAt(events, 0).button, code);
      EXPECT_TRUE(PenAt(events, 0).pressed);
    }
  }
}

TEST(X11Pointers, AButtonThatIsHeldIsToldAgainWhenThePenComesBack) {
  X11Pointer pen = Pen();
  pen.Feed(At(Kind::kMotion, 1, {40, 80}));
  pen.Feed(Button(Kind::kPress, 2));
  EXPECT_EQ(PenAt(pen.Leave(2), 0).kind, PenEvent::Kind::kProximityOut);
  const auto back = pen.Feed(At(Kind::kMotion, 3, {44, 80}));
  ASSERT_EQ(back.size(), 3u);
  EXPECT_EQ(PenAt(back, 0).kind, PenEvent::Kind::kProximityIn);
  EXPECT_EQ(PenAt(back, 1).kind, PenEvent::Kind::kButton);
  EXPECT_EQ(PenAt(back, 1).button, BTN_STYLUS);
  EXPECT_TRUE(PenAt(back, 1).pressed);
  EXPECT_EQ(PenAt(back, 2).kind, PenEvent::Kind::kMotion);
  pen.Feed(Button(Kind::kRelease, 2));
  pen.Leave(4);
  EXPECT_EQ(pen.Feed(At(Kind::kMotion, 5, {44, 80})).size(), 2u) << "let go of before it left";
}

TEST(X11Pointers, ButtonsPressedAndLetGoOfElsewhereCount) {
  X11Pointer pen = Pen();
  X11PointerReport came = At(Kind::kMotion, 1, {40, 80});
  came.held = {{1, 3, 4}};  // as the server says; the tip and the wheel are no buttons of a pen
  auto events = pen.Feed(came);
  ASSERT_EQ(events.size(), 3u);
  EXPECT_EQ(PenAt(events, 1).button, BTN_STYLUS2);
  came.held = {{2}};
  EXPECT_EQ(pen.Feed(came).size(), 1u) << "while it is near its own reports are enough";
  pen.Leave(2);
  came.held = std::vector<int>();
  EXPECT_EQ(pen.Feed(came).size(), 2u);
}

TEST(X11Pointers, APenWhoseButtonsComeWithTheTipDrawsWithThem) {
  X11Pointer pen({7, PenTool::kPen, {}, true}, 4);
  pen.Feed(At(Kind::kMotion, 1, {40, 80}));
  const auto down = pen.Feed(Button(Kind::kPress, 3));
  ASSERT_EQ(down.size(), 2u);
  EXPECT_EQ(PenAt(down, 0).kind, PenEvent::Kind::kButton);
  EXPECT_EQ(PenAt(down, 0).button, BTN_STYLUS) << "the wacom driver exchanges the two";
  EXPECT_TRUE(PenAt(down, 0).pressed);
  EXPECT_EQ(PenAt(down, 1).kind, PenEvent::Kind::kDown);
  EXPECT_TRUE(pen.is_down());
  const auto up = pen.Feed(Button(Kind::kRelease, 3));
  ASSERT_EQ(up.size(), 2u);
  EXPECT_EQ(PenAt(up, 0).kind, PenEvent::Kind::kUp);
  EXPECT_EQ(PenAt(up, 1).kind, PenEvent::Kind::kButton);
  EXPECT_FALSE(PenAt(up, 1).pressed);
  EXPECT_EQ(PenAt(pen.Feed(Button(Kind::kPress, 2)), 0).button, BTN_STYLUS2);
  pen.Feed(Button(Kind::kRelease, 2));
  EXPECT_EQ(PenAt(pen.Feed(Button(Kind::kPress, 1)), 0).kind, PenEvent::Kind::kDown)
      << "the tip alone";
}

TEST(X11Pointers, AButtonPressedWhileTheTipIsDownBeginsAnotherStroke) {
  X11Pointer pen({7, PenTool::kPen, {}, true}, 4);
  pen.Feed(Button(Kind::kPress, 1));
  EXPECT_EQ(PenAt(pen.Feed(Button(Kind::kRelease, 1)), 0).kind, PenEvent::Kind::kUp);
  EXPECT_EQ(pen.Feed(Button(Kind::kPress, 3)).size(), 2u);
  // Let go of while the tip is still down, the driver releases the tip, too.
  EXPECT_EQ(PenAt(pen.Feed(Button(Kind::kRelease, 1)), 0).kind, PenEvent::Kind::kUp);
  const auto up = pen.Feed(Button(Kind::kRelease, 3));
  ASSERT_EQ(up.size(), 1u);
  EXPECT_EQ(PenAt(up, 0).kind, PenEvent::Kind::kButton);
}

TEST(X11Pointers, AMouseThatComesBackPressesNothing) {
  X11Pointer mouse({1, PenTool::kMouse, {}}, 4);
  X11PointerReport came = At(Kind::kMotion, 1, {40, 80});
  came.held = {{2, 3}};
  EXPECT_EQ(mouse.Feed(came).size(), 2u);
}

TEST(X11Pointers, AWheelWithValuatorsCountsNotches) {
  X11Pointer mouse({1,
                    PenTool::kMouse,
                    {{3, X11Role::kScrollY, 0, 0, 15, 100.0}, {2, X11Role::kScrollX, 0, 0, -10}}},
                   4);
  mouse.Feed(At(Kind::kMotion, 1, {40, 80}));
  auto events = mouse.Feed(At(Kind::kMotion, 2, {40, 80}, {{3, 107.5}}));
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(std::get<ScrollEvent>(events[0]).steps, Vec2(0, 0.5));
  EXPECT_EQ(std::get<ScrollEvent>(events[0]).position_mm, Vec2(10, 20));
  // A valuator whose place is not known yet is only taken note of.
  events = mouse.Feed(At(Kind::kMotion, 3, {40, 80}, {{2, 500}}));
  EXPECT_TRUE(std::holds_alternative<PenEvent>(events.at(0)));
  events = mouse.Feed(At(Kind::kMotion, 4, {40, 80}, {{2, 520}}));
  EXPECT_EQ(std::get<ScrollEvent>(events.at(0)).steps, Vec2(-2, 0));
  // Turned over another window meanwhile.
  mouse.SetScroll({{3, 1000}});
  events = mouse.Feed(At(Kind::kMotion, 5, {40, 80}, {{3, 1015}}));
  EXPECT_EQ(std::get<ScrollEvent>(events.at(0)).steps, Vec2(0, 1));
  EXPECT_TRUE(mouse.Feed(Button(Kind::kPress, 5)).empty()) << "told by the valuators already";
}

TEST(X11Pointers, AWheelOfButtonsCountsPresses) {
  X11Pointer mouse({1, PenTool::kMouse, {}}, 4);
  mouse.Feed(At(Kind::kMotion, 1, {40, 80}));
  const auto events = mouse.Feed(Button(Kind::kPress, 4));
  EXPECT_EQ(std::get<ScrollEvent>(events.at(0)).steps, Vec2(0, -1));
  EXPECT_TRUE(mouse.Feed(Button(Kind::kRelease, 4)).empty());
}

TEST(X11Pads, TheirRingsTurnAWheelAndTheirKeysAreNoButtons) {
  const auto turned = X11PadScroll(Button(Kind::kPress, 5), 3, 4);
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->device, 3);
  EXPECT_EQ(turned->steps, Vec2(0, 1));
  EXPECT_EQ(turned->position_mm, Vec2(10, 20));
  EXPECT_FALSE(X11PadScroll(Button(Kind::kRelease, 5), 3, 4)) << "once a notch";
  for (const int key : {1, 2, 3, 8, 9, 13}) {
    EXPECT_FALSE(X11PadScroll(Button(Kind::kPress, key), 3, 4)) << key;
  }
}

TEST(X11Pointers, WhatTheServerMadeUpOrCannotBeIsLeftOut) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  X11Pointer pen = Pen();
  X11PointerReport emulated = Button(Kind::kPress, 1);
  emulated.emulated = true;
  EXPECT_TRUE(pen.Feed(emulated).empty());
  pen.Feed(At(Kind::kMotion, 1, {40, 80}, {{2, 65536}}));
  const auto events = pen.Feed(At(Kind::kMotion, 2, {kNan, 1}, {{2, kNan}, {99, 4}}));
  EXPECT_EQ(PenAt(events, 0).position_mm, Vec2(10, 20));
  EXPECT_EQ(PenAt(events, 0).pressure, 1.0);
  EXPECT_TRUE(pen.Feed(Button(Kind::kRelease, 1)).empty()) << "it was not down";
}

TEST(X11Devices, ToolsAreToldByTypeNameAndPressure) {
  EXPECT_EQ(X11ToolOf("Wacom Intuos Pro M Pen stylus", "STYLUS", true), PenTool::kPen);
  EXPECT_EQ(X11ToolOf("Wacom Intuos Pro M Pen eraser", "ERASER", true), PenTool::kEraser);
  EXPECT_EQ(X11ToolOf("Wacom Intuos Pro M Pad pad", "PAD", false), std::nullopt);
  EXPECT_EQ(X11ToolOf("Wacom Intuos Pro M Finger touch", "TOUCH", false), PenTool::kMouse);
  EXPECT_EQ(X11ToolOf("Wacom Intuos Pro M Pen cursor", "CURSOR", false), PenTool::kMouse);
  EXPECT_EQ(X11ToolOf("Wacom Intuos Pro M Pen Pen (0x0102)", "", true), PenTool::kPen);
  EXPECT_EQ(X11ToolOf("Wacom Intuos Pro M Pen Eraser (0x0102)", "", true), PenTool::kEraser);
  EXPECT_EQ(X11ToolOf("Wacom Intuos Pro M Pad", "", false), std::nullopt);
  EXPECT_EQ(X11ToolOf("xwayland-tablet stylus:17", "", true), PenTool::kPen);
  EXPECT_EQ(X11ToolOf("xwayland-tablet eraser:17", "", true), PenTool::kEraser);
  EXPECT_EQ(X11ToolOf("xwayland-tablet-pad:19", "", false), std::nullopt);
  EXPECT_EQ(X11ToolOf("xwayland-tablet cursor:18", "", true), PenTool::kMouse);
  EXPECT_EQ(X11ToolOf("Wacom Intuos4 6x9 Pen Mouse (0x0805)", "", true), PenTool::kMouse);
  EXPECT_EQ(X11ToolOf("Wacom Intuos4 6x9 Pen Lens (0)", "", true), PenTool::kMouse);
  EXPECT_EQ(X11ToolOf("xwayland-pointer:16", "", false), PenTool::kMouse);
  EXPECT_EQ(X11ToolOf("SynPS/2 Synaptics TouchPad", "", false), PenTool::kMouse);
}

TEST(X11Devices, PowerButtonsAreNoKeyboards) {
  EXPECT_TRUE(IsButtonOnly("Power Button"));
  EXPECT_TRUE(IsButtonOnly("Virtual core XTEST keyboard"));
  EXPECT_TRUE(IsButtonOnly("Intel HID WMI hotkeys"));
  EXPECT_TRUE(IsButtonOnly("Intel HID events"));
  EXPECT_TRUE(IsButtonOnly("gpio-keys")) << "of tablets: their volume";
  EXPECT_FALSE(IsButtonOnly("AT Translated Set 2 keyboard"));
  EXPECT_FALSE(IsButtonOnly("xwayland-keyboard:16"));
}

TEST(X11Clocks, TheUpperBitsComeFromOurClock) {
  constexpr double kTurn_s = 4294967.296;  // 2^32 ms
  X11Clock clock;
  EXPECT_NEAR(clock.ToSeconds(1500, kTurn_s + 1.6), kTurn_s + 1.5, 1e-6);
  X11Clock before;
  EXPECT_NEAR(before.ToSeconds(0xffffff00u, 2 * kTurn_s + 0.1), 2 * kTurn_s - 0.256, 1e-6);
  EXPECT_NEAR(before.ToSeconds(500, 2 * kTurn_s + 0.6), 2 * kTurn_s + 0.5, 1e-6);
}

TEST(X11Clocks, AForeignClockIsShiftedAsAWhole) {
  X11Clock clock;
  EXPECT_NEAR(clock.ToSeconds(5'000'000, 100), 100, 1e-6);
  EXPECT_NEAR(clock.ToSeconds(5'000'250, 100.3), 100.25, 1e-6);
  EXPECT_NEAR(clock.ToSeconds(5'001'000, 101.1), 101, 1e-6);
}

TEST(X11Clocks, OurOwnTimesAreNotTheServers) {
  X11Clock clock;
  EXPECT_NEAR(clock.ToSeconds(5'000'000, 100), 100, 1e-6);
  EXPECT_NEAR(clock.Local(100.5), 100.5, 1e-6);
  EXPECT_NEAR(clock.ToSeconds(5'001'000, 101.1), 101, 1e-6) << "later events are not held back";
  EXPECT_NEAR(clock.Local(100.9), 101, 1e-6) << "nor does it run back";
}

TEST(X11Clocks, TimesNeverDecrease) {
  X11Clock clock;
  EXPECT_EQ(clock.ToSeconds(2000, 2), 2);
  EXPECT_EQ(clock.ToSeconds(1990, 2), 2);
}

}  // namespace
}  // namespace parti::input
