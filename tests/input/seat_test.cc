// Several devices on one seat, through the real libinput: what comes, goes, and is in the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input.h>

#include "base/text_file.h"
#include "input/gestures.h"
#include "input/palm_arbitration.h"
#include "input/pointer_position.h"
#include "input/strokes_from_events.h"
#include "tests/support/data.h"
#include "tests/support/evdev_from_drawing.h"
#include "tests/support/events.h"
#include "tests/support/mock_seat.h"

namespace parti::input {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using tests::EvdevEvent;
using tests::MockSeat;
using tests::Raw;
using tests::SeatLook;

constexpr int kTablet = 5, kScreen = 6, kMouse = 7, kKeys = 8, kButtons = 10;
// The same tablet plugged in again: umockdev can't use a node's number twice.
constexpr int kTabletAgain = 9;
constexpr int kTabletUnits = 200, kScreenUnits = 40;  // per mm

/// The tablet of evdev_from_drawing.h, with no events.
tests::EvdevRecording Tablet() {
  Drawing drawing;
  drawing.events = {tests::PenAdded()};
  return *tests::EvdevFromDrawing(drawing);
}

void DescribeAll(MockSeat* seat) {
  for (const int number : {kTablet, kTabletAgain}) {
    seat->Describe(Tablet(), {number, {"ID_INPUT_TABLET=1"}});
  }
  seat->Describe(tests::TouchScreen({344, 194}), {kScreen, {"ID_INPUT_TOUCHSCREEN=1"}});
  seat->Describe(tests::Mouse(), {kMouse, {"ID_INPUT_MOUSE=1"}});
  seat->Describe(tests::KeyboardDevice(), {kKeys, {"ID_INPUT_KEYBOARD=1", "ID_INPUT_KEY=1"}});
}

std::vector<EvdevEvent> PenAt(double t_ms, Vec2 mm, int pressure) {
  return {Raw(t_ms, EV_KEY, BTN_TOOL_PEN, 1),
          Raw(t_ms, EV_ABS, ABS_X, static_cast<int>(mm.x * kTabletUnits)),
          Raw(t_ms, EV_ABS, ABS_Y, static_cast<int>(mm.y * kTabletUnits)),
          Raw(t_ms, EV_KEY, BTN_TOUCH, pressure > 0 ? 1 : 0),
          Raw(t_ms, EV_ABS, ABS_PRESSURE, pressure)};
}
std::vector<EvdevEvent> PenGone(double t_ms) {
  return {Raw(t_ms, EV_KEY, BTN_TOUCH, 0), Raw(t_ms, EV_ABS, ABS_PRESSURE, 0),
          Raw(t_ms, EV_KEY, BTN_TOOL_PEN, 0)};
}

std::vector<EvdevEvent> FingerAt(double t_ms, int slot, int id, Vec2 mm) {
  const int x = static_cast<int>(mm.x * kScreenUnits), y = static_cast<int>(mm.y * kScreenUnits);
  return {Raw(t_ms, EV_ABS, ABS_MT_SLOT, slot), Raw(t_ms, EV_ABS, ABS_MT_TRACKING_ID, id),
          Raw(t_ms, EV_ABS, ABS_MT_POSITION_X, x), Raw(t_ms, EV_ABS, ABS_MT_POSITION_Y, y),
          Raw(t_ms, EV_KEY, BTN_TOUCH, 1)};
}
std::vector<EvdevEvent> FingerGone(double t_ms, int slot) {
  return {Raw(t_ms, EV_ABS, ABS_MT_SLOT, slot), Raw(t_ms, EV_ABS, ABS_MT_TRACKING_ID, -1)};
}

/// A look's events of one kind.
template <typename Event>
std::vector<Event> Of(const SeatLook& look) {
  std::vector<Event> events;
  for (const InputEvent& event : look.events) {
    if (const auto* wanted = std::get_if<Event>(&event)) events.push_back(*wanted);
  }
  return events;
}

std::vector<InputEvent> AllOf(const std::vector<SeatLook>& looks) {
  std::vector<InputEvent> events;
  for (const SeatLook& look : looks) {
    events.insert(events.end(), look.events.begin(), look.events.end());
  }
  return events;
}

TEST(Seat, DevicesOfEveryKindSayWhatTheyAre) {
  MockSeat seat;
  DescribeAll(&seat);
  for (const char* plug : {"plug 5", "plug 6", "plug 7", "plug 8"}) seat.Do(plug);
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  std::vector<DeviceFacts> facts;
  for (const InputEvent& event : AllOf(*looks)) facts.push_back(std::get<DeviceEvent>(event).facts);
  ASSERT_THAT(facts, SizeIs(4));
  EXPECT_TRUE(facts[0].has_pen && facts[0].has_pressure && !facts[0].has_touch);
  EXPECT_TRUE(facts[1].has_touch && facts[1].has_display && !facts[1].has_pen);
  EXPECT_EQ(facts[1].size_mm, Vec2(344, 194));
  EXPECT_TRUE(facts[2].has_pointer && !facts[2].has_keys);
  EXPECT_EQ(facts[2].view_px_per_mm, PointerPosition::kViewPxPerMm);
  EXPECT_TRUE(facts[3].has_keys && !facts[3].has_pointer);
}

TEST(Seat, ATabletThatIsUnpluggedInMidStrokeEndsItCleanlyAndGoesOnWhenItIsBack) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("plug 5");
  seat.Send(kTablet, PenAt(0, {50, 50}, 0));
  for (int i = 0; i < 5; ++i) seat.Send(kTablet, PenAt(10 + 5 * i, {50.0 + i, 50}, 4000));
  seat.Do("unplug 5");
  seat.Do("plug 9");
  seat.Send(kTabletAgain, PenAt(500, {60, 50}, 0));
  for (int i = 0; i < 3; ++i) seat.Send(kTabletAgain, PenAt(510 + 5 * i, {60.0 + i, 50}, 4000));
  seat.Send(kTabletAgain, PenGone(600));
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  const auto strokes = StrokesOf(AllOf(*looks));
  ASSERT_THAT(strokes, SizeIs(2));
  EXPECT_EQ(strokes[0].device, 0);
  EXPECT_THAT(strokes[0].samples, SizeIs(5));
  EXPECT_EQ(strokes[1].device, 1);
  EXPECT_THAT(strokes[1].samples, SizeIs(3));
  EXPECT_NE(strokes[0].end, StrokeEnd::kEndOfStream);
  EXPECT_EQ(strokes[1].end, StrokeEnd::kPenUp);
}

