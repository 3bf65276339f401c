// The rules, the node in hand and tapped shapes, through their input only.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include "app/session.h"
#include "tests/app/panels_driver.h"

namespace parti::app::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

PanelCommand Sent(Command command) { return command; }

class PanelsRules : public ::testing::Test {
 protected:
  void SetUp() override {
    panels_.view.session = WholeHouse();
    panels_.view.size_px = {1600, 1400};
    panels_.Tap("Menu/Rules");
  }
  void Take(const NodePath& path) { panels_.view.session = Taken(WholeHouse(), path); }
  PanelDriver panels_;
};

TEST(PanelsQueries, AHoveredQueryIsPreviewed) {
  PanelDriver panels;
  panels.view.session = HouseWithTaps(2);
  panels.view.tapped_px = Vec2(600, 400);
  EXPECT_EQ(panels.Frame().query_preview, std::nullopt);
  EXPECT_EQ(panels.Hover("Queries/2 ").query_preview, std::optional<size_t>(1));
}

TEST_F(PanelsRules, ATapOnARowTakesItsNode) {
  EXPECT_THAT(panels_.Tap("Rules/0/0/0 Take faces"), ElementsAre(Sent(app::Take{{0, 0, 0}})));
}

bool Rewrites(const std::vector<PanelCommand>& sent, const std::string& part) {
  if (sent.size() != 1) return false;
  return std::get<Rewrite>(std::get<Command>(sent[0])).text.find(part) != std::string::npos;
}

TEST_F(PanelsRules, AnAxisIsPicked) {
  Take({0, 0, 0, 0});
  EXPECT_TRUE(Rewrites(panels_.Tap("Node/Axis across"), ".Facade --> split(x) { 4.1: Ground"));
}

TEST_F(PanelsRules, AColorIsPickedOrTyped) {
  Take({0, 3});
  EXPECT_TRUE(Rewrites(panels_.Tap("Node/Brick"), ".Glass --> color(\"#b5654a\")"));
  panels_.Tap("Node/Color");
  panels_.Type("#112233");
  EXPECT_TRUE(Rewrites(panels_.Key(KEY_ENTER), "color(\"#112233\")"));
}

class PanelsRulesText : public PanelsRules {
 protected:
  void SetUp() override {
    PanelsRules::SetUp();
    panels_.Tap("Rules/As text");
  }
};

TEST_F(PanelsRulesText, ALineIsTypedOver) {
  EXPECT_TRUE(panels_.Says(".Frame --> extrude(0.15)"));
  const auto sent = panels_.TypeOver("Rules/Line 19", ".Frame --> extrude(0.25)");
  ASSERT_EQ(sent.size(), 1u);
  const auto& rewrite = std::get<Rewrite>(std::get<Command>(sent[0]));
  EXPECT_NE(rewrite.text.find(".Frame --> extrude(0.25) .RoofBorder"), std::string::npos)
      << rewrite.text;
  EXPECT_EQ(rewrite.text.find('\n'), std::string::npos);
}

TEST_F(PanelsRulesText, WhatCantBeReadWaitsAndSaysSoAtItsLine) {
  EXPECT_THAT(panels_.TypeOver("Rules/Line 19", ".Frame --> extrud(0.25)"), IsEmpty());
  EXPECT_TRUE(panels_.Says("'extrude'?"));
  EXPECT_TRUE(panels_.Says("Not in force yet"));
  EXPECT_THAT(panels_.TypeOver("Rules/Line 19", ".Frame --> extrude(0.25)"), ::testing::SizeIs(1));
}

TEST_F(PanelsRulesText, WhatWaitsCanBeTakenBack) {
  panels_.TypeOver("Rules/Line 19", "{{{");
  panels_.Tap("Rules/Back to the rules in force");
  EXPECT_FALSE(panels_.Says("Not in force yet"));
  EXPECT_TRUE(panels_.Says(".Frame --> extrude(0.15)"));
}

TEST_F(PanelsRulesText, AnEmptiedLineIsTakenOut) {
  panels_.Tap("Rules/Line 19");
  panels_.Key(KEY_BACKSPACE);
  const auto sent = panels_.Key(KEY_ENTER);
  ASSERT_EQ(sent.size(), 1u);
  const auto& rewrite = std::get<Rewrite>(std::get<Command>(sent[0]));
  EXPECT_EQ(rewrite.text.find(".Frame"), std::string::npos);
}

TEST_F(PanelsRules, ATapOnTheRowInHandLetsItGo) {
  Take({0, 0, 0});
  EXPECT_THAT(panels_.Tap("Rules/0/0/0 Take faces"), ElementsAre(Sent(app::Take{})));
}

TEST_F(PanelsRules, ItsSwitchTurnsANodeOff) {
  EXPECT_THAT(panels_.Tap("Rules/Run 0/0/0"), ElementsAre(Sent(Switch{{0, 0, 0}, false})));
}

