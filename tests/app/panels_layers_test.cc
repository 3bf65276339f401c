// The rule files as text and their layers, through the panels' input only.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include <array>

#include "app/panels/file_text.h"
#include "app/rule_edits.h"
#include "app/session.h"
#include "tests/app/panels_driver.h"

namespace parti::app::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;

class PanelsFiles : public ::testing::Test {
 protected:
  void SetUp() override { Show(LayeredHouse()); }
  void Show(const std::shared_ptr<const SessionSnapshot>& session) {
    panels_.view.session = session;
    panels_.view.size_px = {1600, 2400};
    if (!panels_.Shows("Rules/As text")) panels_.Tap("Menu/Rules");
  }
  /// The model after the one command that was sent, if it is one that can be done.
  void Obey(const std::vector<PanelCommand>& sent) { Obey(std::array{sent}); }
  /// After one command of each of several taps.
  template <size_t kTaps>
  void Obey(const std::array<std::vector<PanelCommand>, kTaps>& taps) {
    Session session(panels_.view.session->state->model, Camera());
    for (const std::vector<PanelCommand>& sent : taps) {
      ASSERT_THAT(sent, SizeIs(1));
      const auto done = session.Execute(std::get<Command>(sent[0]));
      ASSERT_TRUE(done) << FormatError(done.error());
    }
    auto next = std::make_shared<SessionSnapshot>(*panels_.view.session);
    next->state = std::make_shared<const SessionState>(session.state());
    panels_.view.session = next;
  }
  const RuleSource& Source() const { return *panels_.view.session->state->model.ground->source; }
  PanelDriver panels_;
};

TEST_F(PanelsFiles, ABuildingOfFilesSaysWhereItsRulesAre) {
  EXPECT_TRUE(panels_.Says("rule files"));
  panels_.Tap("Rules/As text");
  EXPECT_TRUE(panels_.Says("roof.cga"));
  EXPECT_TRUE(panels_.Says("Flat --> extrude(0.3) Slab"));
}

TEST_F(PanelsFiles, ALineOfAFileIsTypedOver) {
  panels_.Tap("Rules/As text");
  const std::string before = Source().files[0].text;
  const auto before_typing = panels_.view.session;
  Obey(panels_.TypeOver("Rules/house.cga 3", "attr height = 13"));
  std::string expected = before;
  expected.replace(expected.find("height = 10"), 11, "height = 13");
  EXPECT_EQ(Source().files[0].text, expected) << "and nothing else";
  EXPECT_TRUE(panels_.Says("attr height = 13"));
  EXPECT_FALSE(panels_.Says("Not in force yet"));
  Show(before_typing);
  EXPECT_TRUE(panels_.Says("attr height = 10")) << "undone, what was typed does not come back";
  EXPECT_FALSE(panels_.Says("Not in force yet"));
}

TEST_F(PanelsFiles, TypedTextKeepsItsIndentation) {
  panels_.Tap("Rules/As text");
  Obey(panels_.TypeOver("Rules/house.cga 9", "{ Floors | Sign | Shop }"));
  EXPECT_THAT(Source().files[0].text, HasSubstr("\n  { Floors | Sign | Shop }\n"));
}

TEST_F(PanelsFiles, LinesAreAddedAndTakenOut) {
  panels_.Tap("Rules/As text");
  Obey(panels_.TypeOver("Rules/roof.cga end", "Steep --> extrude(2)"));
  EXPECT_EQ(Source().files[1].text, "Flat --> extrude(0.3) Slab\nSteep --> extrude(2)\n");
  panels_.Tap("Rules/roof.cga 2");
  panels_.Key(KEY_BACKSPACE);
  Obey(panels_.Key(KEY_ENTER));
  EXPECT_EQ(Source().files[1].text, "Flat --> extrude(0.3) Slab\n");
}

TEST_F(PanelsFiles, WhatCantBeReadWaitsAndSaysSoAtItsLine) {
  panels_.Tap("Rules/As text");
  EXPECT_THAT(panels_.TypeOver("Rules/house.cga 5", "Lot --> extrud(height) Mass"), IsEmpty());
  EXPECT_TRUE(panels_.Says("'extrude'?"));
  EXPECT_TRUE(panels_.Says("Not in force yet"));
  EXPECT_THAT(panels_.TypeOver("Rules/house.cga 13", "Window --> extrude(-0.2, 3, 4) Glass"),
              IsEmpty());
  EXPECT_THAT(panels_.TypeOver("Rules/house.cga 5", "Lot --> extrude(height) Mass"), IsEmpty())
      << "the other line is still wrong";
  const auto sent = panels_.TypeOver("Rules/house.cga 13", "Window --> extrude(-0.3) Glass");
  Obey(sent);
  EXPECT_FALSE(panels_.Says("Not in force yet"));
}