TEST(Seat, FingersComeWithTheirPlacesAndGoWhereTheyLastWere) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("plug 6");
  seat.Send(kScreen, FingerAt(0, 0, 1, {100, 50}));
  seat.Send(kScreen, FingerAt(10, 1, 2, {200, 60}));
  seat.Send(kScreen, FingerAt(20, 0, 1, {110, 55}));
  seat.Send(kScreen, FingerGone(30, 0));
  seat.Send(kScreen, FingerGone(40, 1));
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  std::vector<std::tuple<TouchEvent::Kind, int, Vec2>> touches;
  for (const TouchEvent& touch : Of<TouchEvent>({AllOf(*looks), {}})) {
    touches.emplace_back(touch.kind, touch.finger, touch.position_mm);
  }
  using Kind = TouchEvent::Kind;
  EXPECT_THAT(touches, ElementsAre(std::tuple(Kind::kDown, 0, Vec2(100, 50)),
                                   std::tuple(Kind::kDown, 1, Vec2(200, 60)),
                                   std::tuple(Kind::kMotion, 0, Vec2(110, 55)),
                                   std::tuple(Kind::kUp, 0, Vec2(110, 55)),
                                   std::tuple(Kind::kUp, 1, Vec2(200, 60))));
}

/// What fingers do on the screen, as the application sees it: palms kept out, positions in pixels.
std::vector<Gesture> GesturesIn(const std::vector<SeatLook>& looks) {
  constexpr double kPxPerMm = 5;
  PalmArbitration palms;
  Gestures gestures;
  std::vector<Gesture> made;
  const auto feed = [&](const TouchEvent& touch) {
    for (auto& g : gestures.Feed({touch, touch.position_mm * kPxPerMm, kPxPerMm}))
      made.push_back(g);
  };
  for (const InputEvent& event : AllOf(looks)) {
    const Passage passage = palms.Feed(event);
    for (const TouchEvent& cancelled : passage.cancelled) feed(cancelled);
    const auto* touch = std::get_if<TouchEvent>(&event);
    if (touch && passage.passes) feed(*touch);
  }
  return made;
}

DragPhase PhaseOf(const Gesture& gesture) { return std::get<OrbitGesture>(gesture).phase; }