TEST_F(PanelsRules, TheNodeInHandMovesAndGoes) {
  Take({0, 1});
  EXPECT_THAT(panels_.Tap("Rules/Move up"), ElementsAre(Sent(Move{{0, 1}, {0, 0}})));
  EXPECT_THAT(panels_.Tap("Rules/Move down"), ElementsAre(Sent(Move{{0, 1}, {0, 2}})));
  EXPECT_THAT(panels_.Tap("Rules/Delete"), ElementsAre(Sent(app::Delete{{0, 1}})));
}

TEST_F(PanelsRules, TheFirstOfItsSiblingsDoesNotMoveUp) {
  Take({0, 0});
  EXPECT_FALSE(panels_.Find("Rules/Move up").enabled);
}

TEST_F(PanelsRules, DraggedByItsGripANodeGoesWhereItIsDropped) {
  Take({0, 1});
  const PanelTarget onto = panels_.Find("Rules/0/3 ");
  const Vec2 from = MiddleOf(panels_.Find("Rules/Drag to another place"));
  const Vec2 after(MiddleOf(onto).x, onto.high_px.y - 4);
  EXPECT_THAT(panels_.Drag("Rules/Drag to another place", after - from),
              ElementsAre(Sent(Move{{0, 1}, {0, 3}})));
}

TEST_F(PanelsRules, DroppedOnItselfItStays) {
  Take({0, 1});
  EXPECT_THAT(panels_.Drag("Rules/Drag to another place", {0, -30}), IsEmpty());
}

TEST_F(PanelsRules, AStepOfANumberSetsIt) {
  Take({0, 0, 0, 0, 0});  // repeat, 3 m
  const auto commands = panels_.Tap("Node/More sizes[0]");
  ASSERT_EQ(commands.size(), 1u);
  const auto& set = std::get<SetNumber>(std::get<Command>(commands[0]));
  EXPECT_EQ(set.dial, "sizes[0]");
  EXPECT_NEAR(set.value, 3.1, 0.051);
}

TEST_F(PanelsRules, StepsGiveTheDecimalsThatTheyShow) {
  Take({0, 0, 0, 0, 0});
  Session session(panels_.view.session->state->model, Camera());
  constexpr int kSteps = 40;
  for (int i = 0; i < kSteps; ++i) {
    const auto sent = panels_.Tap("Node/More sizes[0]");
    ASSERT_EQ(sent.size(), 1u);
    const auto& set = std::get<SetNumber>(std::get<Command>(sent[0]));
    EXPECT_LE(fmt::format("{}", set.value).size(), 4u) << fmt::format("{} m", set.value);
    ASSERT_TRUE(session.Execute(Command(app::Take{{0, 0, 0, 0, 0}})));
    ASSERT_TRUE(session.Execute(Command(set)));
    auto next = std::make_shared<SessionSnapshot>(*panels_.view.session);
    next->state = std::make_shared<const SessionState>(session.state());
    panels_.view.session = next;
  }
}

TEST_F(PanelsRules, ADragShowsItsNumbersAndSetsTheLastOnce) {
  Take({0, 0, 0, 0, 0});
  const Vec2 from = MiddleOf(panels_.Find("Node/sizes[0]"));
  panels_.Frame({PanelPointer{from, true}});
  std::vector<double> tried;
  for (int i = 1; i <= 10; ++i) {
    const PanelOutput& output = panels_.Frame({PanelPointer{from + Vec2(8.0 * i, 0), true}});
    EXPECT_THAT(output.commands, IsEmpty()) << "undo would have to take back every step";
    if (output.trial) tried.push_back(output.trial->value);
  }
  ASSERT_GE(tried.size(), 8u);
  EXPECT_GT(tried.back(), tried.front());
  EXPECT_THAT(panels_.Frame({PanelPointer{from + Vec2(80, 0), false}}).commands,
              ElementsAre(Sent(SetNumber{"sizes[0]", tried.back()})));
}

TEST_F(PanelsRules, APointerThatGoesGivesADragUp) {
  Take({0, 0, 0, 0, 0});
  const Vec2 from = MiddleOf(panels_.Find("Node/sizes[0]"));
  panels_.Frame({PanelPointer{from, true}, PanelPointer{from + Vec2(40, 0), true}});
  EXPECT_THAT(panels_.Frame({PanelPointerGone{}}).commands, IsEmpty());
}

TEST_F(PanelsRules, ATypedNumberMayHaveAUnit) {
  Take({0, 0, 0, 0, 0});
  panels_.Tap("Node/sizes[0]");
  EXPECT_TRUE(panels_.Frame().takes_keys);
  panels_.Type("350 cm");
  EXPECT_THAT(panels_.Key(KEY_ENTER), ElementsAre(Sent(SetNumber{"sizes[0]", 3.5})));
  EXPECT_FALSE(panels_.Frame().takes_keys);
}

