#include "app/picking.h"

#include <gtest/gtest.h>

namespace parti::app {
namespace {

Model Towers() {
  auto lots = ParseLots("rect(10,10)");
  EXPECT_TRUE(lots);
  auto trees = grammar::ParseTrees("tree structure { .Lot --> extrude(8) Mass }");
  EXPECT_TRUE(trees);
  std::vector<Lot> two{(*lots)[0], (*lots)[0]};
  auto model = BuiltOn(std::move(two), std::move(*trees));
  EXPECT_TRUE(model);
  return std::move(*model);
}

TEST(PickingTest, IdsAndShapesFindEachOtherInEveryLot) {
  const Model model = Towers();
  for (const ShapeRef& ref : VisibleShapes(model)) {
    EXPECT_EQ(RefOfId(model, IdOfRef(model, ref)), ref);
  }
  EXPECT_EQ(RefOfId(model, 0), std::nullopt);
  EXPECT_EQ(RefOfId(model, 1000), std::nullopt);
}

TEST(PickingTest, ThePlaneIsThatOfTheNearestFace) {
  const Model model = Towers();
  const ShapeRef tower = VisibleShapes(model).front();
  Camera camera;
  camera.eye = {5, 4, 40};
  camera.target = {5, 4, 0};
  const auto front = PlaneAt(model, tower, camera, {800, 500});
  ASSERT_TRUE(front);
  EXPECT_NEAR(front->normal.z, 1, 1e-12);
  EXPECT_NEAR(front->offset, 10, 1e-9);
  EXPECT_FALSE(PlaneAt(model, tower, camera, {5, 5})) << "beside it";
}

}  // namespace
}  // namespace parti::app
