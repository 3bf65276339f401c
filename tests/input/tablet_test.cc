// Real tablets' recordings, and drawings of our own, through the real libinput.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include <algorithm>

#include "base/json.h"
#include "base/text_file.h"
#include "input/strokes_from_events.h"
#include "input/unsmoothed.h"
#include "tests/support/data.h"
#include "tests/support/debug_events.h"
#include "tests/support/evdev_from_drawing.h"
#include "tests/support/events.h"
#include "tests/support/mock_tablet.h"

namespace parti::input {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using Kind = PenEvent::Kind;
using tests::EvdevRecording;
using tests::MockTablet;
using tests::Pen;
using tests::PlayThroughLibinput;

std::vector<PenEvent> PenEventsOf(const Drawing& drawing) {
  std::vector<PenEvent> pens;
  for (const InputEvent& event : drawing.events) {
    if (const auto* pen = std::get_if<PenEvent>(&event)) pens.push_back(*pen);
  }
  return pens;
}

/// The position after each of the recording's reports, straight from the raw events.
std::vector<Vec2> RawPositions_mm(const EvdevRecording& recording) {
  std::vector<Vec2> positions_mm;
  Vec2 now(0, 0);
  for (const auto& event : recording.events) {
    if (event.type == EV_ABS && event.code == ABS_X) now.x = event.value;
    if (event.type == EV_ABS && event.code == ABS_Y) now.y = event.value;
    if (event.type != EV_SYN) continue;
    const auto& x = recording.axes.at(ABS_X);
    const auto& y = recording.axes.at(ABS_Y);
    positions_mm.emplace_back((now.x - x.minimum) / x.resolution,
                              (now.y - y.minimum) / y.resolution);
  }
  return positions_mm;
}

struct RealTablet {
  const char* test_name;
  const char* file;
  size_t strokes;  ///< counted from raw pressures: down from 5 % of the range, up at 1 %
  size_t erased;   ///< of these, with the eraser
};

class RealTabletTest : public ::testing::TestWithParam<RealTablet> {
 protected:
  /// The recording with a resolution, which evemu 1.1 left out.
  static Result<EvdevRecording> Recording(const std::string& path) {
    const auto text = ReadFile(path);
    if (!text) return Fail(text);
    auto recording = tests::ReadEvemu(*text, path);
    if (!recording) return Fail(recording);
    tests::AssumeResolution(200, &*recording);  // units/mm, of all Wacom tablets of its time
    return recording;
  }
};

TEST_P(RealTabletTest, IsSeenAsLibinputsOwnToolSeesIt) {
  PARTI_NEED_DATA(path, std::string("tablets/") + GetParam().file);
  const auto recording = Recording(path);
  ASSERT_TRUE(recording) << FormatError(recording.error());
  const auto seen = PlayThroughLibinput(*recording);
  ASSERT_TRUE(seen) << FormatError(seen.error());
  const auto unsmoothed = Unsmoothed::Make();
  const auto lines = tests::PlayToDebugEvents(*recording);
  ASSERT_TRUE(lines) << FormatError(lines.error());

  const auto pens = PenEventsOf(*seen);
  ASSERT_EQ(pens.size(), lines->size());
  constexpr double kRounding = 0.00501;  // of two decimals
  for (size_t i = 0; i < pens.size(); ++i) {
    const tests::PenLine& line = (*lines)[i];
    ASSERT_EQ(pens[i].kind, line.kind) << i;
    if (line.pressure) {
      ASSERT_NEAR(pens[i].pressure.value_or(-1), *line.pressure, kRounding) << i;
    }
    if (!line.position_mm) continue;
    ASSERT_NEAR(pens[i].position_mm.x, line.position_mm->x, kRounding) << i;
    ASSERT_NEAR(pens[i].position_mm.y, line.position_mm->y, kRounding) << i;
  }
}

TEST_P(RealTabletTest, StrokesAreWholeAndPositionsAreTheDevicesOwn) {
  PARTI_NEED_DATA(path, std::string("tablets/") + GetParam().file);
  const auto recording = Recording(path);
  ASSERT_TRUE(recording) << FormatError(recording.error());
  const auto seen = PlayThroughLibinput(*recording);
  ASSERT_TRUE(seen) << FormatError(seen.error());

  const auto strokes = StrokesOf(seen->events);
  EXPECT_THAT(strokes, SizeIs(GetParam().strokes));
  const auto is_eraser = [](const PenStroke& s) { return s.tool == PenTool::kEraser; };
  EXPECT_EQ(std::count_if(strokes.begin(), strokes.end(), is_eraser),
            static_cast<std::ptrdiff_t>(GetParam().erased));
  for (const PenStroke& stroke : strokes) {
    EXPECT_EQ(stroke.end, StrokeEnd::kPenUp);
    EXPECT_GT(stroke.samples.size(), 1u);
  }
  // Smoothed positions would lie between the device's, not on them.
  const auto raw = RawPositions_mm(*recording);
  auto next = raw.begin();
  for (const PenEvent& pen : PenEventsOf(*seen)) {
    next = std::find_if(next, raw.end(), [&](const Vec2& position_mm) {
      return glm::distance(position_mm, pen.position_mm) < 1e-9;
    });
    ASSERT_NE(next, raw.end()) << "no report at " << pen.position_mm.x << ' ' << pen.position_mm.y;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Tablet, RealTabletTest,
    ::testing::Values(RealTablet{"DellCanvas", "dell_canvas_pen.evemu", 2, 0},
                      RealTablet{"WacomCintiq12WX", "Wacom Cintiq 12WX.events", 2, 1},
                      RealTablet{"WacomCintiq13HD", "Wacom Cintiq 13HD.events", 38, 9}),
    [](const auto& tested) { return tested.param.test_name; });

/// A pen of a make that nobody knows, so that libinput believes the kernel's description.
DeviceEvent UnknownPen() {
  DeviceEvent added = tests::PenAdded();
  added.facts.vendor = 0x1234;
  added.facts.has_tilt = added.facts.has_distance = added.facts.has_eraser = true;
  return added;
}

/// A line with the pen, with everything that a pen has, and one with the eraser.
Drawing PenAndEraser() {
  Drawing drawing;
  drawing.events.emplace_back(UnknownPen());
  double t_s = 0.25;
  const auto add = [&](Kind kind, Vec2 position_mm, double pressure, double distance,
                       PenTool tool) {
    PenEvent event = Pen(kind, t_s += 0.005, position_mm);
    event.tool = tool;
    event.pressure = pressure;
    event.distance = distance;
    event.tilt_deg = Vec2(position_mm.x / 10, -20);
    drawing.events.emplace_back(event);
  };
  for (const PenTool tool : {PenTool::kPen, PenTool::kEraser}) {
    add(Kind::kProximityIn, {100, 60}, 0, 0.5, tool);
    add(Kind::kMotion, {101, 60.5}, 0, 0.25, tool);
    add(Kind::kDown, {102, 61}, 0.125, 0, tool);
    for (int i = 0; i < 20; ++i) {
      add(Kind::kMotion, {103 + i, 61 + 0.013 * i * i}, 0.5 + 0.02 * i, 0, tool);
    }
    add(Kind::kUp, {123, 66.5}, 0, 0.2, tool);
    add(Kind::kProximityOut, {123, 66.5}, 0, 0.2, tool);
  }
  return drawing;
}

TEST(DrawnPen, ComesThroughLibinputAsItWasDrawn) {
  const Drawing drawn = PenAndEraser();
  const auto seen = PlayThroughLibinput(*tests::EvdevFromDrawing(drawn));
  ASSERT_TRUE(seen) << FormatError(seen.error());
  EXPECT_TRUE(std::get<DeviceEvent>(seen->events.front()).facts.has_eraser);
  const auto expected = PenEventsOf(drawn), pens = PenEventsOf(*seen);
  ASSERT_EQ(pens.size(), expected.size());
  for (size_t i = 0; i < pens.size(); ++i) {
    EXPECT_EQ(pens[i].kind, expected[i].kind) << i;
    EXPECT_EQ(pens[i].tool, expected[i].tool) << i;
    EXPECT_NEAR(pens[i].t_s, expected[i].t_s, 1.5e-6) << i;
    EXPECT_LE(glm::distance(pens[i].position_mm, expected[i].position_mm),
              2 * tests::kPositionError_mm);
    if (pens[i].kind == Kind::kProximityOut) continue;  // the axes of the report before
    ASSERT_TRUE(pens[i].pressure && pens[i].distance && pens[i].tilt_deg) << i;
    EXPECT_NEAR(*pens[i].pressure, *expected[i].pressure, tests::kPressureError) << i;
    EXPECT_NEAR(*pens[i].distance, *expected[i].distance, 0.01) << i;
    EXPECT_LE(glm::distance(*pens[i].tilt_deg, *expected[i].tilt_deg), 0.05) << i;
  }
}

TEST(DrawnPen, HoldingStillDoesNotEndTheStroke) {
  Drawing drawing;
  drawing.events = {UnknownPen(), Pen(Kind::kDown, 0.1, {50, 50}),
                    Pen(Kind::kMotion, 0.2, {60, 50}), Pen(Kind::kMotion, 1.7, {60, 70}),
                    Pen(Kind::kUp, 1.8, {60, 70})};
  const auto seen = PlayThroughLibinput(*tests::EvdevFromDrawing(drawing));
  ASSERT_TRUE(seen) << FormatError(seen.error());
  const auto strokes = StrokesOf(seen->events);
  ASSERT_THAT(strokes, SizeIs(1));
  EXPECT_THAT(strokes[0].samples, SizeIs(3));
  EXPECT_NEAR(strokes[0].samples.back().t_s, 1.7, 1e-5);
}

TEST(DrawnPen, ButtonsCarryTheirCodes) {
  Drawing drawing;
  drawing.events = {UnknownPen(), Pen(Kind::kProximityIn, 0.1, {50, 50})};
  for (const bool pressed : {true, false}) {
    PenEvent button = Pen(Kind::kButton, pressed ? 0.2 : 0.3, {50, 50});
    button.button = BTN_STYLUS2;
    button.pressed = pressed;
    drawing.events.emplace_back(button);
  }
  const auto seen = PlayThroughLibinput(*tests::EvdevFromDrawing(drawing));
  ASSERT_TRUE(seen) << FormatError(seen.error());
  std::vector<PenEvent> buttons;
  for (const PenEvent& pen : PenEventsOf(*seen)) {
    if (pen.kind == Kind::kButton) buttons.push_back(pen);
  }
  ASSERT_THAT(buttons, SizeIs(2));
  EXPECT_EQ(buttons[0].button, static_cast<uint32_t>(BTN_STYLUS2));
  EXPECT_TRUE(buttons[0].pressed);
  EXPECT_FALSE(buttons[1].pressed);
}

TEST(DevicesCommand, ListsATabletOfTheSeatWithItsFacts) {
  const MockTablet tablet(*tests::EvdevFromDrawing(PenAndEraser()));
  const auto json = tablet.Run({PARTI_PROGRAM, "devices", "--json"}, {});
  ASSERT_TRUE(json) << FormatError(json.error());
  EXPECT_EQ(json->status, 0) << json->errors;
  const auto answer = ParseJson(json->output);
  ASSERT_TRUE(answer) << json->output;
  ASSERT_THAT(answer->at("devices"), SizeIs(1));
  const Json& device = answer->at("devices")[0];
  EXPECT_EQ(device.at("node"), tests::kMockNode);
  EXPECT_EQ(device.at("name"), "Test Pen");
  EXPECT_EQ(device.at("vendor"), "1234");
  EXPECT_EQ(device.at("size_mm"), Json({596.0, 335.0}));
  for (const char* axis : {"pen", "pressure", "tilt", "distance", "eraser"}) {
    EXPECT_EQ(device.at(axis), true) << axis;
  }
  EXPECT_EQ(device.at("touch"), false);

  const auto line = tablet.Run({PARTI_PROGRAM, "devices"}, {});
  ASSERT_TRUE(line) << FormatError(line.error());
  EXPECT_EQ(
      line->output,
      "/dev/input/event5  Test Pen (1234:4200): pen, display, pressure, tilt, distance, eraser, "
      "596 x 335 mm\n");
}

TEST(RecordCommand, FailsWhenNothingWasDrawnButEndsItsFile) {
  const MockTablet tablet(*tests::EvdevFromDrawing(PenAndEraser()));
  const std::string out = (tablet.folder() / "out.pen").string();
  const auto outcome = tablet.Run(
      {PARTI_PROGRAM, "record", out, "--device", tests::kMockNode, "--seconds", "0.2"}, {});
  ASSERT_TRUE(outcome) << FormatError(outcome.error());
  EXPECT_EQ(outcome->status, 1);
  EXPECT_THAT(outcome->errors, HasSubstr("no pen and no finger touched anything"));
  EXPECT_FALSE(ReadDrawing(*ReadFile(out)).damage);
}

TEST(RecordCommand, RefusesAFolderThatIsNotThere) {
  const MockTablet tablet(*tests::EvdevFromDrawing(PenAndEraser()));
  const auto outcome = tablet.Run({PARTI_PROGRAM, "record", "/nowhere/out.pen"}, {});
  ASSERT_TRUE(outcome) << FormatError(outcome.error());
  EXPECT_EQ(outcome->status, 1);
  EXPECT_THAT(outcome->errors, HasSubstr("can't write /nowhere/out.pen"));
}

}  // namespace
}  // namespace parti::input
