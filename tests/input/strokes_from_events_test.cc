#include "input/strokes_from_events.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "tests/support/events.h"

namespace parti::input {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Kind = PenEvent::Kind;
using tests::ArbitraryDrawing;
using tests::Pen;
using tests::PenAdded;
using tests::StrokeEvents;

TEST(StrokesFromEvents, PenDownToPenUpIsAStroke) {
  const auto strokes = StrokesOf(StrokeEvents("0,0 10,0 10,8", 1));
  ASSERT_THAT(strokes, SizeIs(1));
  EXPECT_EQ(strokes[0].end, StrokeEnd::kPenUp);
  EXPECT_EQ(strokes[0].tool, PenTool::kPen);
  EXPECT_THAT(strokes[0].samples,
              ElementsAre(PenSample{{0, 0}, 1, 0.5}, PenSample{{10, 0}, 1.01, 0.5},
                          PenSample{{10, 8}, 1.02, 0.5}));
}

TEST(StrokesFromEvents, DotIsAStrokeOfOneSample) {
  const auto strokes = StrokesOf(StrokeEvents("3,4", 0));
  ASSERT_THAT(strokes, SizeIs(1));
  EXPECT_THAT(strokes[0].samples, SizeIs(1));
}

TEST(StrokesFromEvents, HoveringDrawsNothing) {
  EXPECT_THAT(StrokesOf({Pen(Kind::kProximityIn, 0, {0, 0}), Pen(Kind::kMotion, 0.1, {5, 5}),
                         Pen(Kind::kUp, 0.2, {5, 5}), Pen(Kind::kProximityOut, 0.3, {5, 5})}),
              IsEmpty());
}

TEST(StrokesFromEvents, EraserStrokeIsMarked) {
  PenEvent down = Pen(Kind::kDown, 0, {0, 0});
  down.tool = PenTool::kEraser;
  const auto strokes = StrokesOf({down, Pen(Kind::kUp, 1, {1, 1})});
  ASSERT_THAT(strokes, SizeIs(1));
  EXPECT_EQ(strokes[0].tool, PenTool::kEraser);
}

struct Ending {
  const char* name;
  std::vector<InputEvent> events;
  StrokeEnd end;
};

class StrokeInProgress : public ::testing::TestWithParam<Ending> {};

TEST_P(StrokeInProgress, EndsCleanlyHoweverItIsCutOff) {
  std::vector<InputEvent> events{PenAdded(), Pen(Kind::kDown, 0, {0, 0}),
                                 Pen(Kind::kMotion, 0.1, {1, 0})};
  const auto& ending = GetParam();
  events.insert(events.end(), ending.events.begin(), ending.events.end());
  events.emplace_back(Pen(Kind::kMotion, 9, {9, 9}));  // hovering, whatever came before
  if (ending.end == StrokeEnd::kEndOfStream) events.pop_back();
  const auto strokes = StrokesOf(events);
  ASSERT_THAT(strokes, SizeIs(1));
  EXPECT_EQ(strokes[0].end, ending.end);
  EXPECT_THAT(strokes[0].samples, SizeIs(2));
}

INSTANTIATE_TEST_SUITE_P(
    StrokesFromEvents, StrokeInProgress,
    ::testing::Values(
        Ending{"PenUp", {Pen(Kind::kUp, 1, {1, 0})}, StrokeEnd::kPenUp},
        Ending{"ProximityOut", {Pen(Kind::kProximityOut, 1, {1, 0})}, StrokeEnd::kProximityOut},
        Ending{"ProximityInAgain", {Pen(Kind::kProximityIn, 1, {1, 0})}, StrokeEnd::kProximityOut},
        Ending{"DeviceRemoved",
               {DeviceEvent{DeviceEvent::Kind::kRemoved, 1, 0, {}}},
               StrokeEnd::kDeviceRemoved},
        Ending{"EndOfStream", {}, StrokeEnd::kEndOfStream}),
    [](const auto& tested) { return tested.param.name; });

TEST(StrokesFromEvents, AnotherDeviceGoingEndsNothing) {
  StrokesFromEvents machine;
  machine.Feed(Pen(Kind::kDown, 0, {0, 0}, 0));
  EXPECT_FALSE(machine.Feed(DeviceEvent{DeviceEvent::Kind::kRemoved, 1, 1, {}}));
  EXPECT_THAT(machine.in_progress(), SizeIs(1));
}

TEST(StrokesFromEvents, LostUpMakesTwoStrokes) {
  const auto strokes = StrokesOf({Pen(Kind::kDown, 0, {0, 0}), Pen(Kind::kMotion, 0.1, {1, 0}),
                                  Pen(Kind::kDown, 1, {5, 5}), Pen(Kind::kUp, 2, {6, 5})});
  ASSERT_THAT(strokes, SizeIs(2));
  EXPECT_THAT(strokes[0].samples, SizeIs(2));
  EXPECT_THAT(strokes[1].samples, SizeIs(1));
}

TEST(StrokesFromEvents, TwoPensDrawTwoStrokesAtOnce) {
  const auto strokes = StrokesOf({Pen(Kind::kDown, 0, {0, 0}, 0), Pen(Kind::kDown, 0.1, {9, 9}, 1),
                                  Pen(Kind::kMotion, 0.2, {1, 0}, 0),
                                  Pen(Kind::kUp, 0.3, {9, 9}, 1), Pen(Kind::kUp, 0.4, {1, 0}, 0)});
  ASSERT_THAT(strokes, SizeIs(2));
  EXPECT_EQ(strokes[0].device, 1);
  EXPECT_THAT(strokes[0].samples, SizeIs(1));
  EXPECT_THAT(strokes[1].samples, SizeIs(2));
}

TEST(StrokesFromEvents, NonFiniteReportsAreSkippedAndTimeNeverRunsBack) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const auto strokes = StrokesOf({Pen(Kind::kDown, 1, {0, 0}), Pen(Kind::kMotion, 2, {kNaN, 0}),
                                  Pen(Kind::kMotion, kNaN, {1, 0}), Pen(Kind::kMotion, 0.5, {2, 0}),
                                  Pen(Kind::kUp, 3, {2, 0})});
  ASSERT_THAT(strokes, SizeIs(1));
  EXPECT_THAT(strokes[0].samples, ElementsAre(PenSample{.position_mm = {0, 0}, .t_s = 1},
                                              PenSample{.position_mm = {2, 0}, .t_s = 1}));
}

