// A drag of an element that is placed by hand: pixels in, the text of the rules out.
#include "app/placing/layer_drag.h"

#include <gmock/gmock.h>

#include "app/placing/layer_marks.h"
#include "tests/app/placing_support.h"

namespace parti::app::tests {
namespace {

using testing::HasSubstr;

std::string With(std::string text, std::string_view old, std::string_view now) {
  const size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), now);
}

class LayerDragTest : public testing::Test {
 protected:
  Vec2 Pixel(const Vec2& at) const { return *view_.Project(placed_->face.ToWorld({at, 0})); }
  LayerDrag Begun(const Vec2& at) const {
    auto drag = LayerDrag::Begin(placed_, view_, Pixel(at), 1);
    EXPECT_TRUE(drag);
    return *drag;
  }
  LayerDrag Dragged(const Vec2& from, const Vec2& to) const {
    LayerDrag drag = Begun(from);
    drag.MoveTo(view_, Pixel(to));
    return drag;
  }
  /// The text of the rules once it was dropped.
  std::string Text(const LayerDrag& drag) const {
    EXPECT_TRUE(drag.Outcome());
    return grammar::TextWith(*drag.placed().rules, drag.placed().layers[drag.grip().layer].rules,
                             drag.snapped().layer);
  }

  std::shared_ptr<const PlacedLayers> placed_ = PlacedBy(kPlacedRules);
  View view_{CameraBefore()};
};

TEST_F(LayerDragTest, TheWholeFollowsThePenAndTwoNumbersChange) {
  const LayerDrag drag = Dragged({4.75, 1.2}, {17.25, 2.42});
  EXPECT_TRUE(drag.moved());
  EXPECT_EQ(Text(drag), With(With(kPlacedRules, "door_left = 4 ", "door_left = 16.5 "),
                             "segment(y, 0, 2.5", "segment(y, 1.22, 2.5"));
  EXPECT_EQ(drag.Outcome(), (PlaceElement{"Door", 16.5, 1.22, {}, {}}));
}

TEST_F(LayerDragTest, ACornerResizesAndTheOppositeOneStays) {
  const LayerDrag drag = Dragged({16, 8}, {17.13, 7.31});
  EXPECT_EQ(Text(drag),
            With(With(kPlacedRules, "2, 14, ~1", "2, 15.13, ~1"), "4, 4, ~1", "4, 3.31, ~1"));
}

TEST_F(LayerDragTest, AnEdgeChangesOneNumberHoweverThePenSways) {
  const LayerDrag drag = Dragged({9, 8}, {11, 7.31});
  EXPECT_EQ(Text(drag), With(kPlacedRules, "4, 4, ~1", "4, 3.31, ~1"));
}

TEST_F(LayerDragTest, AnElementStaysInTheRowThatItIsDraggedAlong) {
  // 5 cm up is less than the snap's reach: its lower edge stays on the face's.
  EXPECT_EQ(Text(Dragged({4.75, 1.2}, {17.25, 1.25})),
            With(kPlacedRules, "door_left = 4 ", "door_left = 16.5 "));
}

TEST_F(LayerDragTest, EdgesSnapToOthersAndTheLineIsShown) {
  const LayerDrag drag = Dragged({4.75, 1.2}, {2.8, 1.2});  // its left to 2.05, the windows' at 2
  EXPECT_EQ(drag.snapped().layer.left, 2);
  ASSERT_TRUE(drag.snapped().across);
  EXPECT_EQ(drag.others()[drag.snapped().across->like].name, "Windows");
  const auto marks_of = [&](const LayerDrag& one) {
    std::vector<render::Mark> marks;
    AddLayerMarks(one, view_, &marks);
    return std::count_if(marks.begin(), marks.end(), [](const render::Mark& mark) {
      return mark.color == DrawingStyle().guide;
    });
  };
  EXPECT_EQ(marks_of(drag), 2) << "the windows' left edge and the ground";
  EXPECT_EQ(marks_of(Dragged({4.75, 1.2}, {17.25, 2.42})), 0);
}

TEST_F(LayerDragTest, MiddlesSnapToTheFaceToo) {
  const LayerDrag drag = Dragged({4.75, 1.2}, {10.05, 1.2});
  EXPECT_NEAR(drag.snapped().layer.left + 0.75, 10, 1e-9);
}

TEST_F(LayerDragTest, NothingLeavesTheFace) {
  const LayerDrag right = Dragged({4.75, 1.2}, {400, 300});
  EXPECT_NEAR(right.snapped().layer.left, 19.25, 0.3);
  EXPECT_NEAR(right.snapped().layer.bottom, 7.8, 0.3);
  const LayerDrag left = Dragged({4.75, 1.2}, {-40, -30});
  EXPECT_EQ(left.snapped().layer.left, 0);
  EXPECT_EQ(left.snapped().layer.bottom, 0);
}

TEST_F(LayerDragTest, ATapChangesNothing) {
  LayerDrag drag = Begun({4.75, 1.2});
  drag.MoveTo(view_, Pixel({4.75, 1.2}) + Vec2(2, -2));
  EXPECT_FALSE(drag.moved());
  EXPECT_FALSE(drag.Outcome());
}

TEST_F(LayerDragTest, ASmallMoveIsNotDrawnBack) {
  const double px_per_m = view_.PixelsPerMetre(placed_->face.ToWorld({4.75, 1.2, 0}));
  ASSERT_GT(px_per_m, 20) << "5 px are whole steps";
  const LayerDrag drag = Dragged({4.75, 1.2}, {4.75 + 5 / px_per_m, 1.2});
  EXPECT_NEAR(drag.snapped().layer.left, 4 + 5 / px_per_m, 0.011);
  LayerDrag back = Dragged({4.75, 1.2}, {12, 5});
  back.MoveTo(view_, Pixel({4.75 + 5 / px_per_m, 1.2}));
  EXPECT_EQ(back.snapped().layer.left, 4) << "from afar it is";
}

TEST_F(LayerDragTest, BackWhereItWasChangesNothing) {
  LayerDrag drag = Dragged({4.75, 1.2}, {12, 5});
  drag.MoveTo(view_, Pixel({4.75, 1.2}));
  EXPECT_TRUE(drag.moved());
  EXPECT_FALSE(drag.Outcome());
}

TEST_F(LayerDragTest, PixelsBesideThePlaneLeaveItWhereItWas) {
  LayerDrag drag = Dragged({4.75, 1.2}, {12, 5});
  const auto before = drag.snapped().layer;
  drag.MoveTo(view_, {NAN, 3});
  Camera away = CameraBefore();
  away.target = {4, 7, 80};
  drag.MoveTo(View(away), {800, 500});
  EXPECT_EQ(drag.snapped().layer, before);
}

TEST_F(LayerDragTest, BesideTheElementsNothingBegins) {
  EXPECT_FALSE(LayerDrag::Begin(placed_, view_, Pixel({18, 6}), 1));
}

TEST_F(LayerDragTest, ElementsThatShareANumberGoTogether) {
  placed_ = PlacedBy(With(kPlacedRules, "segment(x, 2, 14", "segment(x, door_left, 14"));
  const LayerDrag drag = Dragged({4.75, 1.2}, {6.25, 1.2});
  EXPECT_EQ(drag.LayerNow(1).left, drag.LayerNow(0).left);
  EXPECT_THAT(Text(drag), HasSubstr("attr door_left = 5.5 "));
}

}  // namespace
}  // namespace parti::app::tests