TEST(Seat, APalmThatCameBeforeThePenIsTakenBackWhenThePenComes) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("plug 5");
  seat.Do("plug 6");
  for (int i = 0; i < 10; ++i) seat.Send(kScreen, FingerAt(20 * i, 0, 1, {100.0 + 2 * i, 50}));
  seat.Do("wait 0");
  seat.Send(kTablet, PenAt(210, {50, 50}, 0));
  seat.Do("wait 0");
  seat.Send(kScreen, FingerAt(220, 0, 1, {140, 50}));
  seat.Do("wait 0");
  for (int i = 0; i < 5; ++i) seat.Send(kTablet, PenAt(230 + 5 * i, {50.0 + i, 50}, 4000));
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  const auto made = GesturesIn(*looks);
  ASSERT_FALSE(made.empty());
  EXPECT_EQ(PhaseOf(made.front()), DragPhase::kBegin);
  EXPECT_EQ(PhaseOf(made.back()), DragPhase::kCancel);
  EXPECT_THAT(StrokesOf(AllOf(*looks)), SizeIs(1));
}

TEST(Seat, APalmUnderThePenDoesNothingAndAFingerAfterItOrbits) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("plug 5");
  seat.Do("plug 6");
  seat.Send(kTablet, PenAt(0, {50, 50}, 0));
  seat.Do("wait 0");
  for (int i = 0; i < 10; ++i) seat.Send(kScreen, FingerAt(10 + 20 * i, 0, 1, {100.0 + 2 * i, 50}));
  seat.Send(kScreen, FingerGone(230, 0));
  seat.Do("wait 0");
  seat.Send(kTablet, PenGone(240));
  const auto without = [&] {
    const auto looks = seat.Run();
    EXPECT_TRUE(looks) << FormatError(looks.error());
    return GesturesIn(*looks);
  };
  EXPECT_THAT(without(), IsEmpty());
  seat.Do("wait 0");
  for (int i = 0; i < 10; ++i)
    seat.Send(kScreen, FingerAt(900 + 20 * i, 0, 2, {100.0 + 2 * i, 50}));
  const auto with = without();
  ASSERT_FALSE(with.empty());
  EXPECT_EQ(PhaseOf(with.front()), DragPhase::kBegin);
}

TEST(Seat, TwoFingersThatTapAreTwoFingersThatTap) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("plug 6");
  seat.Send(kScreen, FingerAt(0, 0, 1, {100, 50}));
  seat.Send(kScreen, FingerAt(15, 1, 2, {120, 50}));
  seat.Send(kScreen, FingerGone(90, 0));
  seat.Send(kScreen, FingerGone(95, 1));
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  EXPECT_THAT(GesturesIn(*looks), ElementsAre(Gesture(TapGesture{2, {550, 250}})));
}

TEST(Seat, ATouchScreenThatIsUnpluggedLiftsItsFingers) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("plug 6");
  for (int i = 0; i < 10; ++i) seat.Send(kScreen, FingerAt(20 * i, 0, 1, {100.0 + 2 * i, 50}));
  seat.Do("unplug 6");
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  const auto made = GesturesIn(*looks);
  ASSERT_FALSE(made.empty());
  EXPECT_NE(PhaseOf(made.back()), DragPhase::kMove);
}

TEST(Seat, AMouseMovesDrawsAndZooms) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("view 1000 600 1");
  seat.Do("plug 7");
  seat.Send(kMouse, {Raw(0, EV_REL, REL_X, 10)});
  seat.Send(kMouse, {Raw(300, EV_KEY, BTN_LEFT, 1)});
  seat.Send(kMouse, {Raw(600, EV_REL, REL_X, 5000)});
  seat.Send(kMouse, {Raw(900, EV_KEY, BTN_LEFT, 0)});
  seat.Send(kMouse, {Raw(1200, EV_KEY, BTN_MIDDLE, 1)});
  seat.Send(kMouse, {Raw(1500, EV_KEY, BTN_MIDDLE, 0)});
  seat.Send(kMouse, {Raw(1800, EV_REL, REL_WHEEL, 1)});
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  const SeatLook& look = looks->back();
  const auto reports = Of<PenEvent>(look);
  ASSERT_THAT(reports, SizeIs(6));
  using Kind = PenEvent::Kind;
  EXPECT_EQ(reports[0].kind, Kind::kMotion);
  EXPECT_GT(reports[0].position_mm.x * PointerPosition::kViewPxPerMm, 500);
  EXPECT_EQ(reports[1].kind, Kind::kDown);
  EXPECT_EQ(reports[2].position_mm.x * PointerPosition::kViewPxPerMm, 1000);  // the view's edge
  EXPECT_EQ(reports[3].kind, Kind::kUp);
  EXPECT_EQ(reports[4].button, static_cast<uint32_t>(BTN_MIDDLE));
  for (const PenEvent& report : reports) EXPECT_EQ(report.tool, PenTool::kMouse);
  const auto scrolls = Of<ScrollEvent>(look);
  ASSERT_THAT(scrolls, SizeIs(1));
  EXPECT_EQ(scrolls[0].steps, Vec2(0, -1));  // away from the user
  EXPECT_THAT(StrokesOf(look.events), SizeIs(1));
}

