// The sheets that open under buttons, the keyboard on the screen, and what is about the pen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include "input/binding_table.h"
#include "tests/app/panels_driver.h"

namespace parti::app::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Kind = DocumentRequest::Kind;

class PanelsSheets : public ::testing::Test {
 protected:
  void SetUp() override {
    panels_.view.session = WholeHouse();
    panels_.view.files = {
        {"/srv/Old.parti"}, "/srv", {{"Studies", true}, {"Courtyard.parti", false}}};
  }
  bool ShowsSheet(const std::string& name) {
    const auto& sheets = panels_.Frame().sheets;
    return std::any_of(sheets.begin(), sheets.end(),
                       [&](const PanelSheet& sheet) { return sheet.name == name; });
  }
  /// The document is this one; "" one without a name.
  void Hold(const std::string& path) {
    auto session = std::make_shared<SessionSnapshot>(*panels_.view.session);
    session->document = {.path = path, .named = !path.empty()};
    panels_.view.session = session;
  }
  /// What else lies in the folder.
  void Put(std::set<std::string> names) {
    panels_.view.files.others = std::make_shared<const std::set<std::string>>(std::move(names));
  }
  void OpenSaveAs() {
    panels_.view.has_keys = false;
    panels_.Tap("Title/Document");
    panels_.Tap("Document/Save as…");
  }
  PanelDriver panels_;
};

PanelCommand Asked(Kind kind, const std::string& path, bool replace = false) {
  return DocumentRequest{.kind = kind, .path = path, .replace = replace};
}

TEST_F(PanelsSheets, ANewDocumentIsAskedFor) {
  panels_.Tap("Title/Document");
  EXPECT_THAT(panels_.Tap("Document/New"), ElementsAre(PanelCommand(DocumentRequest{Kind::kNew})));
  EXPECT_FALSE(ShowsSheet("Document"));
}

TEST_F(PanelsSheets, ANameIsAskedForAtOnceAndTypedOver) {
  panels_.Key(KEY_LEFTCTRL);
  panels_.Frame({KeyEvent{.code = KEY_LEFTCTRL, .pressed = true}});
  panels_.Key(KEY_S);
  panels_.Frame({KeyEvent{.code = KEY_LEFTCTRL, .pressed = false}});
  panels_.Frame();
  EXPECT_TRUE(panels_.last().takes_keys) << "keys are letters, and choose no tools";
  panels_.Type("Barn");
  panels_.Key(KEY_ENTER);
  EXPECT_THAT(panels_.Tap("Save as/Save here"),
              ElementsAre(PanelCommand(DocumentRequest{Kind::kSaveAs, "/srv/Barn.parti"})));
}

TEST_F(PanelsSheets, ADocumentIsOpenedFromItsFolder) {
  panels_.Tap("Title/Document");
  EXPECT_THAT(panels_.Tap("Document/Open…"), ElementsAre(PanelCommand(ListFolder{"/srv"})));
  EXPECT_THAT(panels_.Tap("Open/Studies"), ElementsAre(PanelCommand(ListFolder{"/srv/Studies"})));
  EXPECT_THAT(panels_.Tap("Open/The folder above"), ElementsAre(PanelCommand(ListFolder{"/"})));
  EXPECT_THAT(panels_.Tap("Open/Courtyard.parti"),
              ElementsAre(PanelCommand(DocumentRequest{Kind::kOpen, "/srv/Courtyard.parti"})));
}

TEST_F(PanelsSheets, RecentOnesAreOneTapAway) {
  panels_.Tap("Title/Document");
  EXPECT_THAT(panels_.Tap("Document/Recent /srv/Old.parti"),
              ElementsAre(PanelCommand(DocumentRequest{Kind::kOpen, "/srv/Old.parti"})));
}

const char* const kDraft = "/srv/drafts/2026-11-22 09.30.05.parti";

TEST_F(PanelsSheets, DraftsThatWereLeftAreOfferedAtTheStart) {
  auto nothing = std::make_shared<SessionSnapshot>();
  nothing->state = std::make_shared<const SessionState>();
  panels_.view.session = nothing;
  panels_.view.files.drafts = {kDraft};
  ASSERT_TRUE(ShowsSheet("Drafts"));
  EXPECT_THAT(panels_.Tap(std::string("Drafts/Draft ") + kDraft),
              ElementsAre(PanelCommand(DocumentRequest{Kind::kOpen, kDraft})));
  panels_.Tap("Drafts/Close");
  EXPECT_FALSE(ShowsSheet("Drafts"));
}

