#include "render/bounds.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "base/random.h"
#include "render/look.h"
#include "render/sun_shadow.h"
#include "tests/support/sample_scenes.h"

namespace parti::render {
namespace {

Camera RandomCamera(uint64_t seed) {
  Random random(seed);
  Camera camera;
  camera.eye = {random.Uniform(-40, 40), random.Uniform(-5, 40), random.Uniform(20, 60)};
  camera.target = {random.Uniform(-5, 5), random.Uniform(0, 10), random.Uniform(-5, 5)};
  camera.vertical_fov = Angle::Degrees(random.Uniform(15, 100));
  camera.width_px = random.Uniform(10, 3000);
  camera.height_px = random.Uniform(10, 3000);
  return camera;
}

RC_GTEST_PROP(ClipFromWorld, PutsPointsOnThePixelsOfView, (uint64_t seed)) {
  const Camera camera = RandomCamera(seed);
  Random random(seed + 1);
  const Vec3 p(random.Uniform(-10, 10), random.Uniform(0, 12), random.Uniform(-10, 10));
  const auto pixel = View(camera).Project(p);
  RC_PRE(pixel.has_value());
  const Vec4 clip = Mat4(ClipFromWorld(camera, {1, 200})) * Vec4(p, 1);
  const glm::ivec2 size = PictureSize(camera);
  const Vec2 drawn((clip.x / clip.w + 1) * 0.5 * size.x, (1 - clip.y / clip.w) * 0.5 * size.y);
  // Six digits of float over pictures of some thousand pixels.
  RC_ASSERT(glm::length(drawn - *pixel) < 0.02 + 1e-5 * glm::length(*pixel));
}

RC_GTEST_PROP(DepthRangeFor, HoldsAllInFrontOfTheEyeAndKeepsItsRatio, (uint64_t seed)) {
  const Camera camera = RandomCamera(seed);
  const Bounds bounds = BoundsOf(tests::House(), true);
  const DepthRange range = DepthRangeFor(bounds, camera);
  RC_ASSERT(range.near_m > 0);
  RC_ASSERT(range.far_m > range.near_m);
  RC_ASSERT(range.near_m >= range.far_m / 4000 * 0.999);
  const View view(camera);
  for (const Vec3& corner : {bounds.low, bounds.high, bounds.middle()}) {
    const double depth = view.Depth(corner);
    RC_ASSERT(depth <= range.far_m);
    RC_ASSERT(depth <= 0 || depth >= range.near_m || range.near_m <= range.far_m / 3999);
  }
}

TEST(Bounds, LeaveOutWhatCannotBeDrawn) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  Scene scene;
  scene.faces.push_back({{{0, 0, 0}, {1, 2, 3}, {kNan, 0, 0}, {0, -kInf, 0}, {0, 0, 1e9f}}, {}, 0});
  scene.lines.push_back({{{-4, 0, 0}, {0, kNan, 0}}});
  const Bounds faces = BoundsOf(scene, false), all = BoundsOf(scene, true);
  EXPECT_EQ(faces.low, Vec3(0, 0, 0));
  EXPECT_EQ(faces.high, Vec3(1, 2, 3));
  EXPECT_EQ(all.low, Vec3(-4, 0, 0));
  EXPECT_TRUE(BoundsOf({}, true).empty());
  EXPECT_EQ(BoundsOf({}, true).radius(), 0);
}

TEST(ShadowLookup, HoldsTheBoundsAndFollowsTheSun) {
  const Look look;
  const Bounds bounds = BoundsOf(tests::House(), false);
  const ShadowLookup lookup = ShadowLookupFor(bounds, look);
  const auto at = [&lookup](const Vec3& p) { return Vec4(lookup.shadow_from_world * Vec4f(p, 1)); };
  for (const Vec3& corner : {bounds.low, bounds.high}) {  // (1)
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(at(corner)[i], 0);
      EXPECT_LE(at(corner)[i], 1);
    }
  }
  const Vec4 high = at({1, 10, 2}), low = at(Vec3(1, 10, 2) - 8.0 * Vec3(look.to_sun));  // (2)
  EXPECT_NEAR(high.x, low.x, 1e-5);
  EXPECT_NEAR(high.y, low.y, 1e-5);
  EXPECT_LT(high.z, low.z);
}

TEST(PictureSize, IsRoundedAndAtLeastOnePixel) {
  Camera camera;
  camera.width_px = 1.2;
  camera.height_px = 799.6;
  EXPECT_EQ(PictureSize(camera), glm::ivec2(1, 800));
}

}  // namespace
}  // namespace parti::render
