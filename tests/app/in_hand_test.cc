// What keys and cards act on in the whole application: what a person sees to be in hand, selected
// or chosen; and nothing at all where there is no such thing.
#include <gmock/gmock.h>
#include <linux/input-event-codes.h>

#include "tests/app/application_driver.h"
#include "tests/support/golden.h"

namespace parti::app::tests {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class InHandTest : public ApplicationDriver {
 protected:
  /// A tower of coloured floors, seen from the south east, with a keyboard.
  void Build() {
    PlugIn();
    Do("lot rect(20,14)");
    Do("view eye 42 17 47 target 10 8.5 7 fov 36 size 1600 1000");
    Do("node .Lot --> extrude(19) Mass");
    Do("node .Mass --> comp(f) { side: Facade | top: Roof }");
    Do("node .Facade --> split(y) { { ~4: Floor }* }");
    Do("node .Floor --> color(\"#888888\")");
    Do("take none");
  }
  std::string Rules() const { return grammar::TextOf(state().model.trees()); }
  void TapAFloor() { TapAt(Pixel({10, 9.5, 14})); }
  bool Redoes() const { return application_->snapshot().can_redo; }
};

TEST_F(InHandTest, ACardRewritesNoRuleThatIsHidden) {
  Build();
  const std::string before = Rules();
  Key(KEY_R);
  TapOn("Rules/0/3 ");
  ASSERT_THAT(state().in_hand, ElementsAre(0, 3));
  Key(KEY_R);
  TapAFloor();
  EXPECT_THAT(Words(), Contains("Which do you mean?"));
  TapOn("Queries/2 ");
  EXPECT_EQ(Rules(), before);
  EXPECT_TRUE(state().sketch.query) << "it is for the next sketch";
  EXPECT_THAT(state().in_hand, IsEmpty());
}

TEST_F(InHandTest, NorOneThatUndoTookInHandAgain) {
  Build();
  Key(KEY_R);
  TapOn("Rules/0/3 ");
  Do("switch 0/3 off");
  Do("take none");
  Key(KEY_R);
  Do("undo");
  ASSERT_THAT(state().in_hand, ElementsAre(0, 3));
  const std::string before = Rules();
  TapAFloor();
  TapOn("Queries/2 ");
  EXPECT_EQ(Rules(), before);
}

TEST_F(InHandTest, ACardSaysWhichRuleItWouldChange) {
  Build();
  Key(KEY_R);
  TapOn("Rules/0/3 ");
  TapAFloor();
  EXPECT_THAT(Words(), Contains(HasSubstr("What is Color")));
  TapOn("Queries/2 ");
  EXPECT_FALSE(state().sketch.query);
  EXPECT_THAT(Rules(), Not(HasSubstr(".Floor --> color")));
}

TEST_F(InHandTest, DeleteTakesNoRuleAwayThatIsHidden) {
  Build();
  const std::string before = Rules();
  Key(KEY_R);
  TapOn("Rules/0/3 ");
  Key(KEY_R);
  Key(KEY_DELETE);
  EXPECT_EQ(Rules(), before);
  Key(KEY_R);
  Key(KEY_DELETE);
  EXPECT_THAT(Rules(), Not(HasSubstr("color")));
}

TEST_F(InHandTest, WhatTheNextSketchActsOnIsSaidAndTakenBack) {
  Build();
  TapAFloor();
  TapOn("Queries/1 ");
  ASSERT_TRUE(state().sketch.query);
  EXPECT_THAT(Words(), Contains(HasSubstr("What you draw acts on")));
  TapOn("Status/Act on anything again");
  EXPECT_FALSE(state().sketch.query);
  EXPECT_THAT(Words(), Not(Contains(HasSubstr("What you draw acts on"))));
}

TEST_F(InHandTest, WhatTheNextSketchActsOnIsOutlined) {
  Build();
  TapAFloor();
  const auto before = Seen();
  Do("query .Floor");
  EXPECT_GT(parti::tests::Compare(before, Seen(), {2, 0}).pixels, 5'000u);
}

TEST_F(InHandTest, ClosingTheCardsAndEscapeTakeTheChoiceBack) {
  Build();
  for (const bool by_key : {false, true}) {
    TapAFloor();
    TapOn("Queries/1 ");
    ASSERT_TRUE(state().sketch.query);
    if (by_key) {
      Key(KEY_ESC);
    } else {
      TapOn("Queries/Select nothing");
    }
    EXPECT_FALSE(state().sketch.query);
    EXPECT_THAT(state().selection.shapes, IsEmpty());
    Do("undo");
    EXPECT_TRUE(state().sketch.query) << "one step for both";
    Do("redo");
  }
}

TEST_F(InHandTest, EscapeTakesBackAQueryWithNoShapeSelected) {
  Build();
  Do("query .Floor");
  Key(KEY_ESC);
  EXPECT_FALSE(state().sketch.query);
}

TEST_F(InHandTest, EscapeAndBackspaceWithNothingToDoKeepWhatCanBeRedone) {
  Build();
  Do("undo");
  ASSERT_TRUE(Redoes());
  Key(KEY_ESC);
  Key(KEY_BACKSPACE);
  EXPECT_TRUE(Redoes());
  Do("redo");
  EXPECT_THAT(Rules(), HasSubstr("color"));
}

TEST_F(InHandTest, EscapeAndBackspaceBeginNoDraft) {
  PlugIn();
  Key(KEY_ESC);
  Key(KEY_BACKSPACE);
  EXPECT_EQ(application_->snapshot().document.path, "");
  EXPECT_EQ(application_->snapshot().executed, 0u);
}

TEST_F(InHandTest, EscapeRightAfterATapLetsGoOfWhatIsNotSeenYet) {
  Build();
  const Vec2 px = Pixel({10, 9.5, 14});
  Pen(PenEvent::Kind::kProximityIn, px);
  Pen(PenEvent::Kind::kDown, px);
  Lift(px);
  Key(KEY_ESC);
  EXPECT_THAT(state().selection.shapes, IsEmpty());
}

}  // namespace
}  // namespace parti::app::tests
