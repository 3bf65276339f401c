#include "app/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

namespace parti::app {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kView = "view eye 42 17 47 target 10 8.5 7 fov 36 size 1600 1000";

/// A session with a lot, and a pen, a mouse and a keyboard that point into its view 1:1.
class ReplayTest : public ::testing::Test {
 protected:
  ReplayTest() {
    EXPECT_TRUE(player_.Execute(kView));
    EXPECT_TRUE(player_.Execute("lot rect(20,14)"));
    DeviceFacts facts;
    facts.view_px_per_mm = 1;
    facts.has_pen = facts.has_eraser = true;
    player_.Feed(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kPen, facts});
    facts.has_pen = facts.has_eraser = false;
    facts.has_pointer = true;
    player_.Feed(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kMouse, facts});
    facts = {};
    facts.has_keys = true;
    player_.Feed(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kKeys, facts});
  }

  PenEvent Report(PenEvent::Kind kind, PenTool tool, const Vec2& px) {
    PenEvent event;
    event.kind = kind;
    event.tool = tool;
    event.device = tool == PenTool::kMouse ? kMouse : kPen;
    event.t_s = t_s_ += 0.01;
    event.position_mm = px;
    return event;
  }

  /// The corner of a tower, drawn up from the lot.
  void DrawWith(PenTool tool) {
    const View view(session_.state().camera);
    const Vec2 from = *view.Project(Vec3(20, 0, 14)), to = *view.Project(Vec3(20, 19, 14));
    if (tool != PenTool::kMouse) player_.Feed(Report(PenEvent::Kind::kProximityIn, tool, from));
    player_.Feed(Report(PenEvent::Kind::kDown, tool, from));
    for (int i = 1; i < 40; ++i) {
      const double u = 0.5 - 0.5 * std::cos(kPi * i / 39);
      player_.Feed(Report(PenEvent::Kind::kMotion, tool, from + (to - from) * u));
    }
    player_.Feed(Report(PenEvent::Kind::kUp, tool, to));
  }

  static constexpr int kPen = 0, kMouse = 1, kKeys = 2;
  Session session_;
  ReplayReport report_;
  Player player_{&session_, &report_};
  double t_s_ = 0;
};

TEST_F(ReplayTest, APensTipDraws) {
  DrawWith(PenTool::kPen);
  EXPECT_THAT(session_.state().sketch.strokes, SizeIs(1));
  EXPECT_THAT(report_.unread, IsEmpty());
  ASSERT_TRUE(player_.Execute("pick 1 extrude"));
}

TEST_F(ReplayTest, AMousesLeftButtonDrawsAsAPenDoes) {
  DrawWith(PenTool::kMouse);
  EXPECT_THAT(session_.state().sketch.strokes, SizeIs(1));
}

TEST_F(ReplayTest, AnEraserCountsAsAStrokeButDoesNotDraw) {
  DrawWith(PenTool::kEraser);
  EXPECT_EQ(player_.strokes(), 1);
  EXPECT_EQ(session_.strokes_drawn(), 0u);
}

TEST_F(ReplayTest, WhatSelectsDoesNotDraw) {
  KeyEvent shift{kKeys, 0, KEY_LEFTSHIFT, true};
  player_.Feed(shift);
  DrawWith(PenTool::kMouse);
  EXPECT_EQ(session_.strokes_drawn(), 0u);
  shift.pressed = false;
  player_.Feed(shift);
  DrawWith(PenTool::kMouse);
  EXPECT_EQ(session_.strokes_drawn(), 1u);
}

TEST_F(ReplayTest, WhatIsBeingDrawnAtTheEndIsAStroke) {
  player_.Feed(Report(PenEvent::Kind::kProximityIn, PenTool::kPen, {10, 10}));
  player_.Feed(Report(PenEvent::Kind::kDown, PenTool::kPen, {10, 10}));
  player_.Feed(Report(PenEvent::Kind::kMotion, PenTool::kPen, {60, 10}));
  player_.Finish();
  EXPECT_EQ(player_.strokes(), 1);
  EXPECT_EQ(session_.strokes_drawn(), 1u);
}

TEST_F(ReplayTest, TheFirstCommandThatFailsEndsAReplay) {
  input::Drawing drawing;
  drawing.commands = {{0, kView}, {0, "pick 1"}, {0, "lot rect(1,1)"}};
  Session session;
  ReplayReport report;
  const auto played = Replay(drawing, &session, &report);
  ASSERT_FALSE(played);
  EXPECT_EQ(played.error().code, ErrorCode::kUnknownName);
  EXPECT_THAT(session.state().model.lots(), IsEmpty());
}

}  // namespace
}  // namespace parti::app
