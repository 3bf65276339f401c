// Named views, erased strokes, tapped shapes and the queries offered for them.
#include <gmock/gmock.h>

#include "grammar/operation.h"
#include "tests/app/session_driver.h"

namespace parti::app {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr const char* kOverview = "view eye 42 17 47 target 10 8.5 7 fov 36 size 1600 1000";
constexpr const char* kOther = "view eye 60 30 -20 target 10 8 7 fov 40 size 800 600";

class SessionViewTest : public ::testing::Test, public SessionDriver {
 protected:
  SessionViewTest() {
    Do(kOverview);
    Do("lot rect(20,14)");
  }
  void BuildTower() {
    Do("node .Lot --> extrude(19) Mass");
    Do("node .Mass --> comp(f) { side: Facade | top: Roof }");
    Do("node .Facade --> split(y) { { ~4: Floor }* }");
    Do("take none");
  }
};

TEST_F(SessionViewTest, AKeptViewIsGoneBackToInAPictureOfThePresentSize) {
  Do("keep-view street corner");
  const Vec3 eye = state().camera.eye;
  Do(kOther);
  Do("go-view street corner");
  EXPECT_EQ(state().camera.eye, eye);
  EXPECT_EQ(state().camera.width_px, 800);
}

TEST_F(SessionViewTest, KeepingIsUndoneButLookingIsNot) {
  Do("keep-view a");
  Do(kOther);
  Do("keep-view a");
  ASSERT_THAT(state().views, SizeIs(1)) << "kept anew";
  EXPECT_EQ(state().views[0].camera.eye.x, 60);
  Do("undo");
  EXPECT_EQ(state().views[0].camera.eye.x, 42);
  EXPECT_EQ(state().camera.eye.x, 60) << "looking is not undone";
  Do("drop-view a");
  EXPECT_THAT(state().views, IsEmpty());
  EXPECT_EQ(Refused("redo").message, "nothing to redo");
}

TEST_F(SessionViewTest, LookingKeepsWhatCanBeRedone) {
  BuildTower();
  Do("undo");
  Do(kOther);
  Do("take 0/0");
  Do("redo");
  EXPECT_EQ(Count(".Floor"), 20u);
}

TEST_F(SessionViewTest, ViewsThatAreNotThereAreNamed) {
  EXPECT_THAT(Refused("go-view street").hint, HasSubstr("keep-view"));
  Do("keep-view street");
  EXPECT_THAT(Refused("go-view steret").hint, HasSubstr("'street'"));
  EXPECT_EQ(Refused("drop-view north").code, ErrorCode::kUnknownName);
}

TEST_F(SessionViewTest, AnErasedStrokeIsNoLongerReadWithTheOthers) {
  Do("node .Lot --> extrude(19) Mass");
  Draw({0, 19, 14}, {20, 19, 14});
  const auto first = state().sketch.suggestions;
  Draw({20, 19, 14}, {20, 19, 0});
  Do("erase 1");
  ASSERT_THAT(state().sketch.strokes, SizeIs(1));
  EXPECT_EQ(state().sketch.suggestions.at(0).action, first.at(0).action);
  Do("erase 0");
  EXPECT_THAT(state().sketch.strokes, IsEmpty());
  EXPECT_THAT(state().sketch.suggestions, IsEmpty());
  Do("undo");
  Do("undo");
  EXPECT_THAT(state().sketch.strokes, SizeIs(2));
}

TEST_F(SessionViewTest, InkThatMeansNothingCanBeErasedToo) {
  ASSERT_FALSE(session.AddStroke({{Vec2(800, 500), 0.0}}));
  ASSERT_THAT(state().sketch.unread, SizeIs(1));
  Do("erase 0");
  EXPECT_THAT(state().sketch.unread, IsEmpty());
}

TEST_F(SessionViewTest, OnlyStrokesOfTheSketchCanBeErased) {
  EXPECT_THAT(Refused("erase 0").hint, HasSubstr("no strokes"));
  Draw({20, 0, 14}, {20, 19, 14});
  EXPECT_THAT(Refused("erase 0 5").hint, HasSubstr("it has 0"));
  EXPECT_THAT(state().sketch.strokes, SizeIs(1)) << "not even the one that is there";
  Do("pick 1 extrude");
  EXPECT_EQ(Refused("erase 0").code, ErrorCode::kUnknownName) << "it has become a rule";
}

TEST_F(SessionViewTest, StrokeNumbersAreNeverUsedAgain) {
  Draw({20, 0, 14}, {20, 19, 14});
  Do("undo");
  Draw({20, 0, 14}, {20, 19, 14});
  EXPECT_EQ(state().sketch.strokes.at(0)->number, 1u);
}

TEST_F(SessionViewTest, TappingTwiceLetsAShapeGo) {
  BuildTower();
  Do("select 0/1/1 0/1/3");
  Do("select 0/1/1");
  ASSERT_THAT(state().selection.shapes, SizeIs(1));
  EXPECT_EQ(IdOf(state().model, state().selection.shapes[0]), "0/1/3");
  Do("select none");
  EXPECT_THAT(state().selection.shapes, IsEmpty());
  EXPECT_THAT(state().selection.candidates, IsEmpty());
}

TEST_F(SessionViewTest, ShapesThatAreNotThereCannotBeTapped) {
  BuildTower();
  Do("select 0/1/1");
  for (const char* line : {"select 0/1/99", "select 0/1/2 7", "select lot-1:0", "select x"}) {
    Refused(line);
    EXPECT_THAT(state().selection.shapes, SizeIs(1)) << line;
  }
}

TEST_F(SessionViewTest, TappedShapesAreGeneralisedAndTheChoiceIsWhatTheNextSketchActsOn) {
  BuildTower();
  Do("select 0/1/1 0/1/3");
  const auto& candidates = state().selection.candidates;
  ASSERT_THAT(candidates, Not(IsEmpty()));
  size_t even = 0;
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (grammar::TextOf(candidates[i].query) == ".Floor:even") even = i + 1;
  }
  ASSERT_GT(even, 0u) << "every second floor";
  EXPECT_EQ(candidates[even - 1].count, 8u);
  EXPECT_EQ(candidates[even - 1].reading, "every even Floor");
  Do("query " + std::to_string(even));
  ASSERT_TRUE(state().sketch.query);
  // A line across an even floor of the south façade.
  Draw({10, 3.8, 14}, {10, 7.6, 14});
  Do("pick 1 split");
  EXPECT_THAT(Rules(), HasSubstr(".Floor:even --> split(x)"));
  EXPECT_FALSE(state().sketch.query) << "once";
}

