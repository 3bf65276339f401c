#include "input/drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "base/text_file.h"
#include "tests/support/data.h"
#include "tests/support/events.h"

namespace parti::input {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using tests::ArbitraryDrawing;
using tests::Pen;
using tests::PenAdded;
using tests::StrokeEvents;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A drawing with something of everything.
constexpr const char* kExample = R"(parti-drawing 1
# a lot, one line on it, the first suggestion
device 0 added 0 name="Wacom ISD-V4 Pen" vendor=056a product=4200 size_mm=596.74,335.66 pen pressure tilt eraser
after 0: lot rect(20,15)
pen 0 in 0.81 120.5,60.25 p=0 d=0.5 tilt=12,-3
pen 0 down 0.815 120.5,60.25 p=0.12 d=0 tilt=12,-3
pen 0 move 0.82 121,61.5 p=0.31 d=0 tilt=12,-3
pen 0 up 0.825 121,61.5 p=0 d=0 tilt=12,-3
after 1: pick 1
pen 0 button 1.2 121,61.5 button=331 pressed
touch 0 down 1.25 300,200 finger=0
key 0 press 1.3 30
pen 0 out 1.9 121,61.5 tool=eraser
device 0 removed 2 name="Wacom ISD-V4 Pen" vendor=056a product=4200 size_mm=596.74,335.66 pen pressure tilt eraser
end
)";

/// The example with `line` put in before its last line, and what reading it says.
DrawingReading WithLine(const std::string& line) {
  std::string text = kExample;
  text.insert(text.rfind("device 0 removed"), line + "\n");
  return ReadDrawing(text, "some.pen");
}

TEST(Drawing, ExampleIsReadWhole) {
  const DrawingReading reading = ReadDrawing(kExample, "house.pen");
  ASSERT_FALSE(reading.damage) << FormatError(*reading.damage);
  EXPECT_THAT(reading.drawing.events, SizeIs(10));
  ASSERT_THAT(reading.drawing.commands, SizeIs(2));
  const DrawingCommand& lot = reading.drawing.commands[0];
  EXPECT_EQ(lot.after_stroke, 0);
  EXPECT_EQ(lot.text, "lot rect(20,15)");
  EXPECT_EQ(lot.place.file, "house.pen");
  EXPECT_EQ(lot.place.line, 4);
  EXPECT_EQ(lot.place.column, 10);
  EXPECT_EQ(lot.place.line_text, "after 0: lot rect(20,15)");
  PenEvent down = Pen(PenEvent::Kind::kDown, 0.815, {120.5, 60.25});
  down.pressure = 0.12;
  down.distance = 0;
  down.tilt_deg = Vec2(12, -3);
  EXPECT_EQ(reading.drawing.events[2], InputEvent(down));
  EXPECT_EQ(std::get<PenEvent>(reading.drawing.events[8]).tool, PenTool::kEraser);
}

TEST(Drawing, ExampleOfTheDocumentationIsReadWhole) {
  const std::string page = *ReadFile(tests::SourceFile("docs/drawings.md"));
  const size_t start = page.find("```\n") + 4;
  const std::string example = page.substr(start, page.find("```", start) - start);
  const DrawingReading reading = ReadDrawing(example, "docs/drawings.md");
  EXPECT_FALSE(reading.damage) << FormatError(*reading.damage);
  EXPECT_THAT(reading.drawing.events, SizeIs(6));
  EXPECT_THAT(reading.drawing.commands, SizeIs(2));
}

TEST(Drawing, MiceAndKeyboardsAreReadWithAllTheySay) {
  const DrawingReading reading = ReadDrawing(
      "parti-drawing 1\n"
      "device 0 added 0 name=\"Mouse\" vendor=046d product=c077 view_px_per_mm=3.5 pointer\n"
      "device 1 added 0 name=\"Keys\" vendor=046d product=c31c keys\n"
      "pen 0 down 1 10,20 tool=mouse\n"
      "scroll 0 wheel 2 10,20 0.5,-1\n"
      "key 1 press 3 18 text=\"é\\\"\" repeat\n"
      "end\n");
  ASSERT_FALSE(reading.damage) << FormatError(*reading.damage);
  const auto& events = reading.drawing.events;
  ASSERT_THAT(events, SizeIs(5));
  const DeviceFacts& mouse = std::get<DeviceEvent>(events[0]).facts;
  EXPECT_TRUE(mouse.has_pointer);
  EXPECT_EQ(mouse.view_px_per_mm, 3.5);
  EXPECT_TRUE(std::get<DeviceEvent>(events[1]).facts.has_keys);
  EXPECT_EQ(std::get<PenEvent>(events[2]).tool, PenTool::kMouse);
  EXPECT_EQ(events[3], InputEvent(ScrollEvent{0, 2, {10, 20}, {0.5, -1}}));
  EXPECT_EQ(events[4], InputEvent(KeyEvent{1, 3, 18, true, "é\"", true}));
}

