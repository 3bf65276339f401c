#include "input/pointer_position.h"

#include <gtest/gtest.h>

#include <limits>

namespace parti::input {
namespace {

Vec2 Place_px(const PointerPosition& pointer) {
  return pointer.position_mm() * PointerPosition::kViewPxPerMm;
}

TEST(PointerPosition, AddsUpMotionsAndStaysInTheView) {
  PointerPosition pointer;
  pointer.SetView({1000, 600}, 1);
  pointer.MoveTo({0.5, 0.5});
  pointer.MoveBy({10, -20});
  EXPECT_LT(glm::distance(Place_px(pointer), Vec2(510, 280)), 1e-9);
  pointer.MoveBy({-9999, 9999});
  EXPECT_LT(glm::distance(Place_px(pointer), Vec2(0, 600)), 1e-9);
  pointer.MoveBy({3, -4});  // it does not have to be brought back first
  EXPECT_LT(glm::distance(Place_px(pointer), Vec2(3, 596)), 1e-9);
}

TEST(PointerPosition, MovesAsFarOnDenseScreens) {
  PointerPosition pointer;
  pointer.SetView({2000, 1200}, 2);
  pointer.MoveTo({0, 0});
  pointer.MoveBy({10, 5});
  EXPECT_LT(glm::distance(Place_px(pointer), Vec2(20, 10)), 1e-9);
}

TEST(PointerPosition, KeepsItsPlaceInAViewOfAnotherSize) {
  PointerPosition pointer;
  pointer.SetView({1000, 600}, 1);
  pointer.MoveTo({0.25, 0.75});
  pointer.SetView({400, 400}, 1);
  EXPECT_LT(glm::distance(Place_px(pointer), Vec2(100, 300)), 1e-9);
}

TEST(PointerPosition, NumbersThatAreNoneChangeNothing) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  PointerPosition pointer;
  const PointerPosition before = pointer;
  pointer.MoveBy({kNaN, 1});
  pointer.MoveTo({1, kNaN});
  pointer.SetView({0, 100}, 1);
  pointer.SetView({kNaN, 100}, 1);
  pointer.SetView({10, 10}, 0);
  EXPECT_EQ(pointer, before);
}

}  // namespace
}  // namespace parti::input
