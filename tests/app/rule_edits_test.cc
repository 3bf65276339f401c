// Rule files changed by commands: their text, their layers; undone, replayed, kept and reopened.
#include "app/rule_edits.h"

#include <gmock/gmock.h>

#include "app/document.h"
#include "tests/app/placing_support.h"
#include "tests/app/session_driver.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr std::string_view kHouse = R"(// a house with a door
import roof : "roof.cga"
attr height = 6
@StartRule
Lot --> extrude(height) Mass
Mass --> comp(f) { front: Facade | top: roof.Flat }
Facade --> layers("floors", "door") { Floors | Door }
Floors --> segment(y) { ~3: Floor }*
Floor --> extrude(0.2) Ledge
Door --> segment(x, ~1, 2, ~1) { NIL | Leaf | NIL }
Leaf --> extrude(0.1) Wood
Gate --> segment(x, 1, ~1) { NIL | Wide }
Wide --> extrude(0.1) Wood
)";

RuleSource HouseSource() {
  RuleSource source;
  source.files = {{"house.cga", std::string(kHouse)}, {"roof.cga", "Flat --> extrude(0.3) Slab\n"}};
  return source;
}

Session HouseSession() {
  auto ground =
      GroundOf(*ParseLots("rect(12,8)"), std::make_shared<const RuleSource>(HouseSource()));
  EXPECT_TRUE(ground) << FormatError(ground.error());
  auto model = Derived(std::move(*ground), std::make_shared<const grammar::Trees>(), nullptr);
  EXPECT_TRUE(model);
  return Session(std::move(*model), Camera());
}

/// The house's text with one part of it replaced.
std::string HouseWith(const std::string& part, const std::string& by) {
  std::string text(kHouse);
  text.replace(text.find(part), part.size(), by);
  return text;
}

class RuleEditsTest : public ::testing::Test, public SessionDriver {
 protected:
  RuleEditsTest() { session = HouseSession(); }

  static std::string Typed(std::string text, std::string file = "house.cga") {
    return TextOf(SetRuleText{std::move(file), std::move(text)});
  }
  const RuleSource& Source() const { return *state().model.ground->source; }
};

TEST_F(RuleEditsTest, AnotherTextIsDerivedAndUndone) {
  EXPECT_EQ(Count(".Floor"), 2u);
  Do(Typed(HouseWith("height = 6", "height = 12")));
  EXPECT_EQ(Count(".Floor"), 4u);
  EXPECT_THAT(Source().files[0].text, HasSubstr("height = 12"));
  Do("undo");
  EXPECT_EQ(Count(".Floor"), 2u);
  EXPECT_EQ(Source().files[0].text, kHouse) << "to the byte, its comment too";
  Do("redo");
  EXPECT_EQ(Count(".Floor"), 4u);
}

TEST_F(RuleEditsTest, AnImportedFileIsChangedAlone) {
  Do(Typed("Flat --> extrude(2) Slab\n", "roof.cga"));
  EXPECT_EQ(Source().files[0].text, kHouse);
  EXPECT_EQ(Source().files[1].text, "Flat --> extrude(2) Slab\n");
  EXPECT_EQ(Count(".Slab"), 1u);
}

TEST_F(RuleEditsTest, TextThatCannotBeReadIsRefusedWithAllThatIsWrong) {
  std::string text = HouseWith("extrude(0.2) Ledge", "extrud(0.2) Ledge");
  text += "Wall --> splt(x) { 1: A }\n";
  const Error error = Refused(Typed(text));
  EXPECT_EQ(Source().files[0].text, kHouse);
  ASSERT_TRUE(error.place);
  EXPECT_EQ(error.place->line, 9);
  EXPECT_THAT(error.message, AllOf(HasSubstr("extrud"), HasSubstr("; 14:10: "), HasSubstr("splt")));
}

TEST_F(RuleEditsTest, TextThatCannotBeDerivedIsRefused) {
  EXPECT_THAT(Refused(Typed(HouseWith("extrude(height)", "extrude(-height / 0)"))).message,
              HasSubstr("Lot"));
  EXPECT_EQ(Refused(Typed("")).code, ErrorCode::kUnknownName) << "no rule to start with";
  EXPECT_EQ(Refused(Typed(HouseWith("roof.cga", "cellar.cga"))).code, ErrorCode::kFile);
  EXPECT_EQ(Count(".Floor"), 2u);
}