TEST_F(PanelsSheets, WhoHasBegunIsNotAskedAboutDrafts) {
  panels_.view.files.drafts = {kDraft};
  EXPECT_FALSE(ShowsSheet("Drafts"));
}

TEST_F(PanelsSheets, ADraftIsThrownAwayAfterAskingOnceMore) {
  panels_.view.files.drafts = {kDraft};
  panels_.Tap("Title/Document");
  EXPECT_THAT(panels_.Tap(std::string("Document/Throw away ") + kDraft), IsEmpty());
  panels_.Tap("Document/Keep it");
  EXPECT_FALSE(panels_.Shows("Document/Throw away for good"));
  panels_.Tap(std::string("Document/Throw away ") + kDraft);
  EXPECT_THAT(panels_.Tap("Document/Throw away for good"),
              ElementsAre(PanelCommand(ThrowAway{kDraft})));
}

TEST_F(PanelsSheets, ItIsSavedUnderATypedName) {
  panels_.view.has_keys = false;  // the keyboard on the screen comes up when it is asked for
  panels_.Tap("Title/Document");
  panels_.Tap("Document/Save as…");
  panels_.Tap("Save as/Name");
  panels_.Type("Tower");
  panels_.Key(KEY_ENTER);
  EXPECT_THAT(panels_.Tap("Save as/Save here"),
              ElementsAre(PanelCommand(DocumentRequest{Kind::kSaveAs, "/srv/Tower.parti"})));
}

TEST_F(PanelsSheets, AnotherDocumentIsReplacedAfterAskingOnceMore) {
  OpenSaveAs();
  panels_.Tap("Save as/Courtyard.parti");
  EXPECT_THAT(panels_.Tap("Save as/Save here"), IsEmpty());
  EXPECT_TRUE(panels_.Says("Replace Courtyard.parti?"));
  EXPECT_THAT(panels_.Tap("Save as/Keep it"), IsEmpty());
  EXPECT_THAT(panels_.Tap("Save as/Save here"), IsEmpty());
  EXPECT_THAT(panels_.Tap("Save as/Replace for good"),
              ElementsAre(Asked(Kind::kSaveAs, "/srv/Courtyard.parti", true)));
  EXPECT_FALSE(ShowsSheet("Save as"));
}

TEST_F(PanelsSheets, AnotherNameOrAnotherLookTakesTheQuestionBack) {
  OpenSaveAs();
  panels_.TypeOver("Save as/Name", "Courtyard");
  panels_.Tap("Save as/Save here");
  ASSERT_TRUE(panels_.Shows("Save as/Replace for good"));
  panels_.TypeOver("Save as/Name", "Barn");
  EXPECT_FALSE(panels_.Shows("Save as/Replace for good"));
  panels_.TypeOver("Save as/Name", "Courtyard");
  ASSERT_TRUE(panels_.Shows("Save as/Replace for good"));
  panels_.Tap("Save as/Close");
  OpenSaveAs();
  panels_.TypeOver("Save as/Name", "Courtyard");
  EXPECT_FALSE(panels_.Shows("Save as/Replace for good"));
}

TEST_F(PanelsSheets, TheDocumentsOwnFileNeedsNoQuestionUnlessAnotherWritesIt) {
  Hold("/srv/Courtyard.parti");
  OpenSaveAs();
  EXPECT_THAT(panels_.Tap("Save as/Save here"),
              ElementsAre(Asked(Kind::kSaveAs, "/srv/Courtyard.parti")));
  auto session = std::make_shared<SessionSnapshot>(*panels_.view.session);
  session->document.read_only = true;
  panels_.view.session = session;
  OpenSaveAs();
  EXPECT_THAT(panels_.Tap("Save as/Save here"), IsEmpty());
}

TEST_F(PanelsSheets, ADocumentWithoutANameIsProposedOneThatIsFree) {
  Hold("");
  panels_.view.files.here.push_back({"House.parti", false});
  Put({"House 2.parti"});
  OpenSaveAs();
  EXPECT_THAT(panels_.Tap("Save as/Save here"),
              ElementsAre(Asked(Kind::kSaveAs, "/srv/House 3.parti")));
}

