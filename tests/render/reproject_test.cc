#include "render/reproject.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/sample_scenes.h"

namespace parti::render {
namespace {

double Within(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

Camera AnyCamera() {
  Camera camera = tests::HouseCamera(800, 500);
  camera.eye += Vec3(Within(-15, 15), Within(-10, 10), Within(-15, 15));
  camera.target += Vec3(Within(-3, 3), Within(-3, 3), Within(-3, 3));
  camera.vertical_fov = Angle::Degrees(Within(20, 70));
  return camera;
}

Vec2 Through(const glm::dmat3& matrix, const Vec2& px) {
  const Vec3 p = matrix * Vec3(px, 1);
  return Vec2(p) / p.z;
}

RC_GTEST_PROP(ReprojectionProperties, Property1_PointsOfThePlaneAreShownWhereTheyAreSeen, ()) {
  const Camera from = AnyCamera(), to = AnyCamera();
  const View view(to);
  const Vec3 p = to.target + view.right() * Within(-5, 5) + view.up() * Within(-5, 5);
  const auto seen_from = View(from).Project(p), seen_to = view.Project(p);
  RC_PRE(seen_from && seen_to);
  RC_ASSERT(glm::distance(Through(PictureFromMoved(from, to), *seen_to), *seen_from) < 1e-6);
}

TEST(Reprojection, Property2_EqualCamerasShowThePictureAsItIs) {
  const Camera camera = tests::HouseCamera(800, 500);
  EXPECT_EQ(PictureFromMoved(camera, camera), glm::dmat3(1));
}

TEST(Reprojection, Property3_WhatLiesBehindTheOldCameraIsNotShown) {
  Camera from = tests::HouseCamera(800, 500), to = from;
  from.eye = to.target + (to.target - to.eye) * 0.5;  // beyond the target, looking on
  from.target = from.eye + (to.target - to.eye);
  EXPECT_LT((PictureFromMoved(from, to) * Vec3(400, 250, 1)).z, 0);
  EXPECT_GT((PictureFromMoved(to, to) * Vec3(400, 250, 1)).z, 0);
}

}  // namespace
}  // namespace parti::render