TEST(Drawing, CarriageReturnsOfOtherSystemsAreNoDamage) {
  std::string text;
  for (const char c : std::string(kExample)) text += c == '\n' ? "\r\n" : std::string(1, c);
  const DrawingReading reading = ReadDrawing(text);
  EXPECT_FALSE(reading.damage);
  EXPECT_TRUE(reading.drawing == ReadDrawing(kExample).drawing);
}

RC_GTEST_PROP(Drawing, Property1_WhatIsWrittenIsReadBack, ()) {
  const Drawing drawing = *ArbitraryDrawing();
  const auto text = WriteDrawing(drawing);
  RC_ASSERT(text.has_value());
  const DrawingReading reading = ReadDrawing(*text);
  RC_ASSERT(!reading.damage);
  RC_ASSERT(reading.drawing == drawing);
  RC_ASSERT(*WriteDrawing(reading.drawing) == *text);
}

RC_GTEST_PROP(Drawing, Property2_AnyPrefixGivesAPrefixAndSaysSo, ()) {
  const Drawing drawing = *ArbitraryDrawing();
  const std::string text = *WriteDrawing(drawing);
  const auto bytes = *rc::gen::inRange<size_t>(0, text.size() - 1);  // "end" may lack its newline
  const DrawingReading reading = ReadDrawing(text.substr(0, bytes), "cut.pen");
  RC_ASSERT(reading.damage.has_value());
  RC_ASSERT(reading.damage->place.has_value());
  const auto& [events, commands] = reading.drawing;
  RC_ASSERT(events.size() <= drawing.events.size());
  RC_ASSERT(std::equal(events.begin(), events.end(), drawing.events.begin()));
  RC_ASSERT(commands.size() <= drawing.commands.size());
  for (size_t i = 0; i < commands.size(); ++i) {
    RC_ASSERT(commands[i].text == drawing.commands[i].text);
  }
}

TEST(Drawing, OnlyAWrongHeaderGivesNothing) {
  for (const char* text : {"", "\n", "parti", "PNG\x1a", "# parti-drawing 1\n"}) {
    const DrawingReading reading = ReadDrawing(text, "x.pen");
    ASSERT_TRUE(reading.damage);
    EXPECT_EQ(reading.damage->code, ErrorCode::kBadText);
    EXPECT_THAT(FormatError(*reading.damage), HasSubstr("x.pen:"));
    EXPECT_THAT(reading.damage->hint, HasSubstr("parti-drawing 1"));
    EXPECT_THAT(reading.drawing.events, IsEmpty());
  }
}

TEST(Drawing, AnotherVersionSaysToUseAnotherParti) {
  const DrawingReading reading = ReadDrawing("parti-drawing 2\nend\n");
  ASSERT_TRUE(reading.damage);
  EXPECT_THAT(reading.damage->message, HasSubstr("another version"));
}

TEST(Drawing, CutInAStrokeSaysWhichAndKeepsIt) {
  std::string text = kExample;
  text.resize(text.find("pen 0 up"));
  const DrawingReading reading = ReadDrawing(text, "cut.pen");
  ASSERT_TRUE(reading.damage);
  EXPECT_EQ(reading.damage->code, ErrorCode::kDamagedFile);
  EXPECT_THAT(FormatError(*reading.damage),
              HasSubstr("cut.pen:7:47: error: the drawing is cut off"));
  EXPECT_THAT(reading.damage->message, HasSubstr("stroke 1 is not complete"));
  EXPECT_THAT(reading.drawing.events, SizeIs(4));
}

TEST(Drawing, LineThatIsCutIsNotTakenForAWholeOne) {
  std::string text = kExample;
  text.resize(text.find("61.5 p=0.31"));  // the position would read 121 and nothing
  text += "61";                           // and now it reads as a position, but a wrong one
  const DrawingReading reading = ReadDrawing(text, "cut.pen");
  ASSERT_TRUE(reading.damage);
  EXPECT_THAT(reading.damage->message, HasSubstr("cut off within this line"));
  EXPECT_EQ(reading.damage->place->line, 7);
  EXPECT_THAT(reading.drawing.events, SizeIs(3));
}

