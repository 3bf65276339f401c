#include "app/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session_commands.h"
#include "grammar/operation.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr const char* kOverview = "view eye 42 17 47 target 10 8.5 7 fov 36 size 1600 1000";

/// A line of the world as a steady hand draws it in the session's view: 40 samples, 10 ms apart.
Stroke Drawn(const Session& session, const Vec3& a, const Vec3& b) {
  const View view(session.state().camera);
  const Vec2 from = *view.Project(a), to = *view.Project(b);
  Stroke stroke;
  for (int i = 0; i < 40; ++i) {
    const double s = 0.5 - 0.5 * std::cos(kPi * i / 39);  // slow, fast, slow
    stroke.push_back({from + (to - from) * s, 0.01 * i});
  }
  return stroke;
}

class SessionTest : public ::testing::Test {
 protected:
  SessionTest() {
    Do(kOverview);
    Do("lot rect(20,14)");
  }

  void Do(const std::string& line) {
    const auto command = ParseCommand(line);
    ASSERT_TRUE(command) << line;
    const auto done = session_.Execute(*command);
    ASSERT_TRUE(done) << line << ": " << done.error().message;
  }
  Error Refused(const std::string& line) {
    const std::string before = Rules();
    const auto done = session_.Execute(*ParseCommand(line));
    EXPECT_FALSE(done) << line;
    EXPECT_EQ(Rules(), before) << "a command that fails changes nothing";
    return done ? Error{ErrorCode::kNothingMade, ""} : done.error();
  }
  void Draw(const Vec3& a, const Vec3& b) {
    const auto read = session_.AddStroke(Drawn(session_, a, b));
    ASSERT_TRUE(read) << read.error().message;
  }
  void BuildTower() {
    Draw({20, 0, 14}, {20, 19, 14});
    Do("pick 1 extrude");
  }
  std::string Rules() const { return grammar::TextOf(session_.state().model.trees()); }

  Session session_;
};

TEST_F(SessionTest, ALineUpFromTheLotIsAnExtrusionOfIt) {
  Draw({20, 0, 14}, {20, 19, 14});
  const Sketch& sketch = session_.state().sketch;
  ASSERT_TRUE(sketch.target);
  EXPECT_EQ(IdOf(session_.state().model, *sketch.target), ".");
  ASSERT_THAT(sketch.suggestions, Not(IsEmpty()));
  EXPECT_EQ(sketch.suggestions[0].action.operation->name, "extrude");
  EXPECT_THAT(Rules(), IsEmpty()) << "nothing is built before it is picked";
}

TEST_F(SessionTest, APickedSuggestionBecomesANodeUnderTheOneThatMadeItsTarget) {
  BuildTower();
  Draw({0, 19, 14}, {20, 19, 14});
  Draw({20, 19, 14}, {20, 19, 0});
  Do("pick 1 comp");
  const auto& trees = session_.state().model.trees();
  ASSERT_THAT(trees, SizeIs(1));
  ASSERT_THAT(trees[0].nodes, SizeIs(1));
  ASSERT_THAT(trees[0].nodes[0].children, SizeIs(1));
  EXPECT_EQ(grammar::TextOf(trees[0].nodes[0].children[0].query), ".Mass");
  EXPECT_THAT(session_.state().sketch.strokes, IsEmpty());
}

TEST_F(SessionTest, LinesDrawnInTwoViewsBelongTogether) {
  BuildTower();
  Draw({0, 19, 14}, {20, 19, 14});
  Do("view eye 60 30 -20 target 10 8 7 fov 40 size 1600 1000");
  Draw({20, 19, 14}, {20, 19, 0});
  EXPECT_THAT(session_.state().sketch.strokes, SizeIs(2));
  EXPECT_EQ(session_.state().sketch.suggestions.at(0).action.operation->name, "comp");
}

