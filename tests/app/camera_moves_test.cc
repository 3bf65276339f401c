#include "app/camera_moves.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "base/random.h"

namespace parti::app {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A level camera above the ground, as users have them.
Camera AnyCamera(Random* random) {
  const auto length = [random] { return std::pow(10, random->Uniform(-0.5, 2.5)); };
  const auto coordinate = [&] { return random->Uniform(-1, 1) * length(); };
  Camera camera;
  camera.eye = {coordinate(), 0.2 + length(), coordinate()};
  const double turn = random->Uniform(-kPi, kPi), pitch = random->Uniform(-1.5, 1);
  const Vec3 forward(std::cos(pitch) * std::sin(turn), std::sin(pitch),
                     std::cos(pitch) * std::cos(turn));
  camera.target = camera.eye + forward * length();
  camera.width_px = random->Uniform(300, 3000);
  camera.height_px = random->Uniform(300, 3000);
  camera.vertical_fov = Angle::Degrees(random->Uniform(20, 70));
  return camera;
}

Vec2 AnyPixel(const Camera& camera, Random* random) {
  return Vec2(camera.width_px, camera.height_px) *
         Vec2(random->Uniform(0, 1), random->Uniform(0, 1));
}

double Pitch_deg(const Camera& camera) {
  return Angle::Radians(std::asin(View(camera).forward().y)).degrees();
}

RC_GTEST_PROP(OrbitAbout, Properties1And2_TurnsRigidlyAboutThePivotWhichStaysAtItsPixel,
              (uint64_t seed)) {
  Random random(seed);
  const Camera camera = AnyCamera(&random);
  const Vec3 pivot = PointUnder(camera, AnyPixel(camera, &random));
  const Vec2 delta_px(random.Uniform(-900, 900), random.Uniform(-900, 900));
  const Camera moved = OrbitAbout(camera, pivot, delta_px);
  RC_ASSERT(Validate(moved).has_value());
  const double near_m = 1e-9 * (1 + glm::length(pivot) + glm::distance(pivot, camera.eye));
  RC_ASSERT(std::abs(glm::distance(moved.eye, pivot) - glm::distance(camera.eye, pivot)) < near_m);
  RC_ASSERT(std::abs(glm::distance(moved.target, pivot) - glm::distance(camera.target, pivot)) <
            near_m);
  const auto before = View(camera).Project(pivot), after = View(moved).Project(pivot);
  RC_ASSERT(before && after);
  RC_ASSERT(glm::distance(*before, *after) < 1e-5);
}

RC_GTEST_PROP(OrbitAbout, Property3_LimitsHoldWhateverTheFingersDo, (uint64_t seed)) {
  Random random(seed);
  const CameraLimits limits;
  Camera camera = AnyCamera(&random);
  for (int i = 0; i < 30; ++i) {
    const double far = std::pow(10, random.Uniform(0, 6));
    const Vec2 delta_px(random.Uniform(-far, far), random.Uniform(-far, far));
    camera = OrbitAbout(camera, PointUnder(camera, AnyPixel(camera, &random)), delta_px);
    RC_ASSERT(Validate(camera).has_value());
    RC_ASSERT(std::abs(Pitch_deg(camera)) <= limits.steepest_deg + 1e-6);
    RC_ASSERT(camera.eye.y >= limits.lowest_m - 1e-6);
    RC_ASSERT(camera.up == Vec3(0, 1, 0));
  }
}

TEST(OrbitAbout, TheSceneFollowsTheFinger) {
  const Camera camera{.eye = {0, 5, 20}, .target = {0, 5, 0}};
  const Vec3 near_side(0, 5, 4);
  const auto to = [&](Vec2 delta_px) {
    return *View(OrbitAbout(camera, camera.target, delta_px)).Project(near_side);
  };
  const Vec2 middle = *View(camera).Project(near_side);
  EXPECT_GT(to({50, 0}).x, middle.x + 10);
  EXPECT_LT(to({-50, 0}).x, middle.x - 10);
  EXPECT_GT(to({0, 50}).y, middle.y + 10);  // down: the near side sinks, more is seen from above
  EXPECT_GT(OrbitAbout(camera, camera.target, {0, 50}).eye.y, 5);
}

TEST(OrbitAbout, ADragOverTheViewsHeightIsHalfATurn) {
  const Camera camera{.eye = {0, 5, 20}, .target = {0, 5, 0}};
  const Camera moved = OrbitAbout(camera, camera.target, {camera.height_px, 0});
  EXPECT_LT(glm::distance(moved.eye, Vec3(0, 5, -20)), 1e-9);
}

TEST(OrbitAbout, AViewStraightDownCanBeRaised) {
  Camera plan{.eye = {3, 50, 2}, .target = {3, 0, 2}};
  plan.up = {0, 0, -1};
  const Camera moved = OrbitAbout(plan, plan.target, {0, -100});
  EXPECT_NEAR(Pitch_deg(moved), -90 + 18, 1e-6);
  EXPECT_GT(moved.eye.z, 10);  // north is still up
}

TEST(OrbitAbout, ACameraUnderTheGroundGoesNoDeeper) {
  const Camera camera{.eye = {0, -3, 20}, .target = {0, -3, 0}};
  EXPECT_GE(OrbitAbout(camera, camera.target, {0, -300}).eye.y, -3 - 1e-9);
  EXPECT_GT(OrbitAbout(camera, camera.target, {0, 300}).eye.y, 5);
}

TEST(CameraMoves, NumbersThatAreNoneMoveNothing) {
  const Camera camera;
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_EQ(OrbitAbout(camera, {0, 0, 0}, {bad, 1}), camera);
    EXPECT_EQ(OrbitAbout(camera, {0, bad, 0}, {1, 1}), camera);
    EXPECT_EQ(PanZoom(camera, {bad, 0, 0}, {1, 1}, 1), camera);
    EXPECT_EQ(PanZoom(camera, {0, 0, 0}, {1, bad}, 1), camera);
    EXPECT_EQ(PanZoom(camera, {0, 0, 0}, {1, 1}, bad), camera);
    EXPECT_EQ(ZoomTowards(camera, {bad, 1}, 2), camera);
    EXPECT_EQ(ZoomTowards(camera, {1, 1}, bad), camera);
  }
  EXPECT_EQ(PanZoom(camera, {0, 0, 0}, {1, 1}, 0), camera);
  EXPECT_EQ(PanZoom(camera, {0, 0, 0}, {1, 1}, -2), camera);
  EXPECT_EQ(PanZoom(camera, {0, 0, 90}, {1, 1}, 2), camera);  // behind the eye
}