TEST_F(RuleEditsTest, OnlyFilesThatThereAreCanBeChanged) {
  const Error error = Refused(Typed("Lot --> extrude(1)", "hous.cga"));
  EXPECT_EQ(error.code, ErrorCode::kUnknownName);
  EXPECT_THAT(error.hint, HasSubstr("'house.cga'"));
  session = Session();
  EXPECT_EQ(Refused(Typed("Lot --> extrude(1)")).code, ErrorCode::kNothingMade);
  EXPECT_EQ(Refused("layers {}").code, ErrorCode::kNothingMade);
}

TEST_F(RuleEditsTest, LayersAreSwitchedOffReorderedAndGivenOtherRules) {
  Do(R"(layers {"off":["Facade.door"]})");
  EXPECT_EQ(Count(".Leaf"), 0u);
  EXPECT_EQ(Count(".Floor"), 2u);
  Do(R"(layers {"order":[["Facade",["door","floors"]]],"rules":[["Facade.door","Gate"]]})");
  EXPECT_EQ(Count(".Leaf"), 0u) << "now under the floors, and a gate";
  EXPECT_EQ(Count(".Gate"), 1u);
  Do("undo");
  Do("undo");
  EXPECT_EQ(Count(".Leaf"), 1u);
  EXPECT_EQ(Source().layers, grammar::LayerEdits());
  EXPECT_EQ(Source().files[0].text, kHouse) << "the text stays as it is";
}

TEST_F(RuleEditsTest, LayersThatThereAreNotAreRefused) {
  EXPECT_THAT(Refused(R"(layers {"off":["Facade.dor"]})").hint, HasSubstr("'Facade.door'"));
  EXPECT_THAT(Refused(R"(layers {"rules":[["Facade.door","Gat"]]})").hint, HasSubstr("'Gate'"));
}

TEST_F(RuleEditsTest, ALayerIsChangedAloneAndOfTheNewestText) {
  Do("layer Facade.door gets Gate");
  Do("layer Facade.floors off");
  Do("layer Facade.door down");
  Do("layer Facade.door down");
  EXPECT_EQ(TextOf(Source().layers),
            R"({"off":["Facade.floors"],"order":[["Facade",["door","floors"]]],)"
            R"("rules":[["Facade.door","Gate"]]})");
  Do(Typed(HouseWith(R"(layers("floors", "door") { Floors | Door })",
                     R"(layers("floors", "door", "sign") { Floors | Door | Leaf })")));
  Do("layer Facade.door up");
  Do("layer Facade.door up");
  Do("layer Facade.door up");
  Do("layer Facade.door as-written");
  Do("layer Facade.floors on");
  EXPECT_EQ(TextOf(Source().layers), R"({"order":[["Facade",["floors","sign","door"]]]})");
  EXPECT_EQ(Count(".Gate"), 0u);
  Do("undo");
  EXPECT_EQ(Count(".Floor"), 0u);
}

TEST_F(RuleEditsTest, ALayerThatIsNotThereIsNotChanged) {
  EXPECT_THAT(Refused("layer Facade.dor off").hint, HasSubstr("'Facade.door'"));
  EXPECT_THAT(Refused("layer Facade.dor up").hint, HasSubstr("'Facade.door'"));
  EXPECT_THAT(Refused("layer Facade.door gets Gat").hint, HasSubstr("'Gate'"));
  session = Session();
  EXPECT_EQ(Refused("layer Facade.door off").code, ErrorCode::kNothingMade);
}

TEST_F(RuleEditsTest, TheFaceInHandStaysSoAsFarAsItIsThere) {
  const auto shape = [&](std::string_view query) {
    const auto& tree = state().model.derived.at(0)->tree;
    return tree.IdOf(grammar::ProductOf(*grammar::ParseQuery(query), tree)->at(0));
  };
  const std::string facade = shape(".Facade");
  Do("select " + shape(".Wood"));
  Do(R"(layers {"off":["Facade.door"]})");
  ASSERT_THAT(state().selection.shapes, SizeIs(1));
  EXPECT_EQ(IdOf(state().model, state().selection.shapes[0]), facade) << "what the leaf was in";
  Do(Typed(HouseWith("front: Facade", "front: Wall")));
  EXPECT_THAT(state().selection.shapes, SizeIs(1)) << "its mass";
  Do("layers {}");
  Do(Typed("@StartRule\nLot --> color(\"#808080\")\n"));
  EXPECT_THAT(state().selection.shapes, IsEmpty()) << "never the lot";
}