TEST(Seat, ALeftHandedMouseDrawsWithItsRightButton) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("left-handed 1");
  seat.Do("plug 7");
  seat.Send(kMouse, {Raw(0, EV_KEY, BTN_RIGHT, 1)});
  seat.Send(kMouse, {Raw(300, EV_KEY, BTN_RIGHT, 0)});
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  EXPECT_THAT(StrokesOf(looks->back().events), SizeIs(1));
}

/// What comes of a key that is held for long enough to repeat, and let go, while another is down.
std::vector<KeyEvent> Holding(int modifier, int key, const std::string& layout) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.SetLayout(layout);
  seat.Do("plug 8");
  seat.Do("ahead 0");
  seat.Send(kKeys, {Raw(0, EV_KEY, modifier, 1)});
  seat.Send(kKeys, {Raw(1, EV_KEY, key, 1)});
  seat.Do("wait 0.65");
  seat.Send(kKeys, {Raw(700, EV_KEY, key, 0)});
  seat.Do("wait 0.2");
  const auto looks = seat.Run();
  EXPECT_TRUE(looks) << FormatError(looks.error());
  return looks ? Of<KeyEvent>({AllOf(*looks), {}}) : std::vector<KeyEvent>();
}

TEST(Seat, KeysTypeAndRepeatWhileTheyAreHeld) {
  const auto keys = Holding(KEY_LEFTSHIFT, KEY_P, "us");
  ASSERT_GE(keys.size(), 4u);
  EXPECT_EQ(keys[0].code, static_cast<uint32_t>(KEY_LEFTSHIFT));
  EXPECT_EQ(keys[1].text, "P");
  EXPECT_FALSE(keys[1].repeat);
  for (size_t i = 2; i + 1 < keys.size(); ++i) {
    EXPECT_TRUE(keys[i].repeat && keys[i].pressed);
    EXPECT_EQ(keys[i].text, "P");
  }
  EXPECT_FALSE(keys.back().pressed);
}

TEST(Seat, PowerAndVolumeButtonsAreNoKeyboard) {
  const std::vector<int> number_pad = {KEY_KP1, KEY_KP2, KEY_KP3, KEY_KP4, KEY_KP5,    KEY_KP6,
                                       KEY_KP7, KEY_KP8, KEY_KP9, KEY_KP0, KEY_KPENTER};
  for (const auto& buttons : {tests::KeysOnly("Power Button", {KEY_POWER}),
                              tests::KeysOnly("Video Bus", {KEY_BRIGHTNESSUP, KEY_BRIGHTNESSDOWN}),
                              tests::KeysOnly("gpio-keys", {KEY_VOLUMEUP, KEY_VOLUMEDOWN}),
                              tests::KeysOnly("Mocked Number Pad", number_pad)}) {
    MockSeat seat;
    seat.Describe(buttons, {kButtons, {"ID_INPUT_KEY=1"}});
    seat.Do("plug 10");
    const auto looks = seat.Run();
    ASSERT_TRUE(looks) << FormatError(looks.error());
    const auto devices = Of<DeviceEvent>({AllOf(*looks), {}});
    ASSERT_THAT(devices, SizeIs(1)) << buttons.name;
    EXPECT_FALSE(devices[0].facts.has_keys) << buttons.name;
  }
}

TEST(Seat, APadOfNumbersTypesThoughItIsNoKeyboard) {
  MockSeat seat;
  seat.Describe(tests::KeysOnly("Mocked Number Pad", {KEY_1, KEY_2, KEY_3}),
                {kButtons, {"ID_INPUT_KEY=1"}});
  seat.Do("plug 10");
  seat.Send(kButtons, {Raw(0, EV_KEY, KEY_2, 1)});
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  const auto keys = Of<KeyEvent>({AllOf(*looks), {}});
  ASSERT_THAT(keys, SizeIs(1));
  EXPECT_EQ(keys[0].text, "2");
}