RC_GTEST_PROP(PanZoom, Properties1And2_WhatIsTouchedStaysUnderTheFingers, (uint64_t seed)) {
  Random random(seed);
  const Camera camera = AnyCamera(&random);
  const Vec3 point = PointUnder(camera, AnyPixel(camera, &random));
  const Vec2 to_px = AnyPixel(camera, &random);
  const double scale = std::pow(2, random.Uniform(-2, 2));
  const Camera moved = PanZoom(camera, point, to_px, scale);
  RC_ASSERT(Validate(moved).has_value());
  RC_ASSERT(glm::distance(View(moved).forward(), View(camera).forward()) < 1e-6);
  const CameraLimits limits;
  const double depth = View(moved).Depth(point);
  const bool limited = moved.eye.y <= limits.lowest_m || depth <= limits.nearest_m * (1 + 1e-9) ||
                       depth >= limits.farthest_m * (1 - 1e-9);
  RC_PRE(!limited);
  const auto at = View(moved).Project(point);
  RC_ASSERT(at.has_value());
  RC_ASSERT(glm::distance(*at, to_px) < 1e-4);
  const double larger = View(moved).PixelsPerMetre(point) / View(camera).PixelsPerMetre(point);
  RC_ASSERT(std::abs(larger / scale - 1) < 1e-6);
}

RC_GTEST_PROP(PanZoom, Property3_LimitsHoldWhateverTheFingersDo, (uint64_t seed)) {
  Random random(seed);
  const CameraLimits limits;
  Camera camera = AnyCamera(&random);
  for (int i = 0; i < 30; ++i) {
    const double scale = std::pow(10, random.Uniform(-9, 9));
    const Vec2 from_px = AnyPixel(camera, &random), to_px = AnyPixel(camera, &random) * 9.0;
    camera = PanZoom(camera, PointUnder(camera, from_px), to_px, scale);
    if (i % 2 == 1) camera = ZoomTowards(camera, from_px, scale);
    RC_ASSERT(Validate(camera).has_value());
    RC_ASSERT(camera.eye.y >= limits.lowest_m);
    for (const double coordinate : {camera.eye.x, camera.eye.y, camera.eye.z}) {
      RC_ASSERT(std::abs(coordinate) <= limits.farthest_m);
    }
  }
}

TEST(ZoomTowards, TheWheelGoesToWhatIsUnderThePointerAndBack) {
  const Camera camera{.eye = {3, 12, 30}, .target = {0, 3, 0}};
  const Vec2 pixel(1200, 700);
  const Vec3 ground = PointUnder(camera, pixel);
  const Camera nearer = ZoomTowards(camera, pixel, 1.25);
  EXPECT_LT(glm::distance(*View(nearer).Project(ground), pixel), 1e-6);
  EXPECT_NEAR(View(nearer).Depth(ground), View(camera).Depth(ground) / 1.25, 1e-9);
  EXPECT_LT(glm::distance(ZoomTowards(nearer, pixel, 0.8).eye, camera.eye), 1e-9);
}

TEST(PointUnder, IsOnTheSurfaceThenOnTheGroundThenBeforeTheSky) {
  const Camera camera{.eye = {0, 5, 20}, .target = {0, 5, 0}};
  const Vec2 low(800, 900), sky(800, 100), horizon(800, 501);
  const Plane wall{{0, 0, 1}, 2};
  EXPECT_NEAR(PointUnder(camera, low, wall).z, 2, 1e-9);
  EXPECT_NEAR(PointUnder(camera, low).y, 0, 1e-9);
  EXPECT_NEAR(View(camera).Depth(PointUnder(camera, sky)), 20, 1e-9);
  EXPECT_NEAR(View(camera).Depth(PointUnder(camera, horizon)), 20, 1e-9);
  EXPECT_LT(glm::distance(*View(camera).Project(PointUnder(camera, sky)), sky), 1e-9);
}

}  // namespace
}  // namespace parti::app
