#include "app/view_request.h"

#include <gtest/gtest.h>

namespace parti::app {
namespace {

render::Bounds Lot() {
  render::Bounds bounds;
  bounds.Add({0, 0, 0});
  bounds.Add({20, 0, 14});
  return bounds;
}

TEST(ViewRequestTest, ALotIsSeenWithRoomForWalls) {
  const View view(ViewFor(ViewRequest::kFit, Camera{}, Lot()));
  for (const Vec3& corner : {Vec3(0, 8, 0), Vec3(20, 8, 0), Vec3(0, 8, 14), Vec3(20, 8, 14)}) {
    const auto px = view.Project(corner);
    ASSERT_TRUE(px);
    EXPECT_GT(px->y, 0);
    EXPECT_GT(px->x, 0);
    EXPECT_LT(px->x, 1600);
  }
}

TEST(ViewRequestTest, EveryRequestGivesACameraOfTheSameSize) {
  Camera camera;
  camera.width_px = 900;
  camera.height_px = 1300;
  for (int i = 0; i <= static_cast<int>(ViewRequest::kFarther); ++i) {
    const Camera next = ViewFor(static_cast<ViewRequest>(i), camera, Lot());
    EXPECT_TRUE(Validate(next)) << i;
    EXPECT_EQ(next.width_px, 900) << i;
    EXPECT_EQ(next.height_px, 1300) << i;
    EXPECT_TRUE(Validate(ViewFor(static_cast<ViewRequest>(i), camera, {}))) << "an empty model";
  }
}

TEST(ViewRequestTest, NearerAndFartherUndoEachOther) {
  Camera camera;
  camera.eye = {10, 12, 30};
  const Camera back = ViewFor(ViewRequest::kFarther, ViewFor(ViewRequest::kNearer, camera, {}), {});
  EXPECT_LT(glm::distance(back.eye, camera.eye), 1e-6);
}

}  // namespace
}  // namespace parti::app