TEST_F(PanelsSheets, TroubleOffersAnotherPlace) {
  panels_.view.session = InTrouble(WholeHouse());
  panels_.Tap("Status/Save elsewhere");
  EXPECT_TRUE(ShowsSheet("Save as"));
}

TEST_F(PanelsSheets, WhatIsAboutFilesListsThemWhenItOpens) {
  const auto lists = ElementsAre(PanelCommand(ListFolder{"/srv"}));
  EXPECT_THAT(panels_.Tap("Title/Document"), lists);
  EXPECT_THAT(panels_.Tap("Document/Save as…"), lists);
  EXPECT_THAT(panels_.Tap("Menu/Export"), lists);
  EXPECT_THAT(panels_.Tap("Menu/Views"), IsEmpty());
  panels_.view.session = InTrouble(WholeHouse());
  EXPECT_THAT(panels_.Tap("Status/Save elsewhere"), lists);
}

TEST_F(PanelsSheets, ARecordingForAReportTakesAFreeName) {
  Put({"parti-report.pen"});
  panels_.Tap("Title/Document");
  EXPECT_TRUE(panels_.Says("parti-report 2.pen in /srv"));
  EXPECT_THAT(panels_.Tap("Document/Record for a bug report"),
              ElementsAre(Asked(Kind::kRecordForReport, "/srv/parti-report 2.pen")));
}

TEST_F(PanelsSheets, AMessageThatWasReadIsClosed) {
  panels_.view.session = InTrouble(WholeHouse());
  panels_.Tap("Status/Close the message");
  EXPECT_FALSE(panels_.Shows("Status/Close the message"));
}

TEST_F(PanelsSheets, WhatIsNotOnTheDiskMayBeLeft) {
  auto failed = std::make_shared<SessionSnapshot>(*panels_.view.session);
  failed->last_error = FailedRequest{3, {ErrorCode::kFile, "1 stroke is not on the disk"}};
  failed->last_error->giving_up = DocumentRequest{Kind::kOpen, "/srv/Old.parti", true};
  panels_.view.session = failed;
  EXPECT_TRUE(panels_.Shows("Status/Close the message"));
  EXPECT_THAT(panels_.Tap("Status/Leave them"),
              ElementsAre(PanelCommand(DocumentRequest{Kind::kOpen, "/srv/Old.parti", true})));
}

TEST_F(PanelsSheets, WhatFailedAtTheStartIsSaidUntilItIsRead) {
  auto failed = std::make_shared<SessionSnapshot>(*panels_.view.session);
  failed->last_error = FailedRequest{0, {ErrorCode::kFile, "can't read /srv/Old.parti"}};
  panels_.view.session = failed;
  EXPECT_TRUE(panels_.Shows("Status/Close the message"));
  panels_.Tap("Status/Close the message");
  EXPECT_FALSE(panels_.Shows("Status/Close the message"));
}

TEST_F(PanelsSheets, AModelIsExportedInTheChosenFormat) {
  panels_.Tap("Menu/Export");
  panels_.Tap("Export/.obj");
  EXPECT_THAT(panels_.Tap("Export/Export"),
              ElementsAre(PanelCommand(DocumentRequest{Kind::kExport, "/srv/House.obj"})));
}

TEST_F(PanelsSheets, AnExportIsNamedAfterTheDocumentThatIsOpenNow) {
  Hold("/srv/Tower.parti");
  panels_.Tap("Menu/Export");
  EXPECT_THAT(panels_.Tap("Export/Export"), ElementsAre(Asked(Kind::kExport, "/srv/Tower.glb")));
  Hold("/srv/Villa.parti");
  panels_.Tap("Menu/Export");
  EXPECT_THAT(panels_.Tap("Export/Export"), ElementsAre(Asked(Kind::kExport, "/srv/Villa.glb")));
  Hold("");
  Put({"House.glb"});
  panels_.Tap("Menu/Export");
  EXPECT_THAT(panels_.Tap("Export/Export"), ElementsAre(Asked(Kind::kExport, "/srv/House 2.glb")));
}

TEST_F(PanelsSheets, AnExportReplacesAFileAfterAskingOnceMore) {
  Put({"House.glb"});
  panels_.Tap("Menu/Export");
  EXPECT_THAT(panels_.Tap("Export/Export"), IsEmpty());
  EXPECT_TRUE(panels_.Says("Replace House.glb?"));
  EXPECT_THAT(panels_.Tap("Export/Replace for good"),
              ElementsAre(Asked(Kind::kExport, "/srv/House.glb", true)));
}

