// The shipped demo, from pen to building: as a file, and through the real libinput.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/document.h"
#include "app/export_glb.h"
#include "app/picture.h"
#include "app/replay.h"
#include "base/text_file.h"
#include "grammar/operation.h"
#include "tests/pen/house_plan.h"
#include "tests/support/data.h"
#include "tests/support/evdev_from_drawing.h"
#include "tests/support/golden.h"
#include "tests/support/mock_tablet.h"

namespace parti::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string ShippedText() {
  const auto text = ReadFile(SourceFile("assets/drawings/house.pen"));
  EXPECT_TRUE(text) << text.error().message;
  return text.value_or("");
}

app::Session Played(const input::Drawing& drawing) {
  app::Session session({.keep_steps = true});
  app::ReplayReport report;
  const auto played = app::Replay(drawing, &session, &report);
  EXPECT_TRUE(played) << FormatError(played.error());
  EXPECT_THAT(report.unread, IsEmpty());
  return session;
}

/// "  .Lot --> extrude" …: which operation acts on what, without numbers.
std::vector<std::string> Structure(const std::vector<grammar::SelectionActionNode>& nodes,
                                   const std::string& indent = "") {
  std::vector<std::string> lines;
  for (const auto& node : nodes) {
    std::string line =
        indent + grammar::TextOf(node.query) + " " + std::string(node.action.operation->name);
    for (const auto& s : node.action.successors) line += " " + s.symbol;
    if (!node.action.symbol.empty()) line += " " + node.action.symbol;
    lines.push_back(line);
    const auto below = Structure(node.children, indent + "  ");
    lines.insert(lines.end(), below.begin(), below.end());
  }
  return lines;
}

const auto kHouse = ElementsAre(                       //
    ".Lot extrude Mass",                               //
    "  .Mass comp Facade Roof",                        //
    "    .Facade split Ground CenterFloors TopFloor",  //
    "      .CenterFloors repeat Floor",                //
    "        .Floor repeat WindowBlock",               //
    "          .WindowBlock offset Glass Frame",       //
    "      .Ground repeat Bay",                        //
    "        .Bay offset Glass Frame",                 //
    "    .Roof offset RoofInner RoofBorder",           //
    "      .RoofInner extrude Penthouse",              //
    ".Frame extrude",                                  //
    ".RoofBorder extrude",                             //
    ".Glass color");

/// Every number of the rules, in reading order.
std::vector<double> Numbers(std::vector<grammar::SelectionActionNode>* nodes) {
  std::vector<double> numbers;
  for (auto& node : *nodes) {
    for (const grammar::Dial& dial : grammar::Dials(&node.action)) numbers.push_back(*dial.value);
    const auto below = Numbers(&node.children);
    numbers.insert(numbers.end(), below.begin(), below.end());
  }
  return numbers;
}

std::vector<double> Numbers(grammar::Trees trees) { return Numbers(&trees.front().nodes); }

TEST(HouseTest, TheShippedDrawingIsTheOneThatTheSyntheticHandDraws) {
  const auto text = input::WriteDrawing(HouseDrawing(1));
  ASSERT_TRUE(text);
  EXPECT_TRUE(*text == ShippedText()) << "draw it anew: parti_draw_house assets/drawings/house.pen";
}

TEST(HouseTest, TheDrawingBecomesTheHouseAndItsRules) {
  const auto reading = input::ReadDrawing(ShippedText());
  ASSERT_FALSE(reading.damage);
  const app::Session session = Played(reading.drawing);
  const app::Model& model = session.state().model;
  ASSERT_THAT(model.trees(), SizeIs(1));
  EXPECT_THAT(Structure(model.trees()[0].nodes), kHouse);
  EXPECT_EQ(session.strokes_drawn(), 23u);
  EXPECT_EQ(session.state().steps.size(), 10u);
}

TEST(HouseTest, TheRulesHaveTheSizesThatWereDrawn) {
  const app::Session session = Played(HouseDrawing(1));
  // Within what the hand's scatter allows: 6 % and 10 cm.
  const std::vector<double> drawn = {19, 4, 1, 3, 3, 2.5, -0.5, 4, -0.5, -2, 4, 0.15, 0.6};
  const std::vector<double> numbers = Numbers(session.state().model.trees());
  ASSERT_EQ(numbers.size(), drawn.size());
  for (size_t i = 0; i < drawn.size(); ++i) {
    EXPECT_NEAR(numbers[i], drawn[i], 0.06 * std::abs(drawn[i]) + 0.1) << "number " << i;
  }
}

