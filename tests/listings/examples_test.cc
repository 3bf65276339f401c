// Listings 7.1 to 7.8: façades that splits alone can't make (Jesus 2018, 7.1).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/listings/listing.h"
#include "tests/support/golden.h"

namespace parti::tests {
namespace {

using grammar::Box2;
using grammar::Item;
using grammar::ItemType;

ListingOptions Wide() {
  return {.lot = "rect(13.5,6)", .start = {}, .layers_off = {}, .attributes = {}};
}

ListingOptions WithEntrance(const char* height) {
  ListingOptions options = Wide();
  options.attributes = {{"entrance_height", height}};
  return options;
}

/// Width and height of every window, in centimetres, each once.
std::vector<std::pair<int, int>> WindowSizes(const Listing& listing) {
  std::vector<std::pair<int, int>> sizes;
  for (const Item& item : listing.Volumes("Window")) {
    sizes.emplace_back(std::lround(item.scope.size.x * 100), std::lround(item.scope.size.y * 100));
  }
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

TEST(Listing7_1, TheDoorSpansFloorsAndGetsInNobodysWay) {
  const Listing listing("7_1", Wide());
  const auto doors = listing.Volumes("Door");
  ASSERT_EQ(doors.size(), 1u);
  const Item& facade = listing.Planar("Facade");
  const Box2 door = BoxIn(facade, doors[0]);
  EXPECT_NEAR(door.low.x, 5.25, 1e-9);
  EXPECT_NEAR(door.high.x, 8.25, 1e-9);
  EXPECT_GT(door.high.y, 2.5) << "into the second floor";
  const auto windows = listing.Volumes("Window");
  EXPECT_EQ(windows.size(), 4u * 9 - 3) << "three of the lowest row make way for the door";
  EXPECT_EQ(WindowSizes(listing).size(), 1u);
  EXPECT_EQ(listing.Of("GroundFloor", ItemType::kPlanar).size(), 2u)
      << "left and right of the door";
  ExpectGolden(listing.Picture(), "listing_7_1");
}

TEST(Listing7_1, StripesAreCutByTheArchesOfTheirWindows) {
  const Listing listing("7_1", Wide());
  const auto arches = listing.Volumes("GroundWindow");
  EXPECT_GE(arches.size(), 2u);
  for (const Item& arch : arches) EXPECT_NE(arch.mesh, nullptr);
  const auto stripes = listing.Volumes("Stripe");
  const auto cut = std::count_if(stripes.begin(), stripes.end(),
                                 [](const Item& stripe) { return stripe.mesh != nullptr; });
  EXPECT_GT(cut, 4) << "no longer boxes";
}

TEST(Listing7_2, FramesAdaptToTheWindowsOverThem) {
  const ListingOptions options{.lot = "rect(9,5)", .start = {}, .layers_off = {}, .attributes = {}};
  const Listing listing("7_2", options);
  EXPECT_EQ(listing.Of("WindowComponent", ItemType::kShape2D).size(), 3u);
  const auto frames = listing.Of("Frame", ItemType::kPlanar);
  const auto cut = std::count_if(frames.begin(), frames.end(), [](const Item& frame) {
    return std::min(frame.scope.size.x, frame.scope.size.y) < 0.2 - 1e-9 || frame.polygon;
  });
  EXPECT_GT(frames.size(), 12u) << "a frame that another crosses falls into pieces";
  EXPECT_GE(cut + static_cast<ptrdiff_t>(frames.size()), 13);
  ExpectGolden(listing.Picture(), "listing_7_2");
}

/// Figure 7.3: a layer is switched off, and what lay under it is whole.
void ExpectWithout(const std::string& layer, const std::string& golden) {
  const ListingOptions options{.lot = "rect(9,5)",
                               .start = {},
                               .layers_off = {"MultiComponentWindow." + layer},
                               .attributes = {}};
  const Listing listing("7_2", options);
  EXPECT_EQ(listing.Of("WindowComponent", ItemType::kShape2D).size(), 2u);
  ExpectGolden(listing.Picture(), golden);
}

TEST(Listing7_2, WithoutItsMiddle) { ExpectWithout("Middle", "listing_7_3a"); }
TEST(Listing7_2, WithoutItsTop) { ExpectWithout("Top", "listing_7_3b"); }
TEST(Listing7_2, WithoutItsBottom) { ExpectWithout("Bottom", "listing_7_3c"); }

const ListingOptions kMikimoto{
    .lot = "rect(20,15)", .start = "Mikimoto", .layers_off = {}, .attributes = {}};

/// Whether a line across the façade, at `at` along the axis, meets no window.
bool Divides(const std::vector<Box2>& windows, int axis, double at) {
  return std::none_of(windows.begin(), windows.end(), [&](const Box2& box) {
    return box.low[axis] < at - 1e-6 && box.high[axis] > at + 1e-6;
  });
}

/// The windows alone: the stripe runs from edge to edge.
ListingOptions WithoutStripe() {
  ListingOptions options = kMikimoto;
  options.layers_off = {"Facade.Stripe"};
  return options;
}

TEST(Listing7_3To7_7, NoLineDividesTheFacade) {
  const Listing listing("7_3_to_7_7", WithoutStripe());
  const auto facades = listing.Of("Facade", ItemType::kPlanar);
  ASSERT_EQ(facades.size(), 4u);
  for (const Item& facade : facades) {
    std::vector<Box2> windows;
    for (const Item& item : listing.Volumes("Window")) {
      if (glm::dot(item.facing, facade.facing) > 0.99) windows.push_back(BoxIn(facade, item));
    }
    ASSERT_GE(windows.size(), 30u);
    const Vec2 size(facade.scope.size);
    for (int axis = 0; axis < 2; ++axis) {
      double low = size[axis], high = 0;
      for (const Box2& box : windows) {
        low = std::min(low, box.low[axis]);
        high = std::max(high, box.high[axis]);
      }
      for (double at = low + 0.01; at < high - 0.01; at += 0.01) {
        ASSERT_FALSE(Divides(windows, axis, at)) << (axis == 0 ? "x " : "y ") << at;
      }
    }
  }
}

TEST(Listing7_3To7_7, TheStripeLiesOverSomeWindows) {
  const Listing with("7_3_to_7_7", kMikimoto), without("7_3_to_7_7", WithoutStripe());
  ExpectGolden(with.Picture(), "listing_7_6");
  EXPECT_EQ(with.Volumes("Band").size(), 4u);
  const auto area = [](const Listing& listing) {
    double sum = 0;
    for (const Item& item : listing.Of("WindowExtr", ItemType::kPlanar)) sum += AreaOf(item);
    return sum;
  };
  EXPECT_LT(area(with), area(without) - 1);
}

TEST(Figure7_7, RaisingTheEntranceLeavesTheWindowsSizeAlone) {
  const Listing low("7_1", WithEntrance("3.5")), high("7_1", WithEntrance("5"));
  EXPECT_GT(high.Volumes("Door")[0].scope.size.y, low.Volumes("Door")[0].scope.size.y + 1);
  EXPECT_EQ(WindowSizes(low), WindowSizes(high));
  EXPECT_EQ(WindowSizes(low).size(), 1u);
  ExpectGolden(high.Picture(), "listing_7_7a");
}

TEST(Figure7_7, WithSplitsAloneItChangesTheFloors) {
  const Listing low("7_8", WithEntrance("4")), high("7_8", WithEntrance("5"));
  EXPECT_NE(WindowSizes(low), WindowSizes(high));
  ExpectGolden(high.Picture(), "listing_7_7b");
}

TEST(Listing7_8, SplitsAloneMakeTheSameFacadeInPieces) {
  const Listing split("7_8", Wide()), layered("7_1", Wide());
  EXPECT_EQ(split.Volumes("Door").size(), 1u);
  EXPECT_GT(split.Of("Plain", ItemType::kPlanar).size(), 50u) << "walls in pieces";
  EXPECT_LE(layered.BackgroundOf("Facade").size(), 3u) << "walls whole";
  ExpectGolden(split.Picture(), "listing_7_8");
}

}  // namespace
}  // namespace parti::tests
