// Edges, corners and painted surfaces of items.
#include "grammar/item_surface.h"

#include <gtest/gtest.h>

#include "grammar/item_edges.h"
#include "grammar/item_make.h"

namespace parti::grammar {
namespace {

Item Box(const Vec3& size) {
  Scope scope;
  scope.origin = Vec3(10, 0, -5);
  scope.size = size;
  return *BoxFrom(scope);
}

std::shared_ptr<const Material> Red() {
  Material material;
  material.name = "red";
  material.color_rgb = 0xff0000;
  return std::make_shared<const Material>(std::move(material));
}

TEST(ItemSurface, PlainItemsAreOnePartWithTheTrianglesOfTheItem) {
  Item box = Box(Vec3(1, 2, 3));
  box.color_rgb = 0x123456;
  const auto parts = SurfaceOf(box);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].color_rgb, 0x123456u);
  EXPECT_EQ(parts[0].corners.size(), 36u);
  EXPECT_TRUE(parts[0].uvs.empty());
}

TEST(ItemSurface, PaintedFacesAreAPartOfTheirOwn) {
  Item box = Box(Vec3(1, 2, 3));
  Mesh mesh = MeshOf(box);
  mesh.paints.push_back({Red(), std::nullopt, std::nullopt});
  mesh.faces[2].paint = 1;
  box.mesh = std::make_shared<const Mesh>(std::move(mesh));
  const auto parts = SurfaceOf(box);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].corners.size(), 30u);
  EXPECT_EQ(parts[1].corners.size(), 6u);
  EXPECT_EQ(parts[1].color_rgb, 0xff0000u);
  box.color_rgb = 0x00ff00;
  EXPECT_EQ(SurfaceOf(box)[1].color_rgb, 0x00ff00u) << "the item's color goes before";
}

TEST(ItemSurface, TextureOfAnItemIsThatOfItsPlaceInTheWorld) {
  Item box = Box(Vec3(4, 2, 3));
  Paint paint;
  paint.map = TextureMap{Vec3(0.5, 0, 0), Vec3(0, 1, 0), Vec2(-5, 0)};
  box.paint = std::make_shared<const Paint>(paint);
  const Item front = FacesOf(box)[2];
  ASSERT_EQ(front.facing, Vec3(0, 0, 1));
  const auto parts = SurfaceOf(front);
  ASSERT_EQ(parts.size(), 1u);
  ASSERT_EQ(parts[0].uvs.size(), parts[0].corners.size());
  EXPECT_EQ(parts[0].uvs[0], Vec2(0, 0));
  EXPECT_EQ(parts[0].uvs[2], Vec2(2, 2));
}

TEST(ItemSurface, FacesAlongTheTextureAreMappedInTheirOwnPlane) {
  Item box = Box(Vec3(4, 2, 3));
  Paint paint;
  paint.map = TextureMap{Vec3(0.5, 0, 0), Vec3(0, 1, 0), Vec2(-5, 0)};
  box.paint = std::make_shared<const Paint>(paint);
  const Item right = FacesOf(box)[3];
  ASSERT_EQ(right.facing, Vec3(1, 0, 0));
  const auto uvs = SurfaceOf(right)[0].uvs;
  EXPECT_EQ(uvs[0], Vec2(0, 0));
  EXPECT_EQ(uvs[2], Vec2(1.5, 2)) << "3 m deep at half an image a metre";
}

TEST(ItemSurface, UnitMeshesFillTheScopeWhateverItsSize) {
  Item box = Box(Vec3(4, 2, 3));
  const Item plain = box;
  box.mesh = std::make_shared<const Mesh>(BoxMesh(Vec3(1, 1, 1)));
  box.mesh_is_unit = true;
  EXPECT_DOUBLE_EQ(VolumeOf(box), VolumeOf(plain));
  EXPECT_DOUBLE_EQ(AreaOf(box), AreaOf(plain));
  std::vector<Vec3> a, b;
  TrianglesOf(box, &a);
  TrianglesOf(plain, &b);
  EXPECT_EQ(a, b);
  EXPECT_EQ(FacesOf(box).size(), 6u);
  EXPECT_EQ(EdgesOf(box).size(), 12u);
}

TEST(ItemSurface, FacesThatLieFlatInAnEmptyScopeAreLeftOut) {
  Item box = Box(Vec3(4, 2, 3));
  box.scope.size.z = 0;
  box.mesh = std::make_shared<const Mesh>(BoxMesh(Vec3(1, 1, 1)));
  box.mesh_is_unit = true;
  EXPECT_EQ(FacesOf(box).size(), 2u);
  std::vector<Vec3> corners;
  TrianglesOf(box, &corners);
  EXPECT_EQ(corners.size(), 12u);
}

TEST(ItemEdges, ABoxHasTwelveAndEightCorners) {
  const Item box = Box(Vec3(1, 2, 3));
  const auto edges = ItemEdgesOf(box);
  EXPECT_EQ(edges.size(), 12u);
  for (const ItemEdge& edge : edges) {
    EXPECT_EQ(edge.faces, 2);
    EXPECT_NEAR(glm::dot(edge.normal, edge.other), 0, 1e-12);
  }
  const auto corners = ItemCornersOf(box);
  EXPECT_EQ(corners.size(), 8u);
  for (const ItemCorner& corner : corners) EXPECT_FALSE(corner.on_border);
}

TEST(ItemEdges, APlanarShapeHasThoseOfItsOutlineAndHoles) {
  Scope scope;
  const Item ring = PlanarItem(
      scope, {Rectangle(Vec2(4, 4)).outer, {{Vec2(1, 1), Vec2(1, 2), Vec2(2, 2), Vec2(2, 1)}}},
      Item());
  EXPECT_EQ(ItemEdgesOf(ring).size(), 8u);
  const auto corners = ItemCornersOf(ring);
  ASSERT_EQ(corners.size(), 8u);
  EXPECT_TRUE(corners[5].on_border);
  EXPECT_NEAR(glm::distance(corners[0].normal, glm::normalize(Vec3(-1, -1, 0))), 0, 1e-9);
}

}  // namespace
}  // namespace parti::grammar
