// From nothing: the lot is drawn, then the walls are drawn up from it.
#include <gmock/gmock.h>

#include "grammar/operation.h"
#include "tests/app/session_driver.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class SessionLotTest : public ::testing::Test, public SessionDriver {
 protected:
  SessionLotTest() { Do("view eye 25 22 40 target 0 0 0 fov 40 size 1600 1000"); }

  /// One stroke along lines on the ground.
  Stroke Outline(const std::vector<Vec2>& corners) const {
    Stroke outline;
    for (size_t i = 1; i < corners.size(); ++i) {
      const Vec2 a = corners[i - 1], b = corners[i];
      const double from_s = outline.empty() ? 0 : outline.back().t_s;
      for (StrokeSample sample : Line({a.x, 0, a.y}, {b.x, 0, b.y})) {
        sample.t_s += from_s;
        outline.push_back(sample);
      }
    }
    return outline;
  }
  Result<void> DrawOutline(const std::vector<Vec2>& corners) {
    return session.AddStroke(Outline(corners));
  }

  const std::vector<Vec2> closed_ = {{-10, -7}, {10, -7}, {10, 7}, {-10, 7}, {-10, -7}};
};

TEST_F(SessionLotTest, TheFirstClosedOutlineIsTheLotAndTheNextLineIsDrawnUpFromIt) {
  ASSERT_TRUE(DrawOutline(closed_));
  ASSERT_THAT(state().model.lots(), SizeIs(1));
  EXPECT_EQ(state().model.lots()[0].item.scope.size, Vec3(20, 14, 0));
  EXPECT_THAT(state().sketch.strokes, IsEmpty()) << "the outline has become the lot";
  Draw({10, 0, 7}, {10, 12, 7});
  Do("pick 1 extrude");
  EXPECT_THAT(Rules(), HasSubstr(".Lot --> extrude(12) Mass"));
}

TEST_F(SessionLotTest, TheLotIsInTheHistoryAsACommandThatReplays) {
  ASSERT_TRUE(DrawOutline(closed_));
  const auto& history = session.history();
  ASSERT_THAT(history, SizeIs(3));
  EXPECT_TRUE(history[1].stroke);
  EXPECT_EQ(TextOf(*history[2].command), "lot poly(-10,7 10,7 10,-7 -10,-7)");
  Session again;
  ASSERT_TRUE(again.Execute(*ParseCommand(TextOf(*history[2].command))));
  EXPECT_EQ(again.state().model.lots()[0].item.scope.size, state().model.lots()[0].item.scope.size);
}

TEST_F(SessionLotTest, OneUndoTakesTheLotBack) {
  ASSERT_TRUE(DrawOutline(closed_));
  Do("undo");
  EXPECT_THAT(state().model.lots(), IsEmpty());
  EXPECT_THAT(state().sketch.strokes, IsEmpty());
  Do("redo");
  EXPECT_THAT(state().model.lots(), SizeIs(1));
}

TEST_F(SessionLotTest, SidesDrawnOneByOneWaitForTheLast) {
  for (size_t i = 0; i + 2 < closed_.size(); ++i) {
    const auto read = DrawOutline({closed_[i], closed_[i + 1]});
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().hint, HasSubstr("draw on"));
    EXPECT_THAT(state().sketch.strokes, SizeIs(i + 1));
  }
  ASSERT_TRUE(DrawOutline({closed_[3], closed_[4]}));
  EXPECT_THAT(state().model.lots(), SizeIs(1));
}

TEST_F(SessionLotTest, AClosedOutlineCountsWhateverWasLeftOpenBefore) {
  ASSERT_FALSE(DrawOutline({{-3, -3}, {4, 2}}));
  ASSERT_TRUE(DrawOutline(closed_));
  EXPECT_THAT(state().model.lots(), SizeIs(1));
}

TEST_F(SessionLotTest, ATapIsInkAndNotASide) {
  ASSERT_FALSE(session.AddStroke({{Vec2(800, 500), 0.0}}));
  EXPECT_THAT(state().sketch.strokes, IsEmpty());
  EXPECT_THAT(state().sketch.unread, SizeIs(1));
  ASSERT_TRUE(DrawOutline(closed_));
}

TEST_F(SessionLotTest, ASideCanBeErasedAndDrawnAgain) {
  ASSERT_FALSE(DrawOutline({closed_[0], closed_[1]}));
  ASSERT_FALSE(DrawOutline({{3, 3}, {4, 6}}));
  Do("erase 1");
  ASSERT_FALSE(DrawOutline({closed_[1], closed_[2], closed_[3]}));
  ASSERT_TRUE(DrawOutline({closed_[3], closed_[0]}));
}

TEST_F(SessionLotTest, ATypedLotTakesThePlaceOfADrawnOne) {
  ASSERT_TRUE(DrawOutline(closed_));
  Do("lot rect(8,5)");
  EXPECT_EQ(state().model.lots()[0].item.scope.size, Vec3(8, 5, 0));
}

}  // namespace
}  // namespace parti::app