TEST_F(SessionViewTest, AQueryChosenForATakenNodeChangesThatNode) {
  BuildTower();
  Do("node .Floor --> color(\"#888888\")");
  Do("take 0/3");
  Do("select 0/1/0 0/2/0");
  EXPECT_THAT(state().in_hand, ElementsAre(0, 3)) << "taken by hand: a tap keeps it";
  Do("query 1");
  EXPECT_THAT(Rules(), HasSubstr(".Floor:first --> color"));
  EXPECT_THAT(state().selection.shapes, IsEmpty());
}

TEST_F(SessionViewTest, ATapLetsGoOfTheNodeJustMade) {
  BuildTower();
  Do("node .Floor --> color(\"#888888\")");
  Do("select 0/1/0");
  EXPECT_THAT(state().in_hand, IsEmpty()) << "the query is for what comes next";
}

TEST_F(SessionViewTest, LettingGoOfTheShapesTakesBackWhatWasChosenForThem) {
  BuildTower();
  for (const char* line : {"select none", "select 0/1/1"}) {
    Do("select 0/1/1");
    Do("query 1");
    ASSERT_TRUE(state().sketch.query);
    Do(line);
    EXPECT_THAT(state().selection.shapes, IsEmpty());
    EXPECT_FALSE(state().sketch.query) << line;
    Do("undo");
    EXPECT_TRUE(state().sketch.query) << "one step for both";
    Do("clear");
    Do("select none");
  }
}

TEST_F(SessionViewTest, LinesAreReadAnewWhenTheirQueryIsTakenBack) {
  BuildTower();
  Do("select 0/1/1");
  Do("query .Roof");
  ASSERT_FALSE(session.AddStroke(Line({10, 3.8, 14}, {10, 7.6, 14})) &&
               !state().sketch.suggestions.empty())
      << "a line on a wall means nothing on the roof";
  Do("clear");
  Do("select 0/1/1");
  Do("query .Floor");
  Draw({10, 3.8, 14}, {10, 7.6, 14});
  Do("select none");
  EXPECT_THAT(state().sketch.strokes, SizeIs(1));
  EXPECT_THAT(state().sketch.suggestions, Not(IsEmpty()));
}

TEST_F(SessionViewTest, QueryNoneIsTheSketchsWhateverIsInHand) {
  BuildTower();
  Do("query .Floor");
  Do("take 0/2");
  Do("query none");
  EXPECT_FALSE(state().sketch.query);
  EXPECT_THAT(Rules(), HasSubstr(".Facade --> split"));
}

TEST_F(SessionViewTest, WhatChangesNothingIsNoStepAndKeepsWhatCanBeRedone) {
  BuildTower();
  Do("node .Floor --> color(\"#888888\")");
  Do("take 0/2");
  Do("keep-view a");
  Do("undo");
  const Timeline::Span span = session.timeline().span();
  const size_t history = session.history().size();
  for (const char* line : {"select none", "clear", "query none", "switch 0/2 on"}) {
    Do(line);
    EXPECT_EQ(session.timeline().span(), span) << line;
  }
  EXPECT_EQ(session.history().size(), history + 4) << "done all the same, and replayed";
  Do("redo");
  EXPECT_THAT(state().views, SizeIs(1));
  Do("undo");
  Do("select 0/1/1");
  EXPECT_EQ(session.timeline().span().last, span.now + 1) << "a real change is one";
}

TEST_F(SessionViewTest, QueriesThatAreNotOfferedOrSelectNothingVisibleAreRefused) {
  BuildTower();
  EXPECT_THAT(Refused("query 1").hint, HasSubstr("tap shapes"));
  Do("select 0/1/0");
  EXPECT_EQ(Refused("query 99").code, ErrorCode::kUnknownName);
  EXPECT_EQ(Refused("query 0").code, ErrorCode::kUnknownName);
  EXPECT_EQ(Refused("query .Facade").code, ErrorCode::kNothingMade) << "façades are split";
  EXPECT_EQ(Refused("query .Floor:nroth").code, ErrorCode::kUnknownName);
  Do("query .Floor");
  Do("query none");
  EXPECT_FALSE(state().sketch.query);
}

}  // namespace
}  // namespace parti::app