TEST(Drawing, TextAfterTheEndIsDamageButLosesNothing) {
  const DrawingReading reading = ReadDrawing(std::string(kExample) + "\npen 0 up 3 1,1\n");
  ASSERT_TRUE(reading.damage);
  EXPECT_THAT(reading.damage->message, HasSubstr("after the drawing's end"));
  EXPECT_THAT(reading.drawing.events, SizeIs(10));
}

struct BadLine {
  const char* line;
  int column;
  const char* message;
};

class DamagedLine : public ::testing::TestWithParam<BadLine> {};

TEST_P(DamagedLine, IsNamedWithItsPlaceAndWhatCameBeforeIsKept) {
  const auto& [line, column, message] = GetParam();
  const DrawingReading reading = WithLine(line);
  ASSERT_TRUE(reading.damage);
  EXPECT_EQ(reading.damage->code, ErrorCode::kDamagedFile);
  EXPECT_THAT(reading.damage->message, HasSubstr(message));
  EXPECT_FALSE(reading.damage->hint.empty());
  ASSERT_TRUE(reading.damage->place);
  EXPECT_EQ(reading.damage->place->file, "some.pen");
  EXPECT_EQ(reading.damage->place->line, 14);
  EXPECT_EQ(reading.damage->place->column, column);
  EXPECT_EQ(reading.damage->place->line_text, line);
  EXPECT_THAT(reading.drawing.events, SizeIs(9));
  EXPECT_THAT(reading.drawing.commands, SizeIs(2));
}

INSTANTIATE_TEST_SUITE_P(
    Drawing, DamagedLine,
    ::testing::Values(BadLine{"pencil 0 in 2 1,1", 1, "unknown kind of line"},
                      BadLine{"pen", 4, "the device's number is missing"},
                      BadLine{"pen 0 fly 2 1,1", 7, "unknown kind of event"},
                      BadLine{"pen 0 move 2", 13, "the position is missing"},
                      BadLine{"pen 0 move nan 1,1", 12, "not a finite number"},
                      BadLine{"pen 0 move 2 inf,1", 14, "not a finite number"},
                      BadLine{"pen 0 move 2 1,1e999", 16, "not a finite number"},
                      BadLine{"pen 0 move 2 1;1", 14, "not two numbers"},
                      BadLine{"pen 0 move 2 1,1x", 16, "not a number"},
                      BadLine{"pen 0 move 1 1,1", 1, "time runs backwards"},
                      BadLine{"pen 0 move -1 1,1", 1, "the time [s] is -1"},
                      BadLine{"pen 0 move 1e8 1,1", 1, "the time [s] is"},
                      BadLine{"pen 0 move 2 1e9,1", 1, "a position [mm]"},
                      BadLine{"pen 0 move 2 1,1 p=1.5", 1, "the pressure is 1.5"},
                      BadLine{"pen 0 move 2 1,1 d=-0.1", 1, "the distance is"},
                      BadLine{"pen 0 move 2 1,1 tilt=0,91", 1, "a tilt [deg] is 91"},
                      BadLine{"pen 0 move 2 1,1 p=0.5 p=0.5", 24, "p is given twice"},
                      BadLine{"pen 0 move 2 1,1 q=0.5", 18, "unknown pen axis"},
                      BadLine{"pen 0 move 2 1,1 p", 18, "unknown pen axis"},
                      BadLine{"pen 0 move 2 1,1 tool=brick", 23, "unknown tool"},
                      BadLine{"pen 1 move 2 1,1", 1, "there is no device 1"},
                      BadLine{"pen -1 move 2 1,1", 5, "not a whole number"},
                      BadLine{"pen 0 button 2 1,1 button=70000", 1, "a button's code"},
                      BadLine{"touch 0 down 2 1,1 finger=x", 27, "not a whole number"},
                      BadLine{"key 0 press 2 30 31", 18, "unknown fact of a key"},
                      BadLine{"key 0 press 2 30 text=\"\xc3\"", 1, "not UTF-8"},
                      BadLine{"key 0 press 2 30 text=a", 23, "not a text in double quotes"},
                      BadLine{"key 0 press 2 30 repeat repeat", 25, "repeat is given twice"},
                      BadLine{"scroll 0 wheel 2 1,1", 21, "the number of steps is missing"},
                      BadLine{"scroll 0 wheel 2 1,1 0,2000", 1, "a wheel's steps"},
                      BadLine{"scroll 0 wheel 2 1,1 0,1 0,1", 26, "words after the steps"},
                      BadLine{"scroll 0 spin 2 1,1 0,1", 10, "unknown kind of event"},
                      BadLine{"device 1 added 2 view_px_per_mm=0", 1, "a view's pixels per mm"},
                      BadLine{"device 0 added 2", 1, "added out of turn"},
                      BadLine{"device 7 added 2", 1, "added out of turn"},
                      BadLine{"device 1 added 2 name=Pen", 23, "not a text in double quotes"},
                      BadLine{"device 1 added 2 name=\"Pen", 23, "not a text in double quotes"},
                      BadLine{"device 1 added 2 name=\"P\\q\"", 23, "not a text in double quotes"},
                      BadLine{"device 1 added 2 vendor=0x56a", 25, "not a hexadecimal number"},
                      BadLine{"device 1 added 2 size_mm=-1,2", 1, "a device's size"},
                      BadLine{"device 1 added 2 wheels", 18, "unknown device fact"},
                      BadLine{"after 1 pick 1", 7, "without a colon"},
                      BadLine{"after one: pick 1", 7, "not a whole number"},
                      BadLine{"after 2: pick 1", 1,
                              "after stroke 2 stands where 1 strokes are complete"},
                      BadLine{"after 1:   ", 1, "a command without words"},
                      BadLine{"end of it", 5, "words after `end`"}));

