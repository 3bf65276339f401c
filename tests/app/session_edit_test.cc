// Edits of the rules by commands: nodes and trees by their paths, symbols, numbers.
#include <gmock/gmock.h>

#include "grammar/operation.h"
#include "tests/app/session_driver.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Path = NodePath;

/// A tower with floors, and a colour on them:
///   0/0 .Lot extrude   0/1 .Mass comp   0/2 .Facade split   0/3 .Floor color
class SessionEditTest : public ::testing::Test, public SessionDriver {
 protected:
  SessionEditTest() {
    Do("lot rect(20,14)");
    Do("node .Lot --> extrude(12) Mass");
    Do("node .Mass --> comp(f) { side: Facade | top: Roof }");
    Do("node .Facade --> split(y) { { ~3: Floor }* }");
    Do("node .Floor --> color(\"#888888\")");
    Do("take none");
  }
};

TEST_F(SessionEditTest, ATakenNodeIsWhatNumbersQueriesAndNamesChange) {
  Do("take 0/0");
  EXPECT_EQ(state().in_hand, (Path{0, 0}));
  Do("set distance 9");
  EXPECT_EQ(Count(".Floor"), 12u);
  Do("set distance 15 ft");
  EXPECT_THAT(Rules(), HasSubstr("extrude(4.572) Mass"));
  Do("take 0/3");
  Do("query .Floor:even");
  EXPECT_THAT(Rules(), HasSubstr(".Floor:even --> color"));
}

TEST_F(SessionEditTest, RulesAreRewrittenWhole) {
  Do("take 0/3");
  Do("rewrite tree low { .Lot --> extrude(3) Mass } tree on { .Mass --> tag(\"x\") }");
  EXPECT_THAT(Rules(), HasSubstr("tree low {\n  .Lot --> extrude(3) Mass\n}"));
  EXPECT_THAT(state().in_hand, IsEmpty());
  EXPECT_EQ(Count(".Floor"), 0u);
  Do("undo");
  EXPECT_GT(Count(".Floor"), 0u);
  EXPECT_EQ(Refused("rewrite tree low { .Lot --> extrud(3) Mass }").code, ErrorCode::kUnknownName);
}

TEST_F(SessionEditTest, PathsThatLeadNowhereAreRefusedWithWhatThereIs) {
  for (const char* line : {"take 0/4", "take 1/0", "take 0/0/0", "switch 0/9 off", "switch 3 off",
                           "delete 0/4", "delete 1", "move 0/7 to 0/0", "move 0/0 to 0/4",
                           "move 0/0 to 2/0", "move 0 to 1", "rename-tree 1 x"}) {
    const Error error = Refused(line);
    EXPECT_EQ(error.code, ErrorCode::kUnknownName) << line;
  }
  EXPECT_THAT(Refused("take 0/4").hint, HasSubstr("0 has 4 nodes"));
  EXPECT_THAT(Refused("take 2/0").hint, HasSubstr("the building has 1 trees"));
  EXPECT_THAT(Refused("take 0/1/0").hint, HasSubstr("0/1 has no nodes"));
}

TEST_F(SessionEditTest, ATreeIsNoNodeToTakeAndNoneToBecome) {
  EXPECT_THAT(Refused("take 0").message, HasSubstr("tree"));
  EXPECT_EQ(Refused("move 0 to 0/1").code, ErrorCode::kBadArguments);
  EXPECT_EQ(Refused("move 0/1 to 0").code, ErrorCode::kBadArguments);
}

TEST_F(SessionEditTest, ASwitchedOffNodeDoesNotRunAndComesBack) {
  const std::string before = Rules();
  Do("switch 0/2 off");
  EXPECT_EQ(Count(".Floor"), 0u);
  EXPECT_THAT(Rules(), HasSubstr("off .Facade"));
  Do("switch 0/2 on");
  EXPECT_EQ(Rules(), before);
  EXPECT_EQ(Count(".Floor"), 16u);
  Do("switch 0 off");
  EXPECT_EQ(Count("*"), 1u) << "the lot alone";
}

TEST_F(SessionEditTest, ADeletedNodeTakesWhatIsBelowItAndTheHandLetsGo) {
  Do("take 0/3");
  Do("delete 0/2");
  EXPECT_EQ(state().in_hand, (Path{0, 2})) << "the node in hand stays in hand";
  EXPECT_THAT(Rules(), HasSubstr("color"));
  Do("delete 0/2");
  EXPECT_THAT(state().in_hand, IsEmpty());
  Do("delete 0");
  EXPECT_THAT(state().model.trees(), IsEmpty());
  Do("undo");
  Do("undo");
  Do("undo");
  EXPECT_EQ(Count(".Floor"), 16u) << "nothing is lost";
}

TEST_F(SessionEditTest, AMovedNodeStandsWhereItWasSentAndStaysInHand) {
  Do("take 0/3");
  Do("move 0/3 to 0/2/0");
  EXPECT_EQ(state().in_hand, (Path{0, 2, 0}));
  EXPECT_THAT(Rules(), HasSubstr("{ { ~3: Floor }* } {\n    .Floor --> color"));
  Do("move 0/0 to 0/2");
  EXPECT_EQ(state().in_hand, (Path{0, 1, 0}));
  EXPECT_THAT(Rules(), HasSubstr("}\n  .Lot --> extrude(12) Mass\n}"));
  EXPECT_EQ(Refused("move 0/1 to 0/1/0/0").code, ErrorCode::kUnknownName)
      << "a node can't stand below itself";
}

