#include "base/camera.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace parti {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Reals of a few decimals, as geometry has them.
rc::Gen<double> Within(double low, double high) {
  return rc::gen::map(rc::gen::inRange(0, 1'000'001),
                      [=](int i) { return low + (high - low) * (i / 1e6); });
}

Vec3 AnyPoint(double extent) {
  return Vec3(*Within(-extent, extent), *Within(-extent, extent), *Within(-extent, extent));
}

Camera AnyCamera() {
  Camera camera;
  camera.eye = AnyPoint(100);
  camera.target = AnyPoint(100);
  camera.vertical_fov = Angle::Degrees(*Within(5, 120));
  camera.width_px = *rc::gen::inRange(1, 4000);
  camera.height_px = *rc::gen::inRange(1, 4000);
  RC_PRE(Validate(camera).has_value());
  // Looking nearly straight up or down costs digits that the bounds below don't allow for.
  RC_PRE(std::abs(glm::normalize(camera.target - camera.eye).y) < 0.999);
  return camera;
}

// What OpenGL would do with glm's own matrices.
Vec2 ProjectWithGlm(const Camera& c, const Vec3& p) {
  const Mat4 look = glm::lookAtRH(c.eye, c.target, c.up);
  const Mat4 lens =
      glm::perspectiveRH(c.vertical_fov.radians(), c.width_px / c.height_px, 0.001, 1000.0);
  const Vec4 clip = lens * look * Vec4(p, 1);
  return Vec2((clip.x / clip.w + 1) * 0.5 * c.width_px, (1 - clip.y / clip.w) * 0.5 * c.height_px);
}

RC_GTEST_PROP(View, ProjectsAsGlmDoes, ()) {
  const Camera camera = AnyCamera();
  const View view(camera);
  const Vec3 p = AnyPoint(100);
  RC_PRE(view.Depth(p) > 0.1);
  const Vec2 ours = view.Project(p).value(), glms = ProjectWithGlm(camera, p);
  RC_ASSERT(glm::distance(ours, glms) < 1e-6 * (1 + glm::length(glms)));
}

RC_GTEST_PROP(View, EveryPointOfARayProjectsToItsPixel, ()) {
  const View view(AnyCamera());
  const Vec2 pixel(*Within(-500, 4000), *Within(-500, 4000));
  const Ray ray = view.RayThrough(pixel);
  RC_ASSERT(std::abs(glm::length(ray.direction) - 1) < 1e-12);
  const auto seen = view.Project(ray.origin + ray.direction * *Within(1, 1000));
  RC_PRE(seen.has_value());
  RC_ASSERT(glm::distance(*seen, pixel) < 1e-6 * (1 + glm::length(pixel)));
}

RC_GTEST_PROP(View, TheAxesAreOrthonormalAndRightHanded, ()) {
  const View view(AnyCamera());
  RC_ASSERT(glm::length(glm::cross(view.right(), view.up()) + view.forward()) < 1e-9);
}

RC_GTEST_PROP(View, AMovedWorldSeenByAMovedCameraLooksTheSame, ()) {
  const Camera camera = AnyCamera();
  const Vec3 p = AnyPoint(100), by = AnyPoint(1000);
  Camera moved = camera;
  moved.eye += by;
  moved.target += by;
  RC_PRE(View(camera).Depth(p) > 0.1);
  RC_ASSERT(glm::distance(View(camera).Project(p).value(), View(moved).Project(p + by).value()) <
            1e-4 * (1 + glm::length(*View(camera).Project(p))));
}

RC_GTEST_PROP(View, ASegmentIsCutWhereItPassesTheEye, ()) {
  const View view(AnyCamera());
  const Segment3 segment{AnyPoint(200), AnyPoint(200)};
  const auto seen = view.Project(segment);
  const auto turned = view.Project({segment.b, segment.a});
  const bool any = std::max(view.Depth(segment.a), view.Depth(segment.b)) >= View::kNear;
  RC_ASSERT(seen.has_value() == any);
  if (!seen) return;
  RC_ASSERT(IsFinite(seen->a) && IsFinite(seen->b));
  // The line through the projections is the projected line: the visible end lies where it should,
  // and turning the segment round turns the answer round.
  const auto whole_a = view.Project(segment.a);
  if (whole_a) RC_ASSERT(glm::distance(*whole_a, seen->a) == 0);
  RC_ASSERT(glm::distance(seen->a, turned->b) <= 1e-6 * (1 + glm::length(seen->a)));
}

