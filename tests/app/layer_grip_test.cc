// From pixels to the handles of elements that are placed by hand, and to metres on their face.
#include "app/placing/layer_grip.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/app/placing_support.h"

namespace parti::app::tests {
namespace {

constexpr double kReach_px = 10;
constexpr size_t kDoor = 0, kWindows = 1;

class LayerGripTest : public testing::Test {
 protected:
  Vec2 Pixel(const Vec2& at) const { return *view_.Project(placed_->face.ToWorld({at, 0})); }
  std::optional<LayerGrip> At(const Vec2& px) const {
    return GripAt(*placed_, view_, px, kReach_px);
  }

  std::shared_ptr<const PlacedLayers> placed_ = PlacedBy(kPlacedRules);
  View view_{CameraBefore()};
};

TEST_F(LayerGripTest, CornersEdgesAndTheWholeAreWhereTheyAreSeen) {
  const Vec2 near(5, -5);
  EXPECT_EQ(At(Pixel({2, 8}) + near), (LayerGrip{kWindows, {-1, 1}}));
  EXPECT_EQ(At(Pixel({16, 4}) + near), (LayerGrip{kWindows, {1, -1}}));
  EXPECT_EQ(At(Pixel({16, 6}) + Vec2(-6, 0)), (LayerGrip{kWindows, {1, 0}}));
  EXPECT_EQ(At(Pixel({8, 8}) + Vec2(0, 6)), (LayerGrip{kWindows, {0, 1}}));
  EXPECT_EQ(At(Pixel({8, 6})), (LayerGrip{kWindows, {}}));
  EXPECT_EQ(At(Pixel({4.75, 1.2})), (LayerGrip{kDoor, {}}));
  EXPECT_EQ(At(Pixel({18, 6})), std::nullopt);
}

TEST_F(LayerGripTest, WhatLiesOnTopIsTaken) {
  const auto tall =
      PlacedBy(std::string(kPlacedRules).replace(std::string(kPlacedRules).find("2.5"), 3, "6.5"));
  EXPECT_EQ(GripAt(*tall, view_, Pixel({4.75, 5.2}), kReach_px), (LayerGrip{kDoor, {}}));
}

TEST_F(LayerGripTest, ASmallElementCanStillBeMoved) {
  Camera far = CameraBefore();
  far.eye = {4, 7, 400};
  view_ = View(far);
  const double width_px = glm::distance(Pixel({4, 1.25}), Pixel({5.5, 1.25}));
  ASSERT_LT(width_px, 2 * kReach_px);
  EXPECT_EQ(At(Pixel({4.75, 1.25})), (LayerGrip{kDoor, {}}));
}

TEST_F(LayerGripTest, FromBehindNothingIsTaken) {
  Camera behind = CameraBefore();
  behind.eye.z = -20;
  view_ = View(behind);
  EXPECT_EQ(At(Pixel({8, 6})), std::nullopt);
}

TEST_F(LayerGripTest, PixelsThatAreNoneTakeNothing) {
  EXPECT_EQ(At({NAN, 5}), std::nullopt);
  EXPECT_EQ(At({INFINITY, -INFINITY}), std::nullopt);
}

TEST_F(LayerGripTest, APlaneFromTheSideHasNoPoint) {
  Camera aside = CameraBefore();
  aside.eye = {-30, 4, 14};
  aside.target = {0, 4, 14};
  EXPECT_EQ(OnFrame(placed_->face, View(aside), {800, 500}), std::nullopt);
}

TEST_F(LayerGripTest, APlaneBehindTheEyeHasNoPoint) {
  Camera away = CameraBefore();
  away.target = {4, 7, 80};
  EXPECT_EQ(OnFrame(placed_->face, View(away), {800, 500}), std::nullopt);
}

RC_GTEST_FIXTURE_PROP(LayerGripTest, Property1OfOnFrameItInvertsProjecting, ()) {
  const Vec2 at(*rc::gen::inRange(0, 20000) / 1000.0, *rc::gen::inRange(0, 9000) / 1000.0);
  const auto back = OnFrame(placed_->face, view_, Pixel(at));
  RC_ASSERT(back.has_value());
  RC_ASSERT(glm::distance(*back, at) < 1e-9);
}

}  // namespace
}  // namespace parti::app::tests