TEST_F(PanelsRules, WhatIsNoNumberIsSaidAndSetsNothing) {
  Take({0, 0, 0, 0, 0});
  panels_.Tap("Node/sizes[0]");
  panels_.Type("wide");
  EXPECT_THAT(panels_.Key(KEY_ENTER), IsEmpty());
  EXPECT_TRUE(panels_.Shows("Status/Close the message"));
}

TEST_F(PanelsRules, EscapeGivesUpWhatWasTyped) {
  Take({0, 0, 0, 0, 0});
  panels_.Tap("Node/sizes[0]");
  panels_.Type("9");
  EXPECT_THAT(panels_.Key(KEY_ESC), IsEmpty());
  EXPECT_FALSE(panels_.Frame().takes_keys);
}

TEST_F(PanelsRules, TheUsualNumberComesBackByATap) {
  Take({0, 0});
  EXPECT_THAT(panels_.Tap("Node/Usual distance"), ElementsAre(Sent(SetNumber{"distance", 3})));
}

TEST_F(PanelsRules, ItsQueryAndTheNamesItGivesAreTyped) {
  Take({0, 0, 0});
  panels_.Tap("Node/Acts on");
  panels_.Type(".Mass:north");
  EXPECT_THAT(panels_.Key(KEY_ENTER), ElementsAre(Sent(SetQuery{".Mass:north"})));
  panels_.Tap("Node/Name of Facade");
  panels_.Type("Wall");
  EXPECT_THAT(panels_.Key(KEY_ENTER), ElementsAre(Sent(RenameSymbol{"Facade", "Wall"})));
}

TEST_F(PanelsRules, ANameThatNoCommandCanSayIsComplainedOf) {
  Take({0, 0, 0});
  panels_.Tap("Node/Name of Facade");
  panels_.Type("two words");
  EXPECT_THAT(panels_.Key(KEY_ENTER), IsEmpty());
  EXPECT_TRUE(panels_.Shows("Status/Close the message"));
}

TEST_F(PanelsRules, ATapElsewhereKeepsWhatWasTyped) {
  Take({0, 0, 0});
  panels_.Tap("Node/Name of Facade");
  panels_.Type("Wall");
  const Vec2 beside = MiddleOf(panels_.Find("Tools/Draw")) + Vec2(400, 0);
  panels_.Frame({PanelPointer{beside, true}});
  const auto& commands = panels_.last().commands;
  EXPECT_THAT(commands, ElementsAre(Sent(RenameSymbol{"Facade", "Wall"})));
}

TEST_F(PanelsRules, TappedShapesOfferQueriesAndATapChoosesOne) {
  panels_.view.session = HouseWithTaps(2);
  panels_.view.tapped_px = Vec2(600, 500);
  EXPECT_THAT(panels_.Tap("Queries/1 "), ElementsAre(Sent(SetQuery{"1"})));
  EXPECT_THAT(panels_.Tap("Queries/Select nothing"), ElementsAre(Sent(Select{})));
}

TEST_F(PanelsRules, CardsForANodeInHandNameItAndChangeIt) {
  panels_.view.session = Taken(HouseWithTaps(2), {0, 3});
  panels_.view.tapped_px = Vec2(600, 500);
  EXPECT_TRUE(panels_.Says("What is "));
  EXPECT_TRUE(panels_.Frame().node_shown);
  EXPECT_THAT(panels_.Tap("Queries/1 "), ElementsAre(Sent(SetQuery{"1"})));
}

TEST_F(PanelsRules, WhileTheRulesAreHiddenCardsLetGoOfTheNodeInHand) {
  panels_.view.session = Taken(HouseWithTaps(2), {0, 3});
  panels_.view.tapped_px = Vec2(600, 500);
  panels_.Tap("Menu/Rules");
  EXPECT_FALSE(panels_.Frame().node_shown);
  EXPECT_TRUE(panels_.Says("Which do you mean?"));
  EXPECT_THAT(panels_.Tap("Queries/1 "), ElementsAre(Sent(app::Take{}), Sent(SetQuery{"1"})));
}

TEST_F(PanelsRules, WhatTheNextSketchActsOnIsTakenBack) {
  EXPECT_FALSE(panels_.Shows("Status/Act on anything again"));
  panels_.view.session = Chosen(WholeHouse(), ".Glass");
  EXPECT_TRUE(panels_.Says("What you draw acts on every Glass."));
  EXPECT_THAT(panels_.Tap("Status/Act on anything again"), ElementsAre(Sent(SetQuery{"none"})));
}

}  // namespace
}  // namespace parti::app::tests
