// The whole application on a display in memory: events in, rules, documents and pixels out.
#include "app/application.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include <sstream>

#include "app/document.h"
#include "app/play.h"
#include "app/replay.h"
#include "base/text_file.h"
#include "grammar/query.h"
#include "tests/app/application_driver.h"
#include "tests/support/data.h"
#include "tests/support/golden.h"

namespace parti::app::tests {
namespace {

using parti::tests::Compare;
using parti::tests::ExpectGolden;
using parti::tests::SourceFile;
using testing::HasSubstr;
using testing::IsEmpty;

class ApplicationTest : public ApplicationDriver {};

TEST_F(ApplicationTest, ALineUpFromTheLotAndATapOnItsSuggestionMakeABuilding) {
  PlugIn();
  Do("lot rect(20,14)");
  Do("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000");
  Line(Pixel({0, 0, 14}), Pixel({0, 9, 14}));
  ASSERT_THAT(state().sketch.suggestions, testing::Not(IsEmpty()));
  TapOn("Suggestions/1 ");
  EXPECT_THAT(grammar::TextOf(state().model.trees()), HasSubstr("extrude"));
  EXPECT_THAT(state().sketch.strokes, IsEmpty());
}

TEST_F(ApplicationTest, TheDemoGivesTheSameRulesAsItsReplay) {
  const auto text = ReadFile(SourceFile("assets/drawings/house.pen"));
  ASSERT_TRUE(text);
  const input::Drawing drawing = input::ReadDrawing(*text).drawing;
  const auto played = Play(drawing, application_.get());
  ASSERT_TRUE(played) << FormatError(played.error());
  Settle();
  Session session;
  ReplayReport report;
  ASSERT_TRUE(Replay(drawing, &session, &report));
  EXPECT_EQ(grammar::TextOf(state().model.trees()), grammar::TextOf(session.state().model.trees()));
}

/// The demo up to its pick `number`, from 1, which is left out.
input::Drawing DemoUntilPick(int number) {
  const auto text = ReadFile(SourceFile("assets/drawings/house.pen"));
  EXPECT_TRUE(text);
  std::string cut;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line); cut += line + "\n") {
    if (line.find(": pick ") != std::string::npos && --number == 0) break;
  }
  return input::ReadDrawing(cut + "end\n").drawing;
}

TEST_F(ApplicationTest, HalfWayThroughTheDemoInkSuggestionsAndRulesAreSeen) {
  const auto played = Play(DemoUntilPick(7), application_.get());
  ASSERT_TRUE(played) << FormatError(played.error());
  Settle();
  EXPECT_EQ(state().sketch.strokes.size(), 4u);
  ExpectGolden(Seen(), "application_sketch");
}

/// The part of a picture about a pixel.
render::Image Around(const render::Image& image, const Vec2& middle, const glm::ivec2& size) {
  const glm::ivec2 low = glm::clamp(glm::ivec2(middle) - size / 2, glm::ivec2(0),
                                    glm::ivec2(image.width, image.height) - size);
  render::Image part{size.x, size.y, {}};
  for (int y = 0; y < size.y; ++y) {
    const auto* row = &image.pixels[size_t{4} * ((low.y + y) * image.width + low.x)];
    part.pixels.insert(part.pixels.end(), row, row + size_t{4} * size.x);
  }
  return part;
}

TEST_F(ApplicationTest, TheWordForWhatThePenHoversOverIsBesideItsTip) {
  const auto text = ReadFile(SourceFile("assets/drawings/house.pen"));
  ASSERT_TRUE(text && Play(input::ReadDrawing(*text).drawing, application_.get()));
  PlugIn();
  const auto glass =
      grammar::ProductOf(*grammar::ParseQuery(".Glass"), state().model.derived[0]->tree);
  ASSERT_TRUE(glass && glass->size() > 1);
  const auto& scope = ShapeAt(state().model, {0, (*glass)[1]}).item.scope;
  const Vec2 corner = Pixel(scope.origin + scope.x * scope.size.x);
  Pen(PenEvent::Kind::kProximityIn, corner + Vec2(-2, -2));
  Settle();
  ExpectGolden(Around(Seen(), corner, {480, 300}), "../../docs/panels/hover-light-1x");
}

