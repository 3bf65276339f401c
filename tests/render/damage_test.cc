#include "render/damage.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <set>

namespace parti::render {
namespace {

constexpr glm::ivec2 kSize{40, 30};
using Pixels = std::set<std::pair<int, int>>;

Pixels PixelsIn(const std::vector<PixelRect>& rects) {
  Pixels pixels;
  for (const PixelRect& r : rects) {
    for (int y = r.y; y < r.y + r.height; ++y) {
      for (int x = r.x; x < r.x + r.width; ++x) pixels.emplace(x, y);
    }
  }
  return pixels;
}

PixelRect AnyRect() {
  const auto at = rc::gen::inRange(-10, 50);
  const auto size = rc::gen::inRange(0, 25);
  return {*at, *at, *size, *size};
}

RC_GTEST_PROP(DamageProperties, Property1And2_EveryPixelIsInOneRectangleAndNoneInTwo, ()) {
  Damage damage(kSize);
  std::vector<PixelRect> added;
  for (int n = *rc::gen::inRange(0, 30); n > 0; --n) {
    added.push_back(AnyRect());
    damage.Add(added.back());
    const Pixels covered = PixelsIn(damage.rects());
    RC_ASSERT(damage.rects().size() <= Damage::kMostRects);
    RC_ASSERT(static_cast<int64_t>(covered.size()) == damage.area());  // none in two
    for (const auto& pixel : PixelsIn(added)) {
      const bool inside =
          pixel.first >= 0 && pixel.second >= 0 && pixel.first < kSize.x && pixel.second < kSize.y;
      RC_ASSERT(covered.contains(pixel) == inside || !inside);
    }
    for (const auto& [x, y] : covered) RC_ASSERT(x >= 0 && y >= 0 && x < kSize.x && y < kSize.y);
  }
}

TEST(Damage, FarSpotsStayApartAndNearOnesGrowTogether) {
  Damage damage(kSize);
  damage.Add({0, 0, 2, 2});
  damage.Add({30, 20, 2, 2});
  EXPECT_EQ(damage.area(), 8);
  damage.Add({1, 1, 3, 3});
  EXPECT_EQ(damage.area(), 4 + 16);
  EXPECT_TRUE(damage.Touches({3, 3, 5, 5}));
  EXPECT_FALSE(damage.Touches({4, 4, 5, 5}));
  EXPECT_FALSE(damage.Touches({1, 1, 0, 9}));
}

TEST(Damage, TooManySpotsMergeWhereItCostsLeast) {
  Damage damage({1000, 1000});
  for (int i = 0; i < 6; ++i) damage.Add({i * 150, i * 150, 2, 2});
  damage.Add({760, 760, 2, 2});  // near the one at 750
  EXPECT_EQ(damage.rects().size(), 6u);
  EXPECT_EQ(damage.area(), 5 * 4 + 12 * 12);
}

TEST(Damage, PixelsAroundAShapeAreCutAtThePicture) {
  EXPECT_EQ(PixelsAround({3.2f, 4.9f}, {5.1f, 4.9f}, 1, kSize), (PixelRect{2, 3, 5, 3}));
  EXPECT_EQ(PixelsAround({-1e30f, -5}, {1e30f, 2}, 1, kSize), (PixelRect{0, 0, 40, 3}));
  EXPECT_TRUE(IsEmpty(PixelsAround({100, 2}, {120, 9}, 1, kSize)));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(IsEmpty(PixelsAround({nan, 2}, {5, 9}, 1, kSize)));
  EXPECT_TRUE(IsEmpty(PixelsAround({1, 2}, {5, 9}, nan, kSize)));
}

Damage Of(const PixelRect& rect) {
  Damage damage(kSize);
  damage.Add(rect);
  return damage;
}

TEST(DamageHistory, ABufferIsRepairedFromWhatChangedSinceItWasShown) {
  DamageHistory history(kSize);
  history.Push(Of({0, 0, 2, 2}));
  history.Push(Of({10, 0, 2, 2}));
  const Damage fresh = Of({20, 0, 2, 2});
  EXPECT_EQ(history.ToRepair(fresh, 1).area(), 4);
  EXPECT_EQ(history.ToRepair(fresh, 2).area(), 8);
  EXPECT_TRUE(history.ToRepair(fresh, 2).Touches({10, 0, 2, 2}));
  EXPECT_EQ(history.ToRepair(fresh, 3).area(), 12);
}

TEST(DamageHistory, BuffersOfUnknownOrTooGreatAgeAreDrawnWhole) {
  DamageHistory history(kSize);
  for (int i = 0; i < 20; ++i) history.Push(Of({i, 0, 1, 1}));
  const Damage fresh(kSize);
  const int64_t whole = int64_t{kSize.x} * kSize.y;
  EXPECT_EQ(history.ToRepair(fresh, 9).area(), 8);
  for (const int age : {-1, 0, 10, 1000}) EXPECT_EQ(history.ToRepair(fresh, age).area(), whole);
  history.Forget();
  EXPECT_EQ(history.ToRepair(fresh, 2).area(), whole);
  EXPECT_EQ(history.ToRepair(fresh, 1).area(), 0);
}

}  // namespace
}  // namespace parti::render