TEST_F(PanelsSheets, AnEndingThatIsTypedChoosesTheFormat) {
  panels_.Tap("Menu/Export");
  panels_.TypeOver("Export/File name", "a.OBJ");
  EXPECT_TRUE(panels_.Says("Goes to /srv/a.obj"));
  panels_.Tap("Export/.glb");
  EXPECT_THAT(panels_.Tap("Export/Export"), ElementsAre(Asked(Kind::kExport, "/srv/a.glb")));
  panels_.Tap("Menu/Export");
  panels_.TypeOver("Export/File name", "St. Mary");
  EXPECT_THAT(panels_.Tap("Export/Export"), ElementsAre(Asked(Kind::kExport, "/srv/St. Mary.glb")));
}

TEST_F(PanelsSheets, ViewsAreKeptAndTurnedTo) {
  panels_.Tap("Menu/Views");
  EXPECT_THAT(panels_.Tap("Views/South"), ElementsAre(PanelCommand(ViewRequest::kSouth)));
  panels_.Tap("Views/Keep this view as");
  panels_.Type("street corner");
  EXPECT_THAT(panels_.Key(KEY_ENTER),
              ElementsAre(PanelCommand(Command(KeepView{"street corner"}))));
}

TEST_F(PanelsSheets, KeptViewsAreGoneToAndDropped) {
  SessionState state = *panels_.view.session->state;
  state.views.push_back({"yard", state.camera});
  auto session = std::make_shared<SessionSnapshot>(*panels_.view.session);
  session->state = std::make_shared<const SessionState>(std::move(state));
  panels_.view.session = session;
  panels_.Tap("Menu/Views");
  EXPECT_THAT(panels_.Tap("Views/Go to yard"), ElementsAre(PanelCommand(Command(GoView{"yard"}))));
  EXPECT_THAT(panels_.Tap("Views/Drop yard"), ElementsAre(PanelCommand(Command(DropView{"yard"}))));
}

TEST_F(PanelsSheets, SettingsChangeOneThingAtATime) {
  panels_.Tap("Menu/Settings");
  Settings dark = panels_.view.settings;
  dark.theme = Theme::kDark;
  EXPECT_THAT(panels_.Tap("Settings/Dark"), ElementsAre(PanelCommand(dark)));
  Settings larger = panels_.view.settings;
  larger.scale = 1.25;
  EXPECT_THAT(panels_.Tap("Settings/Larger panels"), ElementsAre(PanelCommand(larger)));
  Settings left = panels_.view.settings;
  left.left_handed = true;
  EXPECT_THAT(panels_.Tap("Settings/Left-handed"), ElementsAre(PanelCommand(left)));
}

TEST_F(PanelsSheets, TheButtonsOfThePenAreBoundAnew) {
  panels_.Tap("Menu/Settings");
  const auto commands = panels_.Tap("Settings/Lower button");
  ASSERT_EQ(commands.size(), 1u);
  const auto table = input::ReadBindings(std::get<Settings>(commands[0]).bindings);
  ASSERT_TRUE(table);
  EXPECT_EQ(input::ActFor(*table, input::PenSource::kPen, 0, {{BTN_STYLUS}}),
            input::PenAct::kSelect);
}

TEST_F(PanelsSheets, TwoTapsInOneFrameBothCount) {
  panels_.Tap("Menu/Settings");
  const Vec2 dark = MiddleOf(panels_.Find("Settings/Dark"));
  const Vec2 left = MiddleOf(panels_.Find("Settings/Left-handed"));
  const PanelOutput& output = panels_.Frame({PanelPointer{dark, true}, PanelPointer{dark, false},
                                             PanelPointer{left, true}, PanelPointer{left, false}});
  ASSERT_EQ(output.commands.size(), 2u);
  const auto& both = std::get<Settings>(output.commands[1]);
  EXPECT_TRUE(both.left_handed && both.theme == Theme::kDark);
}

