// Meshes that are open, painted, scaled or mirrored.
#include <gtest/gtest.h>

#include "grammar/mesh.h"

namespace parti::grammar {
namespace {

/// A box without its top.
Mesh OpenBox(const Vec3& size) {
  Mesh mesh = BoxMesh(size);
  mesh.faces.erase(mesh.faces.begin() + 1);
  mesh.closed = IsClosed(mesh);
  return mesh;
}

double AreaSum(const Mesh& mesh) {
  double sum = 0;
  for (const MeshFace& face : mesh.faces) {
    const Vec3& o = mesh.points[face.loop[0]];
    Vec3 twice(0, 0, 0);
    for (size_t i = 2; i < face.loop.size(); ++i) {
      twice += glm::cross(mesh.points[face.loop[i - 1]] - o, mesh.points[face.loop[i]] - o);
    }
    sum += glm::length(twice) / 2;
  }
  return sum;
}

TEST(Mesh, IsOpenWhereAFaceIsMissingOrTurned) {
  Mesh mesh = BoxMesh(Vec3(2, 3, 4));
  EXPECT_TRUE(IsClosed(mesh));
  std::swap(mesh.faces[0].loop[0], mesh.faces[0].loop[2]);
  EXPECT_FALSE(IsClosed(mesh));
  EXPECT_FALSE(IsClosed(OpenBox(Vec3(1, 1, 1))));
  EXPECT_FALSE(IsClosed(Mesh()));
}

TEST(Mesh, OpenOnesHaveNoVolume) { EXPECT_EQ(Volume(OpenBox(Vec3(2, 3, 4))), 0); }

TEST(Mesh, OpenOnesAreCutWithoutCaps) {
  const Mesh box = OpenBox(Vec3(2, 3, 4));
  const Mesh low = Slab(box, 1, 0, 1), high = Slab(box, 1, 1, 3);
  EXPECT_EQ(low.faces.size(), 5u);
  EXPECT_EQ(high.faces.size(), 4u);
  EXPECT_FALSE(low.closed);
  EXPECT_NEAR(AreaSum(low) + AreaSum(high), AreaSum(box), 1e-9);
}

TEST(Mesh, PiecesKeepThePaintOfTheirFaceAndCapsHaveNone) {
  Mesh box = BoxMesh(Vec3(2, 3, 4));
  box.paints.push_back({nullptr, TextureMap{Vec3(0.5, 0, 0), Vec3(0, 0.25, 0), Vec2(0, 0)}, {}});
  for (MeshFace& face : box.faces) face.paint = 1;
  const Mesh high = Slab(box, 1, 1, 3);
  ASSERT_EQ(high.faces.size(), 6u);
  ASSERT_EQ(high.paints, box.paints);
  int plain = 0;
  for (const MeshFace& face : high.faces) {
    if (face.paint != 0) continue;
    ++plain;
    EXPECT_EQ(Normal(high, face), Vec3(0, -1, 0));
  }
  EXPECT_EQ(plain, 1);
}

TEST(Mesh, TexturesStayOnTheirPointsWhenScaled) {
  Mesh box = BoxMesh(Vec3(2, 3, 4));
  const TextureMap map{Vec3(0.5, 0, 0.25), Vec3(0, 0.25, 0), Vec2(0.1, -3)};
  box.paints.push_back({nullptr, map, {}});
  const Mesh scaled = Rescaled(box, Vec3(1, 1, 1), Vec3(0.5, 2, 3));
  for (size_t i = 0; i < box.points.size(); ++i) {
    const Vec2 before = map.At(box.points[i]), after = scaled.paints[0].map->At(scaled.points[i]);
    EXPECT_NEAR(glm::distance(before, after), 0, 1e-12);
  }
  EXPECT_EQ(scaled.points[6], Vec3(0.5, 4, -3));
}

TEST(Mesh, MirroredTwiceIsTheSameAndFacesLookOutwardAllTheWay) {
  const Mesh box = BoxMesh(Vec3(2, 3, 4));
  const bool x_only[3] = {true, false, false}, two[3] = {true, true, false};
  const Mesh once = Mirrored(box, Vec3(2, 3, 4), x_only);
  EXPECT_NEAR(Volume(once), 24, 1e-9);
  EXPECT_EQ(Mirrored(once, Vec3(2, 3, 4), x_only), box);
  EXPECT_NEAR(Volume(Mirrored(box, Vec3(2, 3, 4), two)), 24, 1e-9);
}

TEST(Mesh, TexturesAreMirroredWithTheirPoints) {
  Mesh box = BoxMesh(Vec3(2, 3, 4));
  const TextureMap map{Vec3(0.5, 0, 0.25), Vec3(0, 0.25, 0), Vec2(0.1, -3)};
  box.paints.push_back({nullptr, map, {}});
  const bool all[3] = {true, true, true};
  const Mesh turned = Mirrored(box, Vec3(2, 3, 4), all);
  for (size_t i = 0; i < box.points.size(); ++i) {
    const Vec2 before = map.At(box.points[i]), after = turned.paints[0].map->At(turned.points[i]);
    EXPECT_NEAR(glm::distance(before, after), 0, 1e-12);
  }
}

}  // namespace
}  // namespace parti::grammar