TEST(Seat, KeysGoByTheLettersOfTheLayout) {
  const auto keys = Holding(KEY_LEFTCTRL, KEY_Y, "de");  // z is printed on it
  ASSERT_GE(keys.size(), 4u);
  EXPECT_EQ(keys[0].code, static_cast<uint32_t>(KEY_LEFTCTRL));
  for (size_t i = 1; i < keys.size(); ++i) {
    EXPECT_EQ(keys[i].code, static_cast<uint32_t>(KEY_Z));
    EXPECT_EQ(keys[i].repeat, i > 1 && i + 1 < keys.size()) << "until it is released";
  }
  EXPECT_FALSE(keys.back().pressed);
}

TEST(Seat, TheKeyboardThatIsFoldedUnderTheScreenIsSilent) {
  constexpr int kFold = 10, kOwnKeys = 11;
  tests::EvdevRecording own_keys = tests::KeyboardDevice(), fold;
  own_keys.bus = BUS_I8042;  // which libinput takes for the computer's own
  fold.name = "Mocked Tablet Mode Switch";
  fold.codes[EV_SYN] = {};
  fold.SetCode(EV_SW, SW_TABLET_MODE);
  MockSeat seat;
  seat.Describe(fold, {kFold, {"ID_INPUT_SWITCH=1"}});
  seat.Describe(own_keys, {kOwnKeys, {"ID_INPUT_KEYBOARD=1", "ID_INPUT_KEY=1"}});
  seat.Do("plug 10");
  seat.Do("plug 11");
  seat.Send(kOwnKeys, {Raw(0, EV_KEY, KEY_P, 1), Raw(10, EV_KEY, KEY_P, 0)});
  seat.Send(kFold, {Raw(100, EV_SW, SW_TABLET_MODE, 1)});
  seat.Do("wait 0.1");
  seat.Send(kOwnKeys, {Raw(300, EV_KEY, KEY_Q, 1), Raw(310, EV_KEY, KEY_Q, 0)});
  seat.Do("wait 0.1");
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  std::vector<uint32_t> pressed;
  for (const KeyEvent& key : Of<KeyEvent>({AllOf(*looks), {}})) {
    if (key.pressed) pressed.push_back(key.code);
  }
  EXPECT_THAT(pressed, ElementsAre(KEY_P)) << "what a palm presses there is nobody's";
  EXPECT_THAT(Of<DeviceEvent>({AllOf(*looks), {}}), SizeIs(1)) << "the switch itself is no device";
}

TEST(Seat, SuspendingEndsTheStrokeAndResumingBringsTheDevicesBack) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("plug 5");
  seat.Send(kTablet, PenAt(0, {50, 50}, 0));
  for (int i = 0; i < 5; ++i) seat.Send(kTablet, PenAt(10 + 5 * i, {50.0 + i, 50}, 4000));
  seat.Do("suspend");
  seat.Do("resume");
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  const auto strokes = StrokesOf(AllOf(*looks));
  ASSERT_THAT(strokes, SizeIs(1));
  EXPECT_NE(strokes[0].end, StrokeEnd::kEndOfStream);
  const auto back = Of<DeviceEvent>(looks->back());
  ASSERT_THAT(back, SizeIs(1));
  EXPECT_EQ(back[0].kind, DeviceEvent::Kind::kAdded);
  EXPECT_EQ(back[0].device, 1);
}

TEST(Seat, ADeviceThatMayNotBeOpenedIsSaidWithItsRemedy) {
  MockSeat seat;
  DescribeAll(&seat);
  seat.Do("deny 5");
  seat.Do("plug 5");
  seat.Do("why");
  seat.Do("plug 9");
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  ASSERT_THAT(*looks, SizeIs(4));
  EXPECT_THAT((*looks)[1].events, IsEmpty());
  ASSERT_THAT((*looks)[2].words, SizeIs(2));
  EXPECT_THAT((*looks)[2].words[0], HasSubstr("can't open /dev/input/event5: Permission denied"));
  EXPECT_THAT((*looks)[2].words[1], HasSubstr("usermod -aG input"));
  EXPECT_THAT(Of<DeviceEvent>(looks->back()), SizeIs(1));
}