RC_GTEST_PROP(StrokesFromEvents, Property1_AStreamInPiecesGivesTheSameStrokes, ()) {
  const Drawing drawing = *ArbitraryDrawing();
  std::vector<PenStroke> strokes;
  StrokesFromEvents machine;
  for (const InputEvent& event : drawing.events) {
    StrokesFromEvents copy = machine;  // a value: going on with a copy is going on
    if (auto stroke = copy.Feed(event)) strokes.push_back(*stroke);
    machine = copy;
  }
  for (const PenStroke& stroke : machine.Finish()) strokes.push_back(stroke);
  RC_ASSERT(strokes == StrokesOf(drawing.events));
  RC_ASSERT(machine == StrokesFromEvents());
}

RC_GTEST_PROP(StrokesFromEvents, Property2And3_NoSampleAndNoStrokeIsLost, ()) {
  const Drawing drawing = *ArbitraryDrawing();
  PenContacts contacts;
  size_t samples = 0, ended = 0;
  for (const InputEvent& event : drawing.events) {
    const ContactChange change = contacts.Feed(event);
    samples += change.began || change.moved ? 1 : 0;
    ended += change.ended ? 1 : 0;
  }
  const auto strokes = StrokesOf(drawing.events);
  size_t kept = 0;
  for (const PenStroke& stroke : strokes) kept += stroke.samples.size();
  RC_ASSERT(kept == samples);
  RC_ASSERT(strokes.size() == ended + contacts.down().size());
}

}  // namespace
}  // namespace parti::input