TEST_F(SessionTest, UndoAndRedoGoThroughStrokesAndPicksButNotViews) {
  BuildTower();
  const std::string built = Rules();
  Do("view eye 60 30 -20 target 10 8 7 fov 40 size 1600 1000");
  Do("undo");
  EXPECT_THAT(Rules(), IsEmpty());
  EXPECT_THAT(session_.state().sketch.suggestions, Not(IsEmpty())) << "the sketch is back";
  EXPECT_EQ(session_.state().camera.eye, Vec3(60, 30, -20)) << "looking is not undone";
  Do("undo");
  EXPECT_THAT(session_.state().sketch.strokes, IsEmpty());
  Do("redo");
  Do("redo");
  EXPECT_EQ(Rules(), built);
  EXPECT_EQ(Refused("redo").message, "nothing to redo");
}

TEST_F(SessionTest, ANewDeedEndsRedo) {
  BuildTower();
  Do("undo");
  Do("clear");
  EXPECT_EQ(Refused("redo").message, "nothing to redo");
}

TEST_F(SessionTest, TheNodeJustMadeCanBeRenamedRetargetedAndSized) {
  BuildTower();
  Do("name Mass Tower");
  Do("set distance 21.5");
  Do("query .Lot:up");
  EXPECT_EQ(Rules(), "tree structure {\n  .Lot:up --> extrude(21.5) Tower\n}\n");
}

TEST_F(SessionTest, EditsThatCannotBeSayWhatThereIs) {
  EXPECT_EQ(Refused("name A B").code, ErrorCode::kNothingMade);
  BuildTower();
  EXPECT_THAT(Refused("name Tower B").hint, HasSubstr("Mass"));
  EXPECT_EQ(Refused("name Mass 3rd").code, ErrorCode::kBadText);
  EXPECT_THAT(Refused("set height 3").hint, HasSubstr("distance"));
  EXPECT_EQ(Refused("query .Lot:nroth").code, ErrorCode::kUnknownName);
  EXPECT_FALSE(Refused("node .Mass --> exrtude(3)").hint.empty());
}

TEST_F(SessionTest, ATypedNodeActsAfterWhatWasDrawn) {
  BuildTower();
  Do("node .Mass --> comp(f) { top: Roof | side: Facade }");
  EXPECT_THAT(VisibleShapes(session_.state().model), SizeIs(5));
}

TEST_F(SessionTest, ASuggestionThatIsNotThereIsRefused) {
  EXPECT_EQ(Refused("pick 1").code, ErrorCode::kUnknownName);
  Draw({20, 0, 14}, {20, 19, 14});
  EXPECT_THAT(Refused("pick 99").hint, HasSubstr("suggestion"));
  SessionState one = session_.state();
  one.sketch.suggestions.resize(1);
  const auto refused = After(one, *ParseCommand("pick 2"), {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().hint, "this sketch has 1 suggestion");
  EXPECT_EQ(Refused("pick 1 taper").code, ErrorCode::kUnknownName);
}

TEST_F(SessionTest, ATapIsKeptAsInkAndSaysWhy) {
  const auto read = session_.AddStroke({{Vec2(800, 500), 0.0}});
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kTooShort);
  EXPECT_THAT(session_.state().sketch.unread, SizeIs(1));
  EXPECT_THAT(session_.state().sketch.strokes, IsEmpty());
}

TEST_F(SessionTest, AStrokeThatFitsNothingIsKeptAsInkOnly) {
  const auto read = session_.AddStroke(StrokeFrom("20,20 24,21 28,19 32,22"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kNoFit);
  EXPECT_THAT(session_.state().sketch.unread, SizeIs(1));
  EXPECT_THAT(session_.state().sketch.suggestions, IsEmpty());
}

TEST_F(SessionTest, HistoryHoldsEverythingInOrder) {
  BuildTower();
  Do("undo");
  const auto& history = session_.history();
  ASSERT_THAT(history, SizeIs(5));
  EXPECT_TRUE(history[2].stroke);
  EXPECT_EQ(TextOf(*history[3].command), "pick 1 extrude");
  EXPECT_EQ(TextOf(*history[4].command), "undo");
}

}  // namespace
}  // namespace parti::app
