#include "app/auto_view.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/random.h"

namespace parti::app {
namespace {

/// How much of the picture the bounds fill, the larger of width and height; 2 when any is outside.
double Filled(const render::Bounds& b, const Camera& camera) {
  const View view(camera);
  Vec2 low(1e9), high(-1e9);
  for (int i = 0; i < 8; ++i) {
    const auto p = view.Project(
        Vec3(i & 1 ? b.high.x : b.low.x, i & 2 ? b.high.y : b.low.y, i & 4 ? b.high.z : b.low.z));
    if (!p || p->x < 0 || p->y < 0 || p->x > camera.width_px || p->y > camera.height_px) return 2;
    low = glm::min(low, *p);
    high = glm::max(high, *p);
  }
  return std::max((high.x - low.x) / camera.width_px, (high.y - low.y) / camera.height_px);
}

RC_GTEST_PROP(AutoView, ShowsAllOfTheModelAndLittleElse, (uint64_t seed)) {
  Random random(seed);
  const auto size = [&random] { return std::pow(10, random.Uniform(-1, 3)); };
  const Vec3 low(random.Uniform(-500, 500), random.Uniform(-20, 20), random.Uniform(-500, 500));
  render::Bounds bounds;
  bounds.Add(low);
  bounds.Add(low + Vec3(size(), size(), size()));
  const Camera camera = AutoView(bounds, random.Uniform(50, 4000), random.Uniform(50, 4000));
  RC_ASSERT(Validate(camera).has_value());  // (1)
  const double filled = Filled(bounds, camera);
  RC_ASSERT(filled <= 1);    // (2)
  RC_ASSERT(filled >= 0.5);  // (3)
  RC_ASSERT(camera.eye.y > camera.target.y);
}

RC_GTEST_PROP(PresetView, ShowsAllOfTheModelFromItsSide, (uint64_t seed)) {
  Random random(seed);
  const auto size = [&random] { return std::pow(10, random.Uniform(0, 2)); };
  const Vec3 low(random.Uniform(-500, 500), random.Uniform(-20, 20), random.Uniform(-500, 500));
  render::Bounds bounds;
  bounds.Add(low);
  bounds.Add(low + Vec3(size(), size(), size()));
  for (const std::string_view name : kViewPresets) {
    const auto camera = PresetView(name, bounds, 1600, 1000);
    RC_ASSERT(camera.has_value());
    RC_ASSERT(Validate(*camera).has_value());
    RC_ASSERT(Filled(bounds, *camera) <= 1);
  }
}

TEST(PresetView, LooksFromWhereItsNameSays) {
  render::Bounds house;
  house.Add({0, 0, 0});
  house.Add({12, 9, 8});
  const auto forward = [&](std::string_view name) {
    return View(*PresetView(name, house, 800, 500)).forward();
  };
  EXPECT_LT(glm::distance(forward("front"), Vec3(0, 0, -1)), 1e-9);
  EXPECT_LT(glm::distance(forward("back"), Vec3(0, 0, 1)), 1e-9);
  EXPECT_LT(glm::distance(forward("left"), Vec3(1, 0, 0)), 1e-9);
  EXPECT_LT(glm::distance(forward("right"), Vec3(-1, 0, 0)), 1e-9);
  EXPECT_LT(forward("top").y, -0.999);
  EXPECT_LT(forward("top").z, 0);  // north is up
  EXPECT_EQ(PresetView("three-quarter", house, 800, 500), AutoView(house, 800, 500));
  EXPECT_EQ(PresetView("below", house, 800, 500), std::nullopt);
}

TEST(AutoView, NothingAPointAndALineAreSeenToo) {
  render::Bounds point, line, flat;
  point.Add({3, 1, 2});
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(10, 0, 0)}) line.Add(p);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(30, 0, 20)}) flat.Add(p);
  EXPECT_TRUE(Validate(AutoView({}, 1, 1)));
  for (const render::Bounds& bounds : {point, line, flat}) {
    const Camera camera = AutoView(bounds, 800, 500);
    EXPECT_TRUE(Validate(camera));
    EXPECT_LE(Filled(bounds, camera), 1);
  }
}

TEST(AutoView, SeesTheBroaderSideMoreFromTheFront) {
  const auto towards = [](double width, double depth) {
    render::Bounds bounds;
    bounds.Add({0, 0, 0});
    bounds.Add({width, 9, depth});
    return -View(AutoView(bounds, 800, 500)).forward();
  };
  EXPECT_GT(towards(20, 8).z, towards(20, 8).x);
  EXPECT_GT(towards(8, 20).x, towards(8, 20).z);
  EXPECT_GT(towards(8, 20).z, 0) << "from the south, where the sun is";
}

}  // namespace
}  // namespace parti::app