TEST(View, ASegmentThatOnlyTouchesTheNearPlaneIsAPoint) {
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.target = {0, 0, -1};
  // One end is at the near plane, the other a rounding error before it, two metres aside.
  const double near = View::kNear, nearer = std::nextafter(near, 0);
  const auto seen = View(camera).Project(Segment3{{-1, 0, -nearer}, {1, 0, -near}});
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->a.x, seen->b.x, 1e-6);
  EXPECT_NEAR(seen->b.x, 800 + 1 / near * 500 / std::tan(kPi / 8), 1e-3);
}

TEST(View, PointsBehindTheEyeAreNotSeen) {
  const View view{Camera{}};
  EXPECT_FALSE(view.Project(Vec3(0, 1.6, 11)));
  EXPECT_FALSE(view.Project(Camera{}.eye));
  EXPECT_FALSE(view.Project(Vec3(kNan, 0, 0)));
  EXPECT_FALSE(view.Project(Segment3{{0, 0, 11}, {0, 0, 12}}));
  EXPECT_EQ(view.PixelsPerMetre({0, 1.6, 11}), 0);
}

TEST(View, TheTargetIsInTheMiddle) {
  const auto seen = View{Camera{}}.Project(Camera{}.target);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->x, 800, 1e-9);
  EXPECT_NEAR(seen->y, 500, 1e-9);
}

TEST(View, PixelsPerMetreIsTheSizeOfAMetre) {
  const View view{Camera{}};
  const Vec3 p(0, 0, 0);
  const double wide = glm::distance(*view.Project(p), *view.Project(p + view.right()));
  EXPECT_NEAR(view.PixelsPerMetre(p), wide, 1e-9);
}

TEST(ValidateCamera, RefusesWhatHasNoPicture) {
  const auto refused = [](auto&& change) {
    Camera camera;
    change(&camera);
    const auto result = Validate(camera);
    return !result && result.error().code == ErrorCode::kBadNumber;
  };
  EXPECT_TRUE(Validate(Camera{}));
  EXPECT_TRUE(refused([](Camera* c) { c->eye = c->target; }));
  EXPECT_TRUE(refused([](Camera* c) { c->eye.x = kNan; }));
  EXPECT_TRUE(refused([](Camera* c) { c->target.x = 1e300; }));
  EXPECT_TRUE(refused([](Camera* c) { c->up = c->target - c->eye; }));
  EXPECT_TRUE(refused([](Camera* c) { c->up = Vec3(0); }));
  EXPECT_TRUE(refused([](Camera* c) { c->vertical_fov = Angle::Degrees(0); }));
  EXPECT_TRUE(refused([](Camera* c) { c->vertical_fov = Angle::Degrees(180); }));
  EXPECT_TRUE(refused([](Camera* c) { c->vertical_fov = Angle::Degrees(kNan); }));
  EXPECT_TRUE(refused([](Camera* c) { c->width_px = 0; }));
  EXPECT_TRUE(refused([](Camera* c) { c->height_px = 1e9; }));
}

TEST(ValidateCamera, AShortUpIsAsGoodAsALongOne) {
  Camera camera;
  camera.up = {0, 1e-12, 0};
  EXPECT_TRUE(Validate(camera));
}

RC_GTEST_PROP(Intersect, LiesOnThePlaneAndOnTheRay, ()) {
  const Plane plane{glm::normalize(AnyPoint(1) + Vec3(0, 3, 0)), *Within(-50, 50)};
  const Vec3 any = AnyPoint(50), eye = AnyPoint(50);
  const Vec3 on_plane = any - plane.normal * (glm::dot(any, plane.normal) - plane.offset);
  RC_PRE(std::abs(glm::dot(eye, plane.normal) - plane.offset) > 0.1);
  const Ray ray{eye, glm::normalize(on_plane - eye)};
  const auto met = Intersect(ray, plane);
  RC_ASSERT(met.has_value());
  RC_ASSERT(glm::distance(*met, on_plane) < 1e-6);
  const double t = glm::dot(*met - ray.origin, ray.direction);
  RC_ASSERT(t > 0);
  RC_ASSERT(std::abs(glm::dot(*met, plane.normal) - plane.offset) < 1e-9 * (1 + t));
  RC_ASSERT(glm::length(*met - ray.origin - ray.direction * t) < 1e-9 * (1 + t));
}

TEST(Intersect, GrazingAndBackwardRaysAreRefused) {
  const Plane ground{{0, 1, 0}, 0};
  EXPECT_EQ(Intersect({{0, 1, 0}, {1, 0, 0}}, ground).error().code, ErrorCode::kGrazingView);
  EXPECT_EQ(Intersect({{0, 1, 0}, {0, 1, 0}}, ground).error().code, ErrorCode::kBehindEye);
  EXPECT_EQ(Intersect({{0, 0, 0}, {0, 1, 0}}, ground).error().code, ErrorCode::kBehindEye);
}

}  // namespace
}  // namespace parti