TEST(HouseTest, EveryFloorOfEveryFacadeHasItsWindows) {
  const app::Session session = Played(HouseDrawing(1));
  const grammar::ShapeTree& tree = session.state().model.derived[0]->tree;
  const auto count = [&](const char* query) {
    return grammar::ProductOf(*grammar::ParseQuery(query), tree)->size();
  };
  EXPECT_EQ(count(".Facade"), 4u);
  EXPECT_EQ(count(".Floor"), 16u);
  // Façades of 20 m and 14 m, blocks of 2.5 m stretched to fit: 8 and 6 (5.6) to a floor.
  EXPECT_EQ(count(".WindowBlock"), 4u * (8 + 8 + 6 + 6));
  EXPECT_EQ(count(".CenterFloors > .Glass"), count(".WindowBlock"));
  EXPECT_EQ(count(".Penthouse"), 1u);
}

TEST(HouseTest, OtherHandsDrawTheSameHouse) {
  for (uint64_t seed = 2; seed < 13; ++seed) {
    const app::Session session = Played(HouseDrawing(seed));
    ASSERT_THAT(session.state().model.trees(), SizeIs(1)) << seed;
    EXPECT_THAT(Structure(session.state().model.trees()[0].nodes), kHouse) << seed;
  }
}

TEST(HouseTest, TheSameDrawingGivesTheSameRules) {
  EXPECT_EQ(grammar::TextOf(Played(HouseDrawing(1)).state().model.trees()),
            grammar::TextOf(Played(HouseDrawing(1)).state().model.trees()));
}

TEST(HouseTest, ThePictureIsTheOneThatWasLookedAt) {
  const app::Session session = Played(HouseDrawing(1));
  const auto image = app::PictureOf(session.state());
  ASSERT_TRUE(image) << image.error().message;
  ExpectGolden(*image, "house");
}

TEST(HouseTest, ThroughTheRealLibinputItIsTheSameHouse) {
  const input::Drawing drawn = HouseDrawing(1);
  const auto recording = EvdevFromDrawing(drawn);
  ASSERT_TRUE(recording) << recording.error().message;
  auto seen = PlayThroughLibinput(*recording);
  ASSERT_TRUE(seen) << FormatError(seen.error());
  // The device stream is libinput's; the commands are the drawing's (docs/drawings.md).
  seen->commands = drawn.commands;
  const app::Session session = Played(*seen);
  const app::Session direct = Played(drawn);
  ASSERT_THAT(session.state().model.trees(), SizeIs(1));
  EXPECT_THAT(Structure(session.state().model.trees()[0].nodes), kHouse);
  const auto numbers = Numbers(session.state().model.trees());
  const auto expected = Numbers(direct.state().model.trees());
  ASSERT_EQ(numbers.size(), expected.size());
  for (size_t i = 0; i < numbers.size(); ++i) EXPECT_NEAR(numbers[i], expected[i], 0.05) << i;
  const auto image = app::PictureOf(session.state());
  ASSERT_TRUE(image) << image.error().message;
  ExpectGolden(*image, "house");
}

std::string Glb(const app::Model& model) {
  const auto mesh = app::ModelMeshFrom(model.derived[0]->tree);
  return app::GltfBytes(mesh, app::GltfForm::kBinary).value_or("");
}

TEST(HouseTest, SavedAndReopenedItIsTheSameDocument) {
  const app::Session session = Played(HouseDrawing(1));
  const std::string path = ::testing::TempDir() + "/house_test.parti";
  const std::string again = ::testing::TempDir() + "/house_test_again.parti";
  const app::Document saved = app::DocumentOf(session);
  ASSERT_TRUE(app::SaveDocument(saved, path));
  const auto opened = app::OpenDocument(path);
  ASSERT_TRUE(opened) << FormatError(opened.error());
  const app::SessionRecord& present = app::PresentOf(*opened);
  EXPECT_EQ(*present.rules, session.state().model.trees());
  EXPECT_EQ(opened->history, saved.history);
  EXPECT_EQ(present.camera, session.state().camera);
  ASSERT_EQ(opened->strokes.size(), saved.strokes.size());
  for (size_t i = 0; i < saved.strokes.size(); ++i) {
    EXPECT_EQ(opened->strokes[i]->stroke, saved.strokes[i]->stroke);
    EXPECT_EQ(opened->strokes[i]->camera, saved.strokes[i]->camera);
  }
  const auto reopened = app::BuiltOn(present.ground->lots, *present.rules);
  ASSERT_TRUE(reopened);
  EXPECT_EQ(Glb(*reopened), Glb(session.state().model)) << "the same building, to the byte";
  ASSERT_TRUE(app::SaveDocument(*opened, again));
  EXPECT_EQ(*ReadFile(path), *ReadFile(again));
}

}  // namespace
}  // namespace parti::tests