TEST_F(SessionEditTest, WhatCouldNotBeReadAgainIsRefused) {
  EXPECT_EQ(Refused("tree \xff").code, ErrorCode::kBadText);
  EXPECT_EQ(Refused("rename-tree 0 \xc3(").code, ErrorCode::kBadText);
  Do("rewrite tree deep { .Lot --> extrude(1) A }");
  std::string place = "0/0";
  for (int i = 1; i < grammar::kDeepestNode; ++i) {
    Do("node .X --> color(\"red\")");
    Do("move 0/1 to " + (place += "/0"));
  }
  ASSERT_TRUE(grammar::ParseTrees(Rules())) << "200 deep";
  Do("node .X --> color(\"red\")");
  EXPECT_EQ(Refused("move 0/1 to " + place + "/0").code, ErrorCode::kLimitReached);
}

TEST_F(SessionEditTest, TreesAreAddedRenamedReorderedAndSwitched) {
  Do("tree street furniture");
  Do("rename-tree 1 trees and lamps");
  Do("move 1 to 0");
  ASSERT_THAT(state().model.trees(), SizeIs(2));
  EXPECT_EQ(state().model.trees()[0].name, "trees and lamps");
  EXPECT_EQ(grammar::TextOf(*grammar::ParseTrees(Rules())), Rules()) << "names with blanks too";
  Do("delete 0");
  EXPECT_EQ(Count(".Floor"), 16u);
}

TEST_F(SessionEditTest, RenamingEverywhereRewritesEveryQuery) {
  Do("node .Facade:south > .Floor:within(.Facade:north, 3) --> tag(\"near\")");
  Do("node .Floor --> symbol(\"Facade\")");
  Do("switch 0/5 off");
  Do("rename-symbol Facade Wall");
  EXPECT_THAT(Rules(), ::testing::Not(HasSubstr("Facade")));
  EXPECT_THAT(Rules(), HasSubstr(".Wall:south > .Floor:within(.Wall:north, 3)"));
  EXPECT_THAT(Rules(), HasSubstr("symbol(\"Wall\")"));
  EXPECT_EQ(Count(".Wall"), 4u);
  EXPECT_EQ(Count(".Floor"), 16u);
}

TEST_F(SessionEditTest, NamesThatCannotBeSaySo) {
  EXPECT_THAT(Refused("rename-symbol Facad Wall").hint, HasSubstr("'Facade'"));
  EXPECT_EQ(Refused("rename-symbol Lot Plot").code, ErrorCode::kBadText);
  EXPECT_EQ(Refused("rename-symbol Floor NIL").code, ErrorCode::kBadText);
  EXPECT_EQ(Refused("rename-symbol Floor 1st").code, ErrorCode::kBadText);
  Do("take 0/2");
  EXPECT_EQ(Refused("name Floor NIL").code, ErrorCode::kBadText);
  EXPECT_THAT(Refused("name Facade Wall").hint, HasSubstr("Floor"));
}

TEST_F(SessionEditTest, ANameOfOneNodeIsFollowedByQueriesUnlessAnotherGivesItToo) {
  Do("take 0/2");
  Do("name Floor Storey");
  EXPECT_THAT(Rules(), HasSubstr(".Storey --> color")) << "no other node gives it";
  Do("node .Roof --> offset(-1) { inside: Storey | border: Edge }");
  Do("take 0/2");
  Do("name Storey Level");
  EXPECT_THAT(Rules(), HasSubstr(".Storey --> color")) << "the roof still gives it";
}

TEST_F(SessionEditTest, AnEditedNodeThatCanActOnNothingIsRefused) {
  Do("node .Roof --> extrude(3) Attic");
  const Error error = Refused("query .Mass");
  EXPECT_EQ(error.code, ErrorCode::kWrongItemType);
  EXPECT_THAT(error.message, HasSubstr("extrude"));
  EXPECT_EQ(Refused("node .Mass --> offset(1) { inside: A }").code, ErrorCode::kWrongItemType);
}

TEST_F(SessionEditTest, NodesThatAnEditBreaksStayAndAreProblems) {
  Do("rename-symbol Roof Deck");
  Do("node .Deck --> extrude(3) Attic");
  Do("take 0/0");
  Do("name Mass Deck");  // now the extrusion meets a volume, too
  const auto problems = ProblemsOf(state().model);
  ASSERT_THAT(problems, SizeIs(1));
  EXPECT_EQ(problems[0].path, (Path{0, 4}));
  EXPECT_EQ(problems[0].shapes, 1u);
  EXPECT_EQ(problems[0].error.code, ErrorCode::kWrongItemType);
  EXPECT_THAT(Rules(), HasSubstr(".Deck --> extrude(3) Attic")) << "nothing is lost";
  Do("undo");
  EXPECT_THAT(ProblemsOf(state().model), IsEmpty());
}

TEST_F(SessionEditTest, UndoGoesThroughEdits) {
  const std::string before = Rules();
  for (const char* line : {"take 0/0", "set distance 9", "switch 0/3 off", "move 0/3 to 0/2/0",
                           "rename-symbol Floor Level", "tree other", "delete 0/1"}) {
    Do(line);
  }
  const std::string after = Rules();
  for (int i = 0; i < 6; ++i) Do("undo");
  EXPECT_EQ(Rules(), before);
  for (int i = 0; i < 6; ++i) Do("redo");
  EXPECT_EQ(Rules(), after);
}

}  // namespace
}  // namespace parti::app
