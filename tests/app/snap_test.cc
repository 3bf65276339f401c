#include "app/snap.h"

#include <gtest/gtest.h>

#include "app/auto_view.h"
#include "app/picture.h"

namespace parti::app {
namespace {

/// A tower with façades, seen from the south-east.
class SnapTest : public ::testing::Test {
 protected:
  Vec2 PixelOf(const Vec3& p) const { return *View(camera_).Project(p); }
  std::optional<Snap> At(const std::string& id, const Vec2& px, double reach_px = 10) const {
    return SnapAt(model_, *RefAt(model_, id), camera_, px, reach_px);
  }

  const Model model_ = *BuiltOn(*ParseLots("rect(20,14)"), *grammar::ParseTrees(R"(tree t {
    .Lot --> extrude(12) Mass
    .Mass --> comp(f) { side: Facade | top: Roof } })"));
  const Camera camera_ = [] {
    Camera camera;
    camera.eye = {50, 20, 50};
    camera.target = {10, 6, 7};
    return camera;
  }();
  /// The façade that faces south.
  const std::string south_ = [this] {
    const auto shapes =
        *grammar::ProductOf(*grammar::ParseQuery(".Facade:south"), model_.derived[0]->tree);
    return model_.derived[0]->tree.IdOf(shapes.at(0));
  }();
};

TEST_F(SnapTest, NearACornerTheCornerIsMeant) {
  const auto snap = At(south_, PixelOf({19.9, 11.9, 14}));
  ASSERT_TRUE(snap);
  EXPECT_EQ(snap->kind, Snap::Kind::kCorner);
  EXPECT_NEAR(glm::distance(snap->point, Vec3(20, 12, 14)), 0, 1e-9);
  EXPECT_EQ(snap->word, "corner of Facade");
}

TEST_F(SnapTest, NearAnEdgeThePointOnTheEdgeIsMeant) {
  const auto snap = At(south_, PixelOf({7, 11.9, 14}));
  ASSERT_TRUE(snap);
  EXPECT_EQ(snap->kind, Snap::Kind::kEdge);
  EXPECT_NEAR(glm::distance(snap->point, Vec3(7, 12, 14)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(snap->edge.a, snap->edge.b), 20, 1e-9);
  EXPECT_EQ(snap->word, "edge of Facade");
}

TEST_F(SnapTest, InTheMiddleTheFaceIsMeant) {
  const auto snap = At(south_, PixelOf({9, 5, 14}));
  ASSERT_TRUE(snap);
  EXPECT_EQ(snap->kind, Snap::Kind::kFace);
  EXPECT_NEAR(glm::distance(snap->point, Vec3(9, 5, 14)), 0, 1e-6);
  EXPECT_EQ(snap->word, "Facade");
}

TEST_F(SnapTest, WithoutReachOnlyTheFaceIsMeant) {
  EXPECT_EQ(At(south_, PixelOf({7, 11.9, 14}), 0)->kind, Snap::Kind::kFace);
}

TEST_F(SnapTest, EdgesOnTheFarSideOfAVolumeAreNotMeant) {
  // The far upright edge of the mass, seen through its south face.
  const View view(camera_);
  const Vec2 px = PixelOf({0, 6, 0});
  const auto hit = Intersect(view.RayThrough(px), Plane{{0, 0, 1}, 14});
  ASSERT_TRUE(hit && hit->x > 0 && hit->x < 20 && hit->y < 12) << "it is behind the south face";
  EXPECT_EQ(At("0", px)->kind, Snap::Kind::kFace);
}

TEST_F(SnapTest, WhereTheShapeIsNotNothingIsMeant) {
  EXPECT_FALSE(At(south_, {5, 5}));
  EXPECT_FALSE(At(south_, {NAN, 5}));
}

}  // namespace
}  // namespace parti::app