TEST_F(PanelsFiles, WhatWaitsCanBeTakenBack) {
  panels_.Tap("Rules/As text");
  panels_.TypeOver("Rules/house.cga 5", "Lot --> {{{");
  panels_.Tap("Rules/Back house.cga");
  EXPECT_FALSE(panels_.Says("Not in force yet"));
  EXPECT_TRUE(panels_.Says("Lot --> extrude(height) Mass"));
}

TEST_F(PanelsFiles, WhatCantBeDerivedSaysSoAtItsLineAndIsNotLost) {
  panels_.Tap("Rules/As text");
  ASSERT_THAT(panels_.TypeOver("Rules/house.cga 5", "Lot --> extrude(height / 0) Mass"), SizeIs(1));
  const Model& model = panels_.view.session->state->model;
  const std::string text = Source().files[0].text;
  std::string typed = text;
  typed.replace(typed.find("extrude(height)"), 15, "extrude(height / 0)");
  const auto refused = WithRuleText(model, {"house.cga", typed});
  ASSERT_FALSE(refused);
  auto failed = std::make_shared<SessionSnapshot>(*panels_.view.session);
  failed->last_error = FailedRequest{1, refused.error().front()};
  panels_.view.session = failed;
  EXPECT_TRUE(panels_.Says("extrude(height / 0)"));
  EXPECT_TRUE(panels_.Says("Not in force yet"));
  panels::TypedFiles waiting;
  EXPECT_TRUE(panels::TypeOver(*panels_.view.session, "house.cga", 4,
                               "Lot --> extrude(height / 0) Mass", &waiting));
  waiting.failed_before = 0;
  const auto lines = panels::FilesOf(*failed, waiting).front().lines;
  EXPECT_THAT(lines[4].notes, SizeIs(1));
  EXPECT_THAT(lines[5].notes, IsEmpty());
}

TEST_F(PanelsFiles, TextsAreReadAnewOnlyWhereTheyChange) {
  panels::KnownFiles known;
  panels::TypedFiles typed;
  const auto session = panels_.view.session;
  const auto* at_first = known.Of(*session, typed).data();
  EXPECT_EQ(known.Of(*std::make_shared<SessionSnapshot>(*session), typed).data(), at_first);
  EXPECT_FALSE(panels::TypeOver(*session, "house.cga", 4, "Lot --> {{{", &typed));
  const auto* waiting = known.Of(*session, typed).data();
  EXPECT_THAT(waiting[0].lines[4].text, "Lot --> {{{");
  EXPECT_EQ(known.Of(*session, typed).data(), waiting);
  auto failed = *session;
  failed.last_error = FailedRequest{1, {}};
  EXPECT_NE(known.Of(failed, typed).data(), waiting);
  typed = {};
  EXPECT_THAT(known.Of(failed, typed)[0].lines[4].text, HasSubstr("extrude"));
  EXPECT_FALSE(known.Of(failed, typed)[0].waits);
}

TEST_F(PanelsFiles, WhatAnotherFileMadeReadableIsPutInForceByATap) {
  panels_.Tap("Rules/As text");
  EXPECT_THAT(panels_.TypeOver("Rules/house.cga 5", "Lot --> extrude(roof.storey) Mass"),
              IsEmpty());
  EXPECT_FALSE(panels_.Shows("Put in force house.cga")) << "it can't be read";
  Obey(panels_.TypeOver("Rules/roof.cga end", "const storey = 7"));
  EXPECT_TRUE(panels_.Says("Lot --> extrude(roof.storey) Mass")) << "it is not lost";
  const auto sent = panels_.Tap("Rules/Put in force house.cga");
  ASSERT_THAT(sent, SizeIs(1));
  EXPECT_FALSE(panels_.Shows("Put in force house.cga")) << "it is being derived";
  Obey(sent);
  EXPECT_THAT(Source().files[0].text, HasSubstr("extrude(roof.storey)"));
  EXPECT_FALSE(panels_.Says("Not in force yet"));
}

TEST_F(PanelsFiles, WhatWasRefusedCanBeTriedAgain) {
  panels_.Tap("Rules/As text");
  ASSERT_THAT(panels_.TypeOver("Rules/house.cga 5", "Lot --> extrude(height / 0) Mass"), SizeIs(1));
  EXPECT_FALSE(panels_.Shows("Put in force house.cga")) << "it is being derived";
  auto failed = std::make_shared<SessionSnapshot>(*panels_.view.session);
  failed->last_error = FailedRequest{1, {ErrorCode::kBadNumber, "too much", "", std::nullopt}};
  panels_.view.session = failed;
  EXPECT_TRUE(panels_.Says("can't be made by it"));
  EXPECT_THAT(panels_.Tap("Rules/Put in force house.cga"), SizeIs(1));
}