TEST_F(RuleEditsTest, TreesOfTheTextFollowItsEditsAndOthersStay) {
  Do("node .Slab --> color(\"#804020\")");
  Do(Typed(HouseWith("height = 6", "height = 9")));
  EXPECT_THAT(Rules(), HasSubstr("#804020")) << "the text has no trees";
  Do(Typed(std::string(kHouse) + "tree paint { .Slab --> color(\"#112233\") }\n"));
  EXPECT_THAT(Rules(), AllOf(HasSubstr("#112233"), Not(HasSubstr("#804020"))));
  Do("undo");
  EXPECT_THAT(Rules(), HasSubstr("#804020"));
}

TEST_F(RuleEditsTest, WhatWasTypedIsInTheDocumentWithItsUndo) {
  const std::string path = parti::tests::TestFolder() + "/house.parti";
  Do(Typed(HouseWith("height = 6", "height = 12")));
  Do(R"(layers {"off":["Facade.door"]})");
  ASSERT_TRUE(SaveDocument(DocumentOf(session), path));
  const auto document = OpenDocument(path);
  ASSERT_TRUE(document) << FormatError(document.error());
  EXPECT_THAT(document->history, SizeIs(2));
  auto reopened = SessionOf(*document, {});
  ASSERT_TRUE(reopened) << FormatError(reopened.error());
  session = std::move(*reopened);
  EXPECT_EQ(Count(".Floor"), 4u);
  EXPECT_EQ(Count(".Leaf"), 0u);
  Do("undo");
  EXPECT_EQ(Count(".Leaf"), 1u);
  Do("undo");
  EXPECT_EQ(Source().files[0].text, kHouse);
  EXPECT_EQ(Count(".Floor"), 2u);
}

TEST_F(RuleEditsTest, DistantStepsKeepNoShapesAndAreDerivedAgain) {
  SessionOptions little;
  little.undo.bytes = 100'000;
  session = Session(session.state().model, Camera(), little);
  for (int height = 7; height < 27; ++height) {
    Do(Typed(HouseWith("height = 6", "height = " + std::to_string(height))));
  }
  const auto& first = session.timeline().step(session.timeline().span().first);
  EXPECT_FALSE(first.state);
  EXPECT_THAT(first.record.ground->roots, IsEmpty());
  EXPECT_EQ(Count(".Floor"), 9u);
  for (int i = 0; i < 20; ++i) Do("undo");
  EXPECT_EQ(Count(".Floor"), 2u);
  for (int i = 0; i < 20; ++i) Do("redo");
  EXPECT_EQ(Count(".Floor"), 9u);
}

TEST_F(RuleEditsTest, TheHistoryReplayedMakesTheSameBuilding) {
  Do(Typed(HouseWith("height = 6", "height = 12")));
  Do(R"(layers {"rules":[["Facade.door","Gate"]]})");
  Do("undo");
  Session again = HouseSession();
  for (const HistoryEntry& entry : session.history()) {
    ASSERT_TRUE(again.Execute(*ParseCommand(TextOf(*entry.command))));
  }
  EXPECT_EQ(TextOf(*again.state().model.ground->source), TextOf(Source()));
  EXPECT_EQ(again.state().model.derived[0]->tree.size(), state().model.derived[0]->tree.size());
}

TEST_F(RuleEditsTest, AnElementIsPlacedByItsNumbers) {
  session = Session(tests::HouseBy(tests::SourceOf(tests::kPlacedRules)), Camera());
  Do("place Door left 6 height 2");
  std::string text = tests::kPlacedRules;
  text.replace(text.find("door_left = 4"), 13, "door_left = 6");
  text.replace(text.find("y, 0, 2.5"), 9, "y, 0, 2");
  EXPECT_EQ(Source().files[0].text, text);
  const Error error = Refused("place Dor left 6");
  EXPECT_EQ(error.code, ErrorCode::kUnknownName);
  EXPECT_THAT(error.hint, HasSubstr("Windows, Door"));
}

}  // namespace
}  // namespace parti::app
