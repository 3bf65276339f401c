// Placing by hand, as values: what handles pull, and what it snaps to (Jesus 2018, 8.2.1).
#include "grammar/layers/layer_snap.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace parti::grammar::tests {
namespace {

const InteractiveLayer kDoor = {"Door", "DoorElement", 0, 4, 1.5, 2.5};
const InteractiveLayer kWindows = {"Windows", "WindowsGrid", 3, 2, 8, 4};

InteractiveLayer At(double left, double bottom, double width, double height) {
  return {"Door", "DoorElement", bottom, left, width, height};
}

TEST(LayerHandle, TheWholeIsDragged) { EXPECT_EQ(Pulled(kDoor, {}, 1, -2), Drag(kDoor, 1, -2)); }

TEST(LayerHandle, EdgesFollowAndThoseOppositeStay) {
  EXPECT_EQ(Pulled(kDoor, {1, 0}, 9, 0.5), At(4, 0, 2, 2.5));
  EXPECT_EQ(Pulled(kDoor, {-1, 0}, 9, 0.5), At(4.5, 0, 1, 2.5));
  EXPECT_EQ(Pulled(kDoor, {0, 1}, 0.5, 9), At(4, 0, 1.5, 3));
  EXPECT_EQ(Pulled(kWindows, {0, -1}, -1, 9).bottom, 2);
  EXPECT_EQ(Pulled(kWindows, {0, -1}, -1, 9).height, 5);
}

TEST(LayerHandle, ACornerIsTwoEdges) {
  EXPECT_EQ(Pulled(kDoor, {-1, 1}, 0.5, -1), At(3, 0, 2.5, 3));
}

TEST(LayerHandle, BordersAndTheLeastSizeStopIt) {
  EXPECT_EQ(Pulled(kDoor, {-1, -1}, -9, -9), At(0, 0, 5.5, 2.5));
  const InteractiveLayer least = Pulled(kDoor, {-1, 1}, -9, 9);
  EXPECT_NEAR(least.left + least.width, 5.5, 1e-12);
  EXPECT_NEAR(least.width, kLeastLayerSize_m, 1e-12);
  EXPECT_EQ(least.height, kLeastLayerSize_m);
}

RC_GTEST_PROP(LayerHandle, Property1And2EdgesThatAreNotHeldStay, ()) {
  const auto metres = [](int low, int high) { return *rc::gen::inRange(low, high) / 1000.0; };
  const InteractiveLayer layer =
      At(metres(0, 9000), metres(0, 9000), metres(10, 9000), metres(10, 9000));
  const LayerHandle handle{*rc::gen::inRange(-1, 2), *rc::gen::inRange(-1, 2)};
  RC_ASSERT(Pulled(layer, handle, 0, 0) == layer);
  const InteractiveLayer pulled =
      Pulled(layer, handle, metres(-20000, 20000), metres(-20000, 20000));
  RC_ASSERT(pulled.left >= 0 && pulled.bottom >= 0);
  RC_ASSERT(pulled.width >= kLeastLayerSize_m - 1e-12);
  RC_ASSERT(pulled.height >= kLeastLayerSize_m - 1e-12);
  if (handle.whole()) return;
  if (handle.across != -1) RC_ASSERT(pulled.left == layer.left);
  if (handle.up != -1) RC_ASSERT(pulled.bottom == layer.bottom);
  const double right = layer.left + layer.width, top = layer.bottom + layer.height;
  if (handle.across != 1) RC_ASSERT(std::abs(pulled.left + pulled.width - right) < 1e-9);
  if (handle.up != 1) RC_ASSERT(std::abs(pulled.bottom + pulled.height - top) < 1e-9);
}

const std::vector<InteractiveLayer> kOthers = {kWindows};

TEST(LayerSnap, AnEdgeWithinReachIsAligned) {
  const auto snapped = Snapped(At(2.1, 0.5, 1.5, 2), {}, kOthers, 0.2);
  EXPECT_EQ(snapped.layer, Align(kWindows, At(2.1, 0.5, 1.5, 2), LayerEdge::kLeft));
  EXPECT_EQ(snapped.across, (LayerSnap{LayerSnap::Kind::kEdge, 0, 2}));
  EXPECT_EQ(snapped.up, std::nullopt);
}

TEST(LayerSnap, MiddlesMeet) {
  const auto snapped = Snapped(At(5.2, 4, 1.5, 2.1), {}, kOthers, 0.2);
  EXPECT_EQ(snapped.layer.left, 5.25);
  EXPECT_EQ(snapped.across, (LayerSnap{LayerSnap::Kind::kCenter, 0, 6}));
  EXPECT_DOUBLE_EQ(snapped.layer.bottom, 3.95);
  EXPECT_EQ(snapped.up, (LayerSnap{LayerSnap::Kind::kCenter, 0, 5}));
}

TEST(LayerSnap, TheNearestCounts) {
  // 0.15 from the windows' left edge, 0.1 from the door's.
  const std::vector<InteractiveLayer> others = {kWindows, At(2.25, 0, 1, 1)};
  const auto snapped = Snapped(At(2.15, 0.5, 5, 2), {}, others, 0.2);
  EXPECT_EQ(snapped.across, (LayerSnap{LayerSnap::Kind::kEdge, 1, 2.25}));
}

TEST(LayerSnap, AnEdgeThatIsPulledMeetsTheSameEdgeOrMakesTheSizeTheSame) {
  const auto edge = Snapped(At(4, 0, 5.9, 2), {1, 0}, kOthers, 0.2);
  EXPECT_EQ(edge.layer, At(4, 0, 6, 2));
  EXPECT_EQ(edge.across, (LayerSnap{LayerSnap::Kind::kEdge, 0, 10}));
  const auto size = Snapped(At(11, 0, 7.9, 2), {1, 1}, kOthers, 0.2);
  EXPECT_EQ(size.layer.width, SameSize(kWindows, kDoor).width);
  EXPECT_EQ(size.across, (LayerSnap{LayerSnap::Kind::kSize, 0, 0}));
  EXPECT_EQ(size.up, std::nullopt);
  const auto from_left = Snapped(At(10.1, 0, 7.9, 2), {-1, 0}, kOthers, 0.2);
  EXPECT_NEAR(from_left.layer.left, 10, 1e-12);
  EXPECT_NEAR(from_left.layer.width, 8, 1e-12);
}

TEST(LayerSnap, WhatTheBordersForbidIsLeftOut) {
  // Right edges on one line would need a left of -0.1.
  const std::vector<InteractiveLayer> others = {At(0.7, 9, 0.2, 1)};
  const auto snapped = Snapped(At(0.05, 0, 1, 2), {}, others, 0.2);
  EXPECT_EQ(snapped.across, std::nullopt);
  EXPECT_EQ(snapped.layer.left, 0.05);
}

RC_GTEST_PROP(LayerSnap, Property1NothingMovesFartherThanTheReach, ()) {
  const auto any = [] {
    const auto metres = [](int low) { return *rc::gen::inRange(low, 3000) / 1000.0; };
    return At(metres(0), metres(0), metres(10), metres(10));
  };
  const InteractiveLayer pulled = any();
  const LayerHandle handle{*rc::gen::inRange(-1, 2), *rc::gen::inRange(-1, 2)};
  const std::vector<InteractiveLayer> others = {any(), any(), any()};
  const double reach = *rc::gen::inRange(0, 500) / 1000.0;
  const auto [layer, across, up] = Snapped(pulled, handle, others, reach);
  const double most = reach + 1e-9;
  RC_ASSERT(std::abs(layer.left - pulled.left) <= most);
  RC_ASSERT(std::abs(layer.bottom - pulled.bottom) <= most);
  RC_ASSERT(std::abs(layer.width - pulled.width) <= most);
  RC_ASSERT(std::abs(layer.height - pulled.height) <= most);
  if (!across) RC_ASSERT(layer.left == pulled.left && layer.width == pulled.width);
  if (!up) RC_ASSERT(layer.bottom == pulled.bottom && layer.height == pulled.height);
}

}  // namespace
}  // namespace parti::grammar::tests
