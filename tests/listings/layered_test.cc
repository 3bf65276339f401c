// Listings 4.2 to 4.8: each does what the thesis says of it (Jesus 2018, 4.2 and 4.3).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/listings/listing.h"
#include "tests/support/golden.h"

namespace parti::tests {
namespace {

using grammar::Box2;
using grammar::Item;
using grammar::ItemType;

constexpr double kFacade_m2 = 8 * 7;

void ExpectBox(const Box2& box, const Vec2& low, const Vec2& high) {
  EXPECT_LT(glm::distance(box.low, low), 1e-9) << box.low.x << ' ' << box.low.y;
  EXPECT_LT(glm::distance(box.high, high), 1e-9) << box.high.x << ' ' << box.high.y;
}

TEST(Listing4_2, TwoLayersChangeNothingThatIsSeen) {
  const Listing listing("4_2", {});
  EXPECT_EQ(listing.Of("Floors", ItemType::kLayer).size(), 1u);
  EXPECT_EQ(listing.Of("Door", ItemType::kLayer).size(), 1u);
  const auto background = listing.BackgroundOf("Facade");
  ASSERT_EQ(background.size(), 1u);
  EXPECT_EQ(background[0].polygon, nullptr) << "the whole rectangle";
  EXPECT_NEAR(AreaOf(background[0]), kFacade_m2, 1e-9);
  ExpectGolden(listing.Picture(), "listing_4_2");
}

TEST(Listing4_3, OnlyTheBalconyChangesTheModel) {
  const Listing listing("4_3", {});
  const Item& facade = listing.Planar("Facade");
  const auto balconies = listing.Volumes("Balcony");
  const auto drawn = listing.Of("", ItemType::kVolume);
  ASSERT_EQ(balconies.size() + drawn.size(), 1u);
  const Item& balcony = balconies.empty() ? drawn[0] : balconies[0];
  ExpectBox(BoxIn(facade, balcony), Vec2(3, 3), Vec2(5, 5));
  EXPECT_NEAR(VolumeOf(balcony), 2 * 2 * 0.1, 1e-9);
  EXPECT_EQ(listing.Of("DoorExtrusion", ItemType::kShape2D).size(), 1u) << "laid out, never seen";
  const auto background = listing.BackgroundOf("Facade");
  ASSERT_EQ(background.size(), 1u);
  EXPECT_EQ(background[0].polygon->holes.size(), 1u);
  EXPECT_NEAR(AreaOf(background[0]), kFacade_m2 - 4, 1e-9);
  ExpectGolden(listing.Picture(), "listing_4_3");
}

/// The door's arch, 2 m wide: straight sides up to half of 4 m, then under a Bezier curve, whose
/// integral over its own x is 9/30 of the height.
constexpr double kArch_m2 = 2 * 4 * (0.5 + 9.0 / 30);

TEST(Listing4_4, TheArchReplacesTheBalcony) {
  const Listing listing("4_4", {});
  EXPECT_EQ(listing.Of("Balcony", ItemType::kShape2D).size(), 1u) << "still in its layer";
  EXPECT_TRUE(listing.Of("Balcony", ItemType::kPlanar).empty());
  const auto volumes = listing.Of("", ItemType::kVolume);
  ASSERT_EQ(volumes.size(), 1u) << "the door alone";
  EXPECT_TRUE(volumes[0].hollow);
  const Box2 box = BoxIn(listing.Planar("Facade"), volumes[0]);
  EXPECT_NEAR(box.low.x, 3, 1e-9);
  EXPECT_NEAR(box.high.x, 5, 1e-9);
  EXPECT_NEAR(box.high.y, 4 * 0.875, 0.01);
  EXPECT_NEAR(listing.BackgroundAreaOf("Facade"), kFacade_m2 - kArch_m2, 0.02);
  ExpectGolden(listing.Picture(), "listing_4_4");
}

TEST(Listing4_5, TheBalconyAdaptsToTheArch) {
  const Listing listing("4_5", {});
  const auto balconies = listing.Of("Balcony", ItemType::kPlanar);
  ASSERT_EQ(balconies.size(), 1u);
  ASSERT_NE(balconies[0].polygon, nullptr);
  const double cut = 4 - AreaOf(balconies[0]);
  EXPECT_GT(cut, 0.3);
  EXPECT_NEAR(listing.BackgroundAreaOf("Facade"), kFacade_m2 - kArch_m2 - (4 - cut), 0.02);
  EXPECT_EQ(listing.Of("", ItemType::kVolume).size(), 2u) << "balcony and door";
  ExpectGolden(listing.Picture(), "listing_4_5");
}

const ListingOptions kFloor{.lot = "rect(14,5)", .start = {}, .layers_off = {}, .attributes = {}};

TEST(Listing4_7, WindowsUnderTheFramesAreLost) {
  const Listing listing("4_7", kFloor);
  EXPECT_EQ(listing.Volumes("Frame").size(), 2u);
  for (const Item& window : listing.Volumes("Window")) {
    const Box2 box = BoxIn(listing.Planar("Start"), window);
    EXPECT_NEAR(std::fmod(box.low.x, 3.0), 0.5, 1e-9) << "on the grid of the whole wall";
  }
  EXPECT_EQ(listing.Volumes("Window").size(), 3u) << "of five, the first and the last are covered";
  ExpectGolden(listing.Picture(), "listing_4_7");
}

TEST(Listing4_8, DeferredWindowsStandBesideTheFrames) {
  const Listing listing("4_8", kFloor);
  EXPECT_EQ(listing.Volumes("Frame").size(), 2u);
  const auto windows = listing.Volumes("Window");
  ASSERT_EQ(windows.size(), 4u);
  for (size_t i = 0; i < windows.size(); ++i) {
    const double left = 1 + 0.5 + 3 * static_cast<double>(i);
    ExpectBox(BoxIn(listing.Planar("Start"), windows[i]), Vec2(left, 1), Vec2(left + 2, 3));
  }
  ExpectGolden(listing.Picture(), "listing_4_8");
}

}  // namespace
}  // namespace parti::tests