class PanelsLayers : public PanelsFiles {
 protected:
  void SetUp() override {
    PanelsFiles::SetUp();
    panels_.Tap("Rules/Layers");
  }
  const grammar::LayerEdits& Edits() const { return Source().layers; }
};

TEST_F(PanelsLayers, AreSwitchedOffAndOn) {
  Obey(panels_.Tap("Rules/Show Facade.sign"));
  EXPECT_THAT(Edits().off, ElementsAre("Facade.sign"));
  Obey(panels_.Tap("Rules/Show Facade.sign"));
  EXPECT_EQ(Edits(), grammar::LayerEdits());
}

TEST_F(PanelsLayers, AreMovedUpAndDown) {
  Obey(panels_.Tap("Rules/Move down Facade.sign"));
  EXPECT_THAT(Edits().order, ElementsAre(Pair("Facade", ElementsAre("floors", "sign", "shop"))));
  Obey(panels_.Tap("Rules/Move up Facade.sign"));
  EXPECT_EQ(Edits(), grammar::LayerEdits());
  EXPECT_THAT(panels_.Tap("Rules/Move up Facade.sign"), IsEmpty()) << "it is topmost";
}

TEST_F(PanelsLayers, AreGivenAnotherRuleAndTheirOwnAgain) {
  panels_.Tap("Rules/Facade.shop");
  Obey(panels_.Tap("Rules/Facade.shop gets Door"));
  EXPECT_THAT(Edits().rules, ElementsAre(Pair("Facade.shop", "Door")));
  EXPECT_TRUE(panels_.Says("Door, not Shop"));
  EXPECT_FALSE(panels_.Shows("Facade.shop gets Door")) << "it is picked";
  panels_.Tap("Rules/Facade.shop");
  Obey(panels_.Tap("Rules/Facade.shop gets "));
  EXPECT_EQ(Edits(), grammar::LayerEdits());
}

TEST_F(PanelsLayers, TapsWhileTheBuildingIsDerivedAddUp) {
  panels_.Tap("Rules/Facade.shop");
  Obey(std::array{panels_.Tap("Rules/Show Facade.floors"), panels_.Tap("Rules/Show Facade.sign"),
                  panels_.Tap("Rules/Move up Facade.floors"),
                  panels_.Tap("Rules/Move up Facade.floors"),
                  panels_.Tap("Rules/Facade.shop gets Door")});
  EXPECT_THAT(Edits().off, ElementsAre("Facade.floors", "Facade.sign"));
  EXPECT_THAT(Edits().order, ElementsAre(Pair("Facade", ElementsAre("shop", "sign", "floors"))));
  EXPECT_THAT(Edits().rules, ElementsAre(Pair("Facade.shop", "Door")));
}

TEST_F(PanelsLayers, ATextThatWaitsForThemIsNotLost) {
  Obey(panels_.Tap("Rules/Show Facade.sign"));
  panels_.Tap("Rules/As text");
  const std::string line = R"~(Facade --> layers("floors", "shop", "board"))~";
  EXPECT_THAT(panels_.TypeOver("Rules/house.cga 8", line), IsEmpty());
  EXPECT_TRUE(panels_.Says("There is no layer 'Facade.sign'")) << "that is off";
  panels_.Tap("Rules/Layers");
  Obey(panels_.Tap("Rules/Show Facade.sign"));
  EXPECT_EQ(Edits(), grammar::LayerEdits());
  panels_.Tap("Rules/As text");
  EXPECT_TRUE(panels_.Says("Not in force yet"));
  EXPECT_TRUE(panels_.Says("\"board\""));
  EXPECT_TRUE(panels_.Says("can be read now"));
  Obey(panels_.Tap("Rules/Put in force house.cga"));
  EXPECT_THAT(Source().files[0].text, HasSubstr(line));
  EXPECT_FALSE(panels_.Says("Not in force yet"));
}

TEST_F(PanelsLayers, OfTheFaceInHandAreShownAlone) {
  EXPECT_TRUE(panels_.Says("of all rules"));
  Show(LayeredHouse(".Board"));
  EXPECT_TRUE(panels_.Says("of the face in hand"));
  Show(LayeredHouse(".Wall"));
  EXPECT_TRUE(panels_.Says("of all rules")) << "that one has none";
}

TEST(PanelsWithoutFiles, ADrawnBuildingHasNoLayers) {
  PanelDriver panels;
  panels.view.session = WholeHouse();
  panels.Tap("Menu/Rules");
  EXPECT_TRUE(panels.Shows("Rules/As text"));
  EXPECT_FALSE(panels.Shows("Rules/Layers"));
}

}  // namespace
}  // namespace parti::app::tests