TEST(Drawing, LineOfAnySizeIsRefusedWithoutShowingItAll) {
  const DrawingReading reading = WithLine("after 1: " + std::string(1 << 24, 'x'));
  ASSERT_TRUE(reading.damage);
  EXPECT_THAT(reading.damage->message, HasSubstr("a line of 16777225 bytes"));
  EXPECT_LT(FormatError(*reading.damage).size(), 1000u);
}

TEST(WriteDrawing, RefusesWhatTheReaderWouldCallDamage) {
  using Kind = PenEvent::Kind;
  const auto error = [](std::vector<InputEvent> events, std::vector<DrawingCommand> commands = {}) {
    const auto text = WriteDrawing({std::move(events), std::move(commands)});
    return text ? "written" : text.error().message;
  };
  EXPECT_THAT(error({PenAdded(), Pen(Kind::kMotion, kNaN, {1, 1})}),
              HasSubstr("the time [s] is nan"));
  EXPECT_THAT(error({PenAdded(), Pen(Kind::kMotion, 1, {1, kNaN})}), HasSubstr("is nan"));
  EXPECT_THAT(error({Pen(Kind::kMotion, 1, {1, 1})}), HasSubstr("there is no device 0"));
  EXPECT_THAT(error({PenAdded()}, {{1, "pick 1", {}}}), HasSubstr("no place for the command"));
  EXPECT_THAT(error({PenAdded()}, {{0, "pick 1\nend", {}}}), HasSubstr("line break"));
  EXPECT_THAT(error({PenAdded()}, {{0, std::string(1 << 23, 'x'), {}}}),
              HasSubstr("8388608 bytes"));
  auto strokes = StrokeEvents("0,0 1,1", 0.5);
  strokes.insert(strokes.begin(), PenAdded());
  EXPECT_THAT(error(strokes, {{1, "pick 1", {}}, {0, "lot rect(1,1)", {}}}),
              HasSubstr("no place for the command after stroke 0"));
}

TEST(WriteDrawing, TakesTheTextOfALongRuleFile) {
  const std::string text = "rule-text " + std::string(1'000'000, 'x');
  const auto written = WriteDrawing({{PenAdded()}, {{0, text, {}}}});
  ASSERT_TRUE(written);
  const DrawingReading reading = ReadDrawing(*written);
  EXPECT_FALSE(reading.damage);
  ASSERT_EQ(reading.drawing.commands.size(), 1u);
  EXPECT_EQ(reading.drawing.commands[0].text, text);
}

TEST(WriteDrawing, PutsEachCommandRightAfterItsStroke) {
  Drawing drawing;
  drawing.events = StrokeEvents("0,0 1,1", 0.5);
  drawing.events.insert(drawing.events.begin(), PenAdded());
  drawing.commands = {{0, "lot rect(20,15)", {}}, {1, "pick 1", {}}};
  const std::string text = *WriteDrawing(drawing);
  EXPECT_THAT(text, HasSubstr("parti-drawing 1\nafter 0: lot rect(20,15)\ndevice 0 added"));
  EXPECT_THAT(text, HasSubstr("pen 0 up 0.52 1,1\nafter 1: pick 1\npen 0 out"));
}

}  // namespace
}  // namespace parti::input