TEST_F(PanelsSheets, KeysOpenAndCloseThem) {
  panels_.Frame({KeyEvent{.code = KEY_LEFTCTRL, .pressed = true}});
  panels_.Key(KEY_S);
  panels_.Frame({KeyEvent{.code = KEY_LEFTCTRL, .pressed = false}});
  EXPECT_TRUE(ShowsSheet("Save as"));
  panels_.Key(KEY_ESC);  // ends the typing
  EXPECT_TRUE(ShowsSheet("Save as"));
  panels_.Frame({KeyEvent{.code = KEY_ESC, .pressed = true}});
  EXPECT_TRUE(panels_.last().takes_keys);
  EXPECT_FALSE(ShowsSheet("Save as"));
  panels_.Frame({KeyEvent{.code = KEY_ESC, .pressed = true}});
  EXPECT_FALSE(panels_.last().takes_keys) << "there was nothing more to close";
}

TEST_F(PanelsSheets, ThePenOnTheDrawingClosesThem) {
  panels_.Tap("Menu/Views");
  panels_.view.pen = {Vec2(700, 500), true};
  EXPECT_FALSE(ShowsSheet("Views"));
}

TEST_F(PanelsSheets, WithoutAKeyboardOneComesUpAndTypes) {
  panels_.view.has_keys = false;
  panels_.Tap("Menu/Views");
  EXPECT_FALSE(ShowsSheet("Keyboard"));
  panels_.Tap("Views/Keep this view as");
  ASSERT_TRUE(ShowsSheet("Keyboard"));
  panels_.Tap("Keyboard/Capitals");
  panels_.Tap("Keyboard/Y");
  panels_.Tap("Keyboard/a");
  panels_.Tap("Keyboard/s");
  panels_.Tap("Keyboard/Backspace");
  panels_.Tap("Keyboard/Space");
  panels_.Tap("Keyboard/Signs");
  panels_.Tap("Keyboard/2");
  EXPECT_THAT(panels_.Tap("Keyboard/Enter"), ElementsAre(PanelCommand(Command(KeepView{"Ya 2"}))));
  EXPECT_FALSE(ShowsSheet("Keyboard"));
}

/// What the keyboard's keys type that are on the page in sight.
std::string TypedByKeysOf(const PanelOutput& output) {
  static constexpr std::string_view kKeyboard = "Keyboard/";
  std::string typed;
  for (const PanelTarget& target : output.targets) {
    if (!target.name.starts_with(kKeyboard)) continue;
    const std::string key = target.name.substr(kKeyboard.size());
    if (key == "Space") typed += ' ';
    if (key.size() == 1) typed += key;
  }
  return typed;
}

TEST_F(PanelsSheets, WithoutAKeyboardEveryCharacterOfRulesCanBeTyped) {
  panels_.view.has_keys = false;
  panels_.Tap("Menu/Views");
  panels_.Tap("Views/Keep this view as");
  std::string typed = TypedByKeysOf(panels_.Frame());
  for (const char* turn : {"Capitals", "Capitals", "Signs", "More signs"}) {
    panels_.Tap(std::string("Keyboard/") + turn);
    typed += TypedByKeysOf(panels_.Frame());
  }
  for (char c = ' '; c <= '~'; ++c) {
    EXPECT_NE(typed.find(c), std::string::npos) << "there is no key for " << c;
  }
}

TEST_F(PanelsSheets, BothPagesOfSignsTypeAndLeadToEachOther) {
  panels_.view.has_keys = false;
  panels_.Tap("Menu/Views");
  panels_.Tap("Views/Keep this view as");
  for (const char* key :
       {"Signs", "#", "More signs", "{", "More signs", "7", "More signs", "}", "Signs", "a"}) {
    panels_.Tap(std::string("Keyboard/") + key);
  }
  EXPECT_THAT(panels_.Tap("Keyboard/Enter"), ElementsAre(PanelCommand(Command(KeepView{"#{7}a"}))));
}

TEST_F(PanelsSheets, TheElementInHandIsArrangedByButtons) {
  HoldElement(&panels_.view);
  EXPECT_TRUE(panels_.Says("1.5 × 2.5 m, 4 m from the left, 0 m up"));
  EXPECT_THAT(panels_.Tap("Element/Same size"),
              ElementsAre(PanelCommand(ElementCommand::kSameSize)));
  EXPECT_THAT(panels_.Tap("Element/Middles in line, in height"),
              ElementsAre(PanelCommand(ElementCommand::kCenterUp)));
  EXPECT_THAT(panels_.Tap("Element/Bottom edges"), IsEmpty()) << "they are in line";
  EXPECT_THAT(panels_.Tap("Element/By the next"),
              ElementsAre(PanelCommand(ElementCommand::kByNext)));
  EXPECT_THAT(panels_.Tap("Element/Let go"), ElementsAre(PanelCommand(ElementCommand::kLetGo)));
}