TEST(Seat, CalibrationOfTheSystemIsApplied) {
  MockSeat seat;
  seat.Describe(tests::TouchScreen({344, 194}),
                {kScreen, {"ID_INPUT_TOUCHSCREEN=1", "LIBINPUT_CALIBRATION_MATRIX=-1 0 1 0 -1 1"}});
  seat.Do("plug 6");
  seat.Send(kScreen, FingerAt(0, 0, 1, {100, 50}));
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  const auto touches = Of<TouchEvent>(looks->back());
  ASSERT_THAT(touches, SizeIs(1));
  EXPECT_LT(glm::distance(touches[0].position_mm, Vec2(244, 144)), 0.06);
}

TEST(Seat, AScreenThatDoesNotSayItsSizeIsOfTheUsualOne) {
  auto screen = tests::TouchScreen({344, 194});
  for (auto& [code, axis] : screen.axes) axis.resolution = 0;
  MockSeat seat;
  seat.Describe(screen, {kScreen, {"ID_INPUT_TOUCHSCREEN=1"}});
  seat.Do("plug 6");
  seat.Send(kScreen, FingerAt(0, 0, 1, {172, 97}));
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  EXPECT_EQ(Of<DeviceEvent>((*looks)[0]).at(0).facts.size_mm, std::nullopt);
  const auto touches = Of<TouchEvent>(looks->back());
  ASSERT_THAT(touches, SizeIs(1));
  EXPECT_LT(glm::distance(touches[0].position_mm, kUsualSize_mm * 0.5), 0.05);
}

/// A recording up to the middle of its first stroke of 100 reports.
std::vector<EvdevEvent> CutInMidStroke(const std::vector<EvdevEvent>& events) {
  constexpr int kWhole = 100, kCut = 60;
  std::vector<EvdevEvent> cut;
  size_t middle = 0;
  int reports = -1;  // of the stroke
  for (const EvdevEvent& event : events) {
    if (event.type == EV_KEY && event.code == BTN_TOUCH) reports = event.value == 1 ? 0 : -1;
    cut.push_back(event);
    if (event.type != EV_SYN || reports < 0) continue;
    if (++reports == kCut) middle = cut.size();
    if (reports == kWhole) break;
  }
  cut.resize(middle);
  return cut;
}

/// Tablets that are made, each beside a touch screen of ours: a stroke is cut, and goes on.
class RealTabletOnASeat : public ::testing::TestWithParam<const char*> {};

TEST_P(RealTabletOnASeat, IsUnpluggedInMidStrokeAndGoesOn) {
  PARTI_NEED_DATA(path, std::string("tablets/") + GetParam());
  auto recording = *tests::ReadEvemu(*ReadFile(path), path);
  tests::AssumeResolution(kTabletUnits, &recording);
  MockSeat seat;
  for (const int number : {kTablet, kTabletAgain}) {
    seat.Describe(recording, {number, {"ID_INPUT_TABLET=1"}});
  }
  seat.Describe(tests::TouchScreen({344, 194}), {kScreen, {"ID_INPUT_TOUCHSCREEN=1"}});
  seat.Do("plug 6");
  seat.Do("plug 5");
  std::vector<EvdevEvent> cut = CutInMidStroke(recording.events);
  seat.Play(kTablet, cut);
  seat.Do("unplug 5");
  seat.Do("plug 9");
  for (EvdevEvent& event : cut) event.t_us += 100'000'000;
  seat.Play(kTabletAgain, cut);
  const auto looks = seat.Run();
  ASSERT_TRUE(looks) << FormatError(looks.error());
  const auto strokes = StrokesOf(AllOf(*looks));
  ASSERT_TRUE(!strokes.empty() && strokes.size() % 2 == 0) << strokes.size();
  const size_t half = strokes.size() / 2;
  for (size_t i = 0; i < half; ++i) {
    EXPECT_EQ(strokes[i].device, 1);
    EXPECT_EQ(strokes[i + half].device, 2);
    EXPECT_EQ(strokes[i].samples.size(), strokes[i + half].samples.size());
  }
  EXPECT_NE(strokes[half - 1].end, StrokeEnd::kEndOfStream);
  EXPECT_EQ(strokes.back().end, StrokeEnd::kEndOfStream);
}

INSTANTIATE_TEST_SUITE_P(Seat, RealTabletOnASeat,
                         ::testing::Values("dell_canvas_pen.evemu", "Wacom Cintiq 12WX.events",
                                           "Wacom Cintiq 13HD.events"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           for (char& c : name) c = std::isalnum(c) != 0 ? c : '_';
                           return name;
                         });

}  // namespace
}  // namespace parti::input
