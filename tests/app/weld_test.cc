// Corners that are welded, at random places down to a part of the distance that counts.
#include "app/weld.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace parti::app {
namespace {

TEST(Weld, JoinsCornersThatRoundingKeptApart) {
  const double e = 2e-6;
  const WeldedPart part = Weld({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, e, 0}, {1, 1, -e}, {e, 1, 0}});
  EXPECT_EQ(part.points.size(), 4u);
  EXPECT_EQ(part.triangles, (std::vector<uint32_t>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(part.normals.size(), 2u);
}

TEST(Weld, LeavesOutWhatHasNoAreaOrNoPlace) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(Weld({{0, 0, 0}, {1, 0, 0}, {1, 1e-7, 0}}).triangles.empty());
  EXPECT_TRUE(Weld({{0, 0, 0}, {1, 0, 0}, {0, inf, 0}}).triangles.empty());
  EXPECT_TRUE(Weld({{0, 0, 0}, {1, 0, 0}}).triangles.empty());
  EXPECT_TRUE(Weld({{1e300, 0, 0}, {1, 0, 0}, {0, 1, 0}}).triangles.empty());
}

/// Points a third of kWeld_m apart, over some blocks of the grid, about a place far from the
/// origin.
std::vector<Vec3> RandomCorners() {
  const auto places = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-80, 80));
  const double far = *rc::gen::element(0.0, 8.0, -123.456, 3e5);
  std::vector<Vec3> corners;
  for (size_t i = 0; i + 2 < places.size(); i += 3) {
    const Vec3 steps(places[i], places[i + 1] % 8, places[i + 2] % 3);
    corners.push_back(Vec3(far) + steps * (kWeld_m / 3));
  }
  corners.resize(corners.size() / 3 * 3);
  return corners;
}

RC_GTEST_PROP(Weld, MovesNoCornerFartherThanItWeldsAndLeavesNoTwoPointsNear, ()) {
  constexpr double kRounding_m = 1e-9;  // of what lies far out
  const std::vector<Vec3> corners = RandomCorners();
  Welder welder;
  welder.Weld({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});  // what came before leaves nothing
  const WeldedPart& part = welder.Weld(corners);
  RC_ASSERT(part.triangles.size() == 3 * part.sources.size());
  for (size_t i = 0; i < part.triangles.size(); ++i) {
    const Vec3& source = corners[3 * part.sources[i / 3] + i % 3];
    RC_ASSERT(glm::distance(part.points[part.triangles[i]], source) <= kWeld_m);
  }
  for (size_t i = 0; i < part.points.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      RC_ASSERT(glm::distance(part.points[i], part.points[k]) > kWeld_m - kRounding_m);
    }
  }
}

}  // namespace
}  // namespace parti::app