TEST_F(PanelsSheets, CardsLeaveHandlesClear) {
  HoldElement(&panels_.view);
  for (const Vec2& tapped : {Vec2(620, 480), Vec2(700, 350), Vec2(560, 300)}) {
    panels_.view.tapped_px = tapped;
    const PanelOutput& output = panels_.Frame();
    for (const SeenElement& element : panels_.view.elements) {
      for (const Vec2& px : element.handles_px) {
        EXPECT_FALSE(output.IsOverSheet(px)) << px.x << ", " << px.y << " of " << tapped.x;
      }
    }
  }
}

TEST_F(PanelsSheets, TheWordBesideThePenCoversNoControl) {
  HoldElement(&panels_.view);
  panels_.view.pen.word = "1.60 m wide, 2.50 m high";
  panels_.view.pen.down = true;
  int covered = 0;
  for (int x = 20; x < 1600; x += 60) {
    for (int y = 20; y < 1000; y += 40) {
      panels_.view.pen.position_px = Vec2(x, y);
      const PanelOutput& output = panels_.Frame();
      const PanelText& word = output.texts.back();
      ASSERT_EQ(word.text, panels_.view.pen.word);
      for (const PanelTarget& target : output.targets) {
        const bool apart =
            word.room_high_px.x <= target.low_px.x || word.room_high_px.y <= target.low_px.y ||
            word.room_low_px.x >= target.high_px.x || word.room_low_px.y >= target.high_px.y;
        covered += target.visible && !apart;
      }
    }
  }
  EXPECT_EQ(covered, 0);
}

TEST_F(PanelsSheets, UnderASheetThatComesUpAPenThatHoversHasNoWord) {
  panels_.view.pen = {Vec2(300, 200), false, "corner of Frame"};
  EXPECT_TRUE(panels_.Says("corner of Frame"));
  panels_.Tap("Title/Document");
  EXPECT_FALSE(panels_.Says("corner of Frame"));
  panels_.view.pen.down = true;
  EXPECT_TRUE(panels_.Says("corner of Frame")) << "the sheet closes";
}

TEST_F(PanelsSheets, FiguresFollowThePenThatDrags) {
  panels_.view.pen = {Vec2(700, 500), true, "1.50 m wide, 2.50 m high"};
  EXPECT_TRUE(panels_.Says("1.50 m wide"));
  panels_.view.pen.word = "1.60 m wide, 2.50 m high";
  EXPECT_TRUE(panels_.Says("1.60 m wide")) << "while the pen is down";
  panels_.view.pen.word = "";
  EXPECT_FALSE(panels_.Says("1.60 m wide"));
}

TEST_F(PanelsSheets, WhileThePenDrawsAFrameWithoutNewsChangesNothing) {
  panels_.view.pen = {Vec2(700, 500), true};
  panels_.Frame();
  panels_.view.pen.position_px = Vec2(710, 505);
  EXPECT_FALSE(panels_.Frame().changed);
}

TEST_F(PanelsSheets, AListScrollsUnderAFingerAndNothingIsPressed) {
  panels_.view.session = Taken(WholeHouse(), {});  // the list is at its top
  panels_.view.size_px = {1280, 620};
  panels_.Tap("Menu/Rules");
  const PanelTarget row = panels_.Find("Rules/0/0/0 ");
  const double y = MiddleOf(row).y;
  EXPECT_THAT(panels_.Drag("Rules/0/0/0 ", {0, -60}), IsEmpty());
  EXPECT_LT(MiddleOf(panels_.Find("Rules/0/0/0 ")).y, y - 30);
}

TEST_F(PanelsSheets, AWheelScrollsTheListUnderThePointer) {
  panels_.view.session = Taken(WholeHouse(), {});  // the list is at its top
  panels_.view.size_px = {1280, 620};
  panels_.Tap("Menu/Rules");
  const Vec2 at = MiddleOf(panels_.Find("Rules/0/0/0 "));
  panels_.Frame({PanelPointer{at, false}, PanelScroll{{0, 1}}});
  EXPECT_LT(MiddleOf(panels_.Find("Rules/0/0/0 ")).y, at.y - 10);
}

}  // namespace
}  // namespace parti::app::tests