TEST_F(ApplicationTest, BeforeTheFirstLineThereIsGroundToDrawOn) {
  Settle();
  ExpectGolden(Seen(), "application_empty");
}

TEST_F(ApplicationTest, TheEmptyGroundTurnsWithTheCamera) {
  Settle();
  const auto before = Seen();
  application_->Do(PanelCommand(ViewRequest::kAbove));
  Settle();
  EXPECT_GT(Compare(before, Seen(), {2, 0}).pixels, 10'000u);
}

TEST_F(ApplicationTest, WhatIsOnTheDisplayIsWhatAScreenshotShows) {
  PlugIn();
  Do("lot rect(20,14)");
  Draw({400, 700}, {900, 800});
  Settle();
  const auto shown = display_->ReadPixels();
  const auto anew = application_->Screenshot();
  ASSERT_TRUE(shown && anew);
  EXPECT_EQ(Compare(*shown, *anew, {2, 0}).pixels, 0u);
}

TEST_F(ApplicationTest, NothingIsDrawnWhileNothingChanges) {
  Do("lot rect(20,14)");
  const int frames = display_->frames();
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(application_->Turn(0));
  EXPECT_EQ(display_->frames(), frames);
}

/// The part of a picture that a sheet lies on, or lay.
render::Image Within(const render::Image& image, const PanelSheet& sheet) {
  return Around(image, (sheet.low_px + sheet.high_px) * 0.5,
                glm::ivec2(sheet.high_px - sheet.low_px));
}

class SteppingAsideInApplication : public ApplicationTest {
 protected:
  void SetUp() override {
    ApplicationTest::SetUp();
    PlugIn();
    Do("lot rect(20,14)");
  }
  PanelSheet Sheet(const std::string& name) const {
    const auto& sheets = application_->panels().sheets;
    const auto found = std::find_if(sheets.begin(), sheets.end(),
                                    [&](const PanelSheet& sheet) { return sheet.name == name; });
    EXPECT_NE(found, sheets.end()) << "no sheet " << name;
    return found == sheets.end() ? PanelSheet{} : *found;
  }
  bool Shows(const std::string& name) const {
    const auto& sheets = application_->panels().sheets;
    return std::any_of(sheets.begin(), sheets.end(),
                       [&](const PanelSheet& sheet) { return sheet.name == name; });
  }
};

TEST_F(SteppingAsideInApplication, ThePanelThatALineRunsIntoGoesAndTheLineGoesOn) {
  const PanelSheet tools = Sheet("Tools");
  const Vec2 middle = (tools.low_px + tools.high_px) * 0.5, from(700, middle.y - 40);
  const Vec2 to = middle + Vec2(0, 40);
  const render::Image before = Seen();
  Draw(from, to);
  Settle();
  const render::Image during = Seen();
  ExpectGolden(Within(during, {"", tools.low_px - 40.0, tools.high_px + Vec2(160, 40)}),
               "application_aside");
  EXPECT_EQ(Compare(Within(during, Sheet("Menu")), Within(before, Sheet("Menu")), {2, 0}).pixels,
            0u)
      << "what is far away stays";
  Lift(to);
  Settle();
  ASSERT_EQ(state().sketch.unread.size(), 1u);
  EXPECT_LT(glm::distance(state().sketch.unread[0]->stroke.back().position, to), 1e-6);
  Do("clear");
  EXPECT_EQ(Compare(Within(Seen(), tools), Within(before, tools), {2, 0}).pixels, 0u)
      << "it is back";
}

TEST_F(SteppingAsideInApplication, OnceAsideNothingIsDrawnForIt) {
  const PanelSheet tools = Sheet("Tools");
  Draw({700, 500}, (tools.low_px + tools.high_px) * 0.5);
  Settle();
  const int frames = display_->frames();
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(application_->Turn(0));
  EXPECT_EQ(display_->frames(), frames);
}

TEST_F(SteppingAsideInApplication, WhileItFadesOnlyItsOwnPixelsAreDrawn) {
  const PanelSheet tools = Sheet("Tools");
  const Vec2 from(700, 500), to(tools.high_px.x + 90, 500);
  Draw(from, to);
  ASSERT_TRUE(application_->Turn(0));
  const Vec2 shadow(12, 12);
  int faded = 0;
  for (int frames = display_->frames(); !application_->Settled(); frames = display_->frames()) {
    ASSERT_TRUE(application_->Turn(0.01));
    if (display_->frames() == frames) continue;
    ++faded;
    for (const render::PixelRect& rect : display_->presented()) {
      EXPECT_LE(rect.x + rect.width, tools.high_px.x + shadow.x);
      EXPECT_GE(rect.y, tools.low_px.y - shadow.y);
    }
  }
  EXPECT_GT(faded, 0);
}

TEST_F(SteppingAsideInApplication, WhatThePenHoveredOverIsNotNamedWhileItDraws) {
  Do("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000");
  const Vec2 on_lot = Pixel({10, 0, 7});
  Pen(PenEvent::Kind::kProximityIn, on_lot);
  Settle();
  ASSERT_THAT(Words(), testing::Contains("Lot"));
  DrawOn(on_lot, on_lot + Vec2(60, 0));
  Settle();
  EXPECT_THAT(Words(), testing::Not(testing::Contains("Lot")));
}

TEST_F(SteppingAsideInApplication, AnOpenSheetClosesWhenALineIsBegun) {
  TapOn("Menu/Views");
  ASSERT_TRUE(Shows("Views"));
  Draw({700, 500}, {760, 520});
  Settle();
  EXPECT_FALSE(Shows("Views"));
}

TEST_F(ApplicationTest, AnUnpluggedPenLeavesItsStroke) {
  PlugIn();
  Do("lot rect(20,14)");
  Do("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000");
  Draw(Pixel({0, 0, 14}), Pixel({0, 9, 14}));
  display_->Inject(DeviceEvent{DeviceEvent::Kind::kRemoved, t_s_, kPen, {}});
  Settle();
  EXPECT_EQ(state().sketch.strokes.size() + state().sketch.unread.size(), 1u);
}

TEST_F(ApplicationTest, AStrokeGoesOnThroughResizeAndLostFocus) {
  PlugIn();
  Do("lot rect(20,14)");
  Draw({300, 600}, {700, 620});
  display_->LoseFocus();
  Settle();
  display_->Resize({1200, 750}, 1);
  Settle();
  Lift({700, 620});
  Settle();
  EXPECT_EQ(state().sketch.strokes.size() + state().sketch.unread.size(), 1u);
  EXPECT_EQ(application_->camera().width_px, 1200);
}

TEST_F(ApplicationTest, TheViewStandsStillWhileALineIsDrawn) {
  PlugIn();
  Do("lot rect(20,14)");
  Do("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000");
  const Camera before = application_->camera();
  const Vec2 from = Pixel({0, 0, 14}), to = Pixel({0, 9, 14});
  Draw(from, to);
  display_->Inject(ScrollEvent{kMouse, t_s_, Vec2(80, 50), Vec2(0, -3)});
  Key(KEY_PAGEUP);
  Key(KEY_HOME);
  display_->Inject(KeyEvent{kKeys, t_s_, KEY_LEFTSHIFT, true});
  Key(KEY_LEFT);
  display_->Inject(KeyEvent{kKeys, t_s_, KEY_LEFTSHIFT, false});
  application_->Do(PanelCommand(ViewRequest::kAbove));
  application_->Do(
      PanelCommand(*ParseCommand("view eye 5 5 5 target 0 0 0 fov 40 size 1600 1000")));
  Settle();
  EXPECT_EQ(application_->camera(), before);
  Lift(to);
  Settle();
  ASSERT_THAT(state().sketch.suggestions, testing::Not(IsEmpty()))
      << "the line is read as it was drawn";
  EXPECT_EQ(application_->camera(), before);
  Key(KEY_PAGEUP);
  EXPECT_NE(application_->camera(), before) << "it moves again";
}

TEST_F(ApplicationTest, TwoFingersMoveTheGroundOneToOne) {
  PlugIn();
  Do("lot rect(20,14)");
  Do("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000");
  const Vec3 corner(0, 0, 14);
  const Vec2 before = Pixel(corner);
  using Kind = TouchEvent::Kind;
  Finger(Kind::kDown, 0, before - Vec2(100, 0));
  Finger(Kind::kDown, 1, before + Vec2(100, 0));
  for (int i = 1; i <= 30; ++i) {
    const Vec2 moved(4.0 * i, 2.0 * i);
    Finger(Kind::kMotion, 0, before + moved - Vec2(100, 0));
    Finger(Kind::kMotion, 1, before + moved + Vec2(100, 0));
  }
  Finger(Kind::kUp, 0, before);
  Finger(Kind::kUp, 1, before);
  Settle();
  EXPECT_LT(glm::distance(Pixel(corner), before + Vec2(120, 60)), 3);
  EXPECT_EQ(state().camera, application_->camera()) << "the session knows where one looks from";
}

TEST_F(ApplicationTest, TwoFingersTapUndoesAndThreeRedo) {
  PlugIn();
  Do("lot rect(20,14)");
  const auto tap = [this](int fingers) {
    t_s_ += 1;
    for (int i = 0; i < fingers; ++i) Finger(TouchEvent::Kind::kDown, i, {700.0 + 100 * i, 500});
    for (int i = 0; i < fingers; ++i) Finger(TouchEvent::Kind::kUp, i, {700.0 + 100 * i, 500});
    Settle();
  };
  tap(2);
  EXPECT_THAT(state().model.lots(), IsEmpty());
  tap(3);
  EXPECT_EQ(state().model.lots().size(), 1u);
}

TEST_F(ApplicationTest, ATapOnAShapeSelectsIt) {
  PlugIn();
  Do("lot rect(20,14)");
  Do("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000");
  TapAt(Pixel({10, 0, 7}));
  EXPECT_EQ(state().selection.shapes.size(), 1u);
}

TEST_F(ApplicationTest, AHoveringPenMarksWhatItMeans) {
  PlugIn();
  Do("lot rect(20,14)");
  Do("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000");
  const auto at = [&](const Vec2& px) {
    Pen(PenEvent::Kind::kProximityIn, px);
    Settle();
    return Seen();
  };
  const auto away = at(Pixel({-30, 0, 0}));
  const auto on_face = at(Pixel({10, 0, 7}));
  const auto on_corner = at(Pixel({0.05, 0, 13.95}));
  EXPECT_GT(Compare(away, on_face, {2, 0}).pixels, 100u) << "the outline of the lot";
  EXPECT_GT(Compare(on_face, on_corner, {2, 0}).pixels, 20u) << "a dot on the corner";
}

TEST_F(ApplicationTest, AHoveringPenIsToldWhatItMeans) {
  PlugIn();
  Do("lot rect(20,14)");
  Do("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000");
  const auto words_at = [&](const Vec2& px) {
    Pen(PenEvent::Kind::kProximityIn, px);
    Settle();
    return Words();
  };
  EXPECT_THAT(words_at(Pixel({10, 0, 7})), testing::Contains("Lot"));
  EXPECT_THAT(words_at(Pixel({0.05, 0, 13.95})), testing::Contains("corner of Lot"));
  EXPECT_THAT(words_at(Pixel({-30, 0, 0})), testing::Not(testing::Contains(HasSubstr("Lot"))));
}

TEST_F(ApplicationTest, WhileAPenHoversOverNothingPanelsAreNotMadeAnew) {
  PlugIn();
  Do("lot rect(20,14)");
  Pen(PenEvent::Kind::kProximityIn, {800, 40});
  Settle();
  const int frames = display_->frames();
  for (int i = 0; i < 10; ++i) {
    Pen(PenEvent::Kind::kMotion, {800.0 + i, 40});
    Settle();
  }
  EXPECT_EQ(display_->frames(), frames);
}

TEST_F(ApplicationTest, WhatComesUpWhereThePointerWasIsNotHovered) {
  PlugIn();
  Do("lot rect(20,14)");
  device_ = kMouse;
  Do("pick 9");
  ASSERT_THAT(Words(), testing::Contains(HasSubstr("no suggestion 9. This")));
  const auto& targets = application_->panels().targets;
  const auto close = std::find_if(targets.begin(), targets.end(), [](const PanelTarget& target) {
    return target.name == "Status/Close the message";
  });
  ASSERT_NE(close, targets.end());
  const Vec2 at = (close->low_px + close->high_px) * 0.5;
  using Kind = PenEvent::Kind;
  for (const Kind kind : {Kind::kMotion, Kind::kDown, Kind::kUp, Kind::kMotion}) {
    Pen(kind, at);
    Settle();
  }
  Pen(Kind::kMotion, {800, 500});
  Settle();
  Do("pick 9");
  EXPECT_THAT(Words(), testing::Contains(HasSubstr("no suggestion 9. This")));
  EXPECT_THAT(Words(), testing::Not(testing::Contains("Close the message")));
}

TEST_F(ApplicationTest, AScreenWithAPenIsMappedToItsOwnOutput) {
  DeviceFacts cintiq;
  cintiq.has_pen = cintiq.has_display = true;
  cintiq.size_mm = Vec2(300, 170);  // of another shape than the view
  display_->Inject(DeviceEvent{DeviceEvent::Kind::kAdded, 0, kPen, cintiq});
  const auto corner = [&] {
    PenEvent event;
    event.kind = PenEvent::Kind::kDown;
    event.device = kPen;
    event.position_mm = {290, 165};
    event.pressure = 0.5;
    event.t_s = t_s_ += 1;
    display_->Inject(event);
    event.position_mm = {280, 160};
    event.kind = PenEvent::Kind::kUp;
    event.t_s = t_s_ += 1;
    display_->Inject(event);
    Settle();
    return state().sketch.unread.back()->stroke.front().position;
  };
  EXPECT_LT(glm::distance(corner(), Vec2(290, 165) * (1000 / 170.0) + Vec2(-82.35, 0)), 0.1)
      << "by its shape";
  display_->PlugOutputs(
      {{Vec2(600, 340), std::nullopt}, {Vec2(300, 170), ViewRect{{0, 0}, {1600, 1000}}}});
  Settle();
  EXPECT_LT(glm::distance(corner(), Vec2(290, 165) * Vec2(1600 / 300.0, 1000 / 170.0)), 1e-6);
}

TEST_F(ApplicationTest, TheLeftHandIsToldToTheDisplay) {
  Settings settings;
  settings.left_handed = true;
  application_->Do(settings);
  EXPECT_TRUE(display_->left_handed());
}

TEST_F(ApplicationTest, TheEraserTakesStrokesAway) {
  PlugIn();
  Do("lot rect(20,14)");
  Do("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000");
  Line({600, 500}, {700, 200});
  ASSERT_EQ(state().sketch.strokes.size() + state().sketch.unread.size(), 1u);
  application_->Do(PointerMode::kErase);
  Line({500, 350}, {800, 360});
  EXPECT_EQ(state().sketch.strokes.size() + state().sketch.unread.size(), 0u);
}

TEST_F(ApplicationTest, ItIsNotAtRestWhileTheDocumentIsBeingOpened) {
  SessionThreadOptions options;
  options.folders = {folder_ + "/data", folder_ + "/state"};
  options.path = folder_ + "/large.parti";
  Document large = DocumentOf(Session());
  large.posted = {{"lot rect(450,450)"},
                  {"node .Lot --> split(x) { ~1: Row }*"},
                  {"node .Row --> split(y) { ~1: Tile }*"},
                  {"undo"}};  // slow to open, and soon drawn
  ASSERT_TRUE(SaveDocument(large, options.path));
  application_.reset();
  session_ = std::make_unique<SessionThread>(options);
  auto application = Application::Create(display_.get(), session_.get(), {});
  ASSERT_TRUE(application) << FormatError(application.error());
  application_ = std::move(*application);
  Settle();
  EXPECT_THAT(state().model.lots(), testing::SizeIs(1));
}

TEST_F(ApplicationTest, ClosingIsSaidAndLosesNothing) {
  PlugIn();
  Do("lot rect(20,14)");
  Draw({300, 600}, {700, 620});
  display_->AskToClose();
  Settle();
  EXPECT_TRUE(application_->close_asked());
}

}  // namespace
}  // namespace parti::app::tests
