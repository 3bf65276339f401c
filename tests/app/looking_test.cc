#include "app/looking.h"

#include <gtest/gtest.h>

namespace parti::app {
namespace {

using input::DragPhase;
using input::PenAct;

Camera Start() {
  Camera camera;
  camera.eye = {10, 12, 30};
  camera.target = {0, 3, 0};
  return camera;
}

Vec3 OnGround(const Camera& camera, const Vec2& px) { return PointUnder(camera, px); }

TEST(LookingTest, WhatTwoFingersTouchStaysUnderThem) {
  Looking looking(Start());
  const Vec3 point = OnGround(Start(), {800, 700});
  looking.Take(input::PanZoomGesture{DragPhase::kBegin, {800, 700}, {800, 700}, 1}, OnGround);
  EXPECT_TRUE(looking.moving());
  EXPECT_TRUE(
      looking.Take(input::PanZoomGesture{DragPhase::kMove, {800, 700}, {600, 500}, 1.5}, OnGround));
  const auto seen = View(looking.camera()).Project(point);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->x, 600, 1e-6);
  EXPECT_NEAR(seen->y, 500, 1e-6);
  looking.Take(input::PanZoomGesture{DragPhase::kEnd, {800, 700}, {600, 500}, 1.5}, OnGround);
  EXPECT_FALSE(looking.moving());
}

TEST(LookingTest, ACancelledGestureTakesBackWhatItDid) {
  Looking looking(Start());
  looking.Take(input::OrbitGesture{DragPhase::kBegin, {800, 700}, {800, 700}}, OnGround);
  EXPECT_TRUE(
      looking.Take(input::OrbitGesture{DragPhase::kMove, {800, 700}, {900, 700}}, OnGround));
  EXPECT_TRUE(
      looking.Take(input::OrbitGesture{DragPhase::kCancel, {800, 700}, {900, 700}}, OnGround));
  EXPECT_EQ(looking.camera(), Start());
}

TEST(LookingTest, OneGestureAtATimeMovesTheCamera) {
  Looking looking(Start());
  looking.Take(input::OrbitGesture{DragPhase::kBegin, {800, 700}, {800, 700}}, OnGround);
  EXPECT_FALSE(looking.Take(DragAct{DragPhase::kBegin, PenAct::kPan, 0, {5, 5}}, OnGround));
  EXPECT_FALSE(looking.Take(DragAct{DragPhase::kMove, PenAct::kPan, 0, {50, 5}}, OnGround));
  EXPECT_FALSE(looking.Take(WheelAct{PenAct::kZoom, {5, 5}, {0, 1}}, OnGround));
}

TEST(LookingTest, ACameraThatIsHeldStandsStill) {
  Looking looking(Start());
  looking.Take(input::OrbitGesture{DragPhase::kBegin, {800, 700}, {800, 700}}, OnGround);
  looking.Hold(true);
  EXPECT_FALSE(looking.moving());
  EXPECT_FALSE(
      looking.Take(input::OrbitGesture{DragPhase::kMove, {800, 700}, {900, 700}}, OnGround));
  EXPECT_FALSE(
      looking.Take(input::OrbitGesture{DragPhase::kEnd, {800, 700}, {900, 700}}, OnGround));
  EXPECT_FALSE(looking.Take(WheelAct{PenAct::kZoom, {800, 600}, {0, -3}}, OnGround));
  looking.Take(input::PanZoomGesture{DragPhase::kBegin, {800, 700}, {800, 700}, 1}, OnGround);
  looking.Hold(false);
  EXPECT_FALSE(
      looking.Take(input::PanZoomGesture{DragPhase::kMove, {800, 700}, {600, 500}, 1.5}, OnGround))
      << "fingers that came meanwhile have to come anew";
  EXPECT_EQ(looking.camera(), Start());
  EXPECT_TRUE(looking.Take(WheelAct{PenAct::kZoom, {800, 600}, {0, -3}}, OnGround));
}

TEST(LookingTest, AWheelTurnedBackGivesTheSameView) {
  Looking looking(Start());
  EXPECT_TRUE(looking.Take(WheelAct{PenAct::kZoom, {800, 600}, {0, -3}}, OnGround));
  EXPECT_LT(glm::distance(looking.camera().eye, OnGround(Start(), {800, 600})),
            glm::distance(Start().eye, OnGround(Start(), {800, 600})));
  EXPECT_TRUE(looking.Take(WheelAct{PenAct::kZoom, {800, 600}, {0, 3}}, OnGround));
  EXPECT_LT(glm::distance(looking.camera().eye, Start().eye), 1e-9);
}

TEST(LookingTest, AZoomingDragUpwardsDoublesInItsLength) {
  Looking looking(Start());
  const Vec3 point = OnGround(Start(), {800, 700});
  looking.Take(DragAct{DragPhase::kBegin, PenAct::kZoom, 0, {800, 700}}, OnGround);
  looking.Take(DragAct{DragPhase::kMove, PenAct::kZoom, 0, {800, 700 - Looking::kDoubling_px}},
               OnGround);
  EXPECT_NEAR(View(looking.camera()).PixelsPerMetre(point), 2 * View(Start()).PixelsPerMetre(point),
              1e-6);
}

}  // namespace
}  // namespace parti::app
