// Meshes: closed, outward, and still so after any number of cuts.
#include "grammar/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"

namespace parti::grammar::tests {
namespace {

TEST(Prism, HasBottomTopAndASidePerEdge) {
  const Mesh prism = Prism(Rectangle(Vec2(10, 8)), 3);
  ASSERT_EQ(prism.faces.size(), 6u);
  EXPECT_EQ(Normal(prism, prism.faces[0]), Vec3(0, 0, -1));
  EXPECT_EQ(Normal(prism, prism.faces[1]), Vec3(0, 0, 1));
  EXPECT_EQ(Normal(prism, prism.faces[2]), Vec3(0, -1, 0));
  EXPECT_NEAR(Volume(prism), 240, 1e-12);
  EXPECT_EQ(OpenEdges(prism), 0);
}

TEST(Prism, OfNegativeHeightLooksOutwardToo) {
  const Mesh prism = Prism(Rectangle(Vec2(10, 8)), -3);
  EXPECT_NEAR(Volume(prism), 240, 1e-12);
  EXPECT_EQ(Normal(prism, prism.faces[1]), Vec3(0, 0, 1));
}

TEST(BoxMesh, LooksOutward) {
  const Mesh box = BoxMesh(Vec3(2, 3, 5));
  EXPECT_NEAR(Volume(box), 30, 1e-12);
  EXPECT_EQ(OpenEdges(box), 0);
  EXPECT_EQ(Normal(box, box.faces[1]), Vec3(0, 1, 0));
  EXPECT_EQ(Normal(box, box.faces[2]), Vec3(0, 0, 1));
}

RC_GTEST_PROP(PrismProperty, VolumeIsAreaTimesHeight, (uint64_t seed)) {
  Random random(seed);
  const Polygon polygon = AnyPolygon(&random);
  const double height = random.Uniform(-20, 20);
  RC_PRE(std::abs(height) > 0.01);
  const Mesh prism = Prism(polygon, height);
  RC_ASSERT(OpenEdges(prism) == 0);
  const double volume = Area(polygon) * std::abs(height);
  RC_ASSERT(std::abs(Volume(prism) - volume) < 1e-9 * (1 + volume));
}

/// A prism on its side or upright, already cut once or twice: a mesh with caps.
Mesh AnyMesh(Random* random) {
  Mesh mesh = Prism(AnyPolygon(random), random->Uniform(1, 9));
  const int turn = static_cast<int>(random->Uniform(0, 3));
  for (Vec3& p : mesh.points) {
    if (turn == 1) p = Vec3(p.y, p.z, p.x);
    if (turn == 2) p = Vec3(p.z, p.x, p.y);
  }
  return mesh;
}

struct Bounds3 {
  Vec3 low, high;
  explicit Bounds3(const Mesh& mesh) : low(mesh.points[0]), high(low) {
    for (const Vec3& p : mesh.points) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
};

/// Distance of the farthest corner of a face from the face's own plane.
double Unevenness(const Mesh& mesh, const MeshFace& face) {
  const Vec3 normal = Normal(mesh, face);
  double worst = 0;
  const auto visit = [&](uint32_t i) {
    worst = std::max(worst, std::abs(glm::dot(mesh.points[i] - mesh.points[face.loop[0]], normal)));
  };
  for (const uint32_t i : face.loop) visit(i);
  for (const auto& hole : face.holes) {
    for (const uint32_t i : hole) visit(i);
  }
  return worst;
}

// Cuts along all three axes, one after the other, at whole numbers, through corners and anywhere:
// (1) every piece is closed; (2) volumes add up; (3) pieces keep to their slab; (4) faces are flat.
RC_GTEST_PROP(MeshSlabProperty, SlabsTileTheMesh, (uint64_t seed)) {
  Random random(seed);
  std::vector<Mesh> meshes = {AnyMesh(&random)};
  const double volume = Volume(meshes[0]);
  const bool whole = random.Uniform() < 0.5;
  for (const int axis : {0, 2, 1}) {
    std::vector<Mesh> parts;
    for (const Mesh& mesh : meshes) {
      const Bounds3 box(mesh);
      const auto n = static_cast<double>(mesh.points.size());
      std::vector<double> cuts = {box.low[axis], box.high[axis]};
      const double at = random.Uniform(box.low[axis], box.high[axis]);
      cuts.push_back(whole ? std::round(at) : at);
      cuts.push_back(mesh.points[static_cast<size_t>(random.Uniform(0, n))][axis]);
      std::sort(cuts.begin(), cuts.end());
      for (size_t i = 0; i + 1 < cuts.size(); ++i) {
        Mesh part = Slab(mesh, axis, cuts[i], cuts[i + 1]);
        if (part.faces.empty()) continue;
        RC_ASSERT(OpenEdges(part) == 0);
        RC_ASSERT(Bounds3(part).low[axis] >= cuts[i] - 1e-8);
        RC_ASSERT(Bounds3(part).high[axis] <= cuts[i + 1] + 1e-8);
        for (const MeshFace& face : part.faces) RC_ASSERT(Unevenness(part, face) < 1e-6);
        parts.push_back(std::move(part));
      }
    }
    meshes = std::move(parts);
  }
  double sum = 0;
  for (const Mesh& mesh : meshes) sum += Volume(mesh);
  RC_ASSERT(std::abs(sum - volume) < 1e-7 * (1 + volume));
}

TEST(MeshSlab, CapsHaveHolesWhereTheMeshHas) {
  const auto court = PolygonFrom({RingFrom("0,0 10,0 10,10 0,10"), RingFrom("3,3 7,3 7,7 3,7")});
  const Mesh middle = Slab(Prism(*court, 6), 2, 2, 4);
  EXPECT_EQ(OpenEdges(middle), 0);
  EXPECT_NEAR(Volume(middle), 84 * 2, 1e-9);
  int with_holes = 0;
  for (const MeshFace& face : middle.faces) with_holes += face.holes.empty() ? 0 : 1;
  EXPECT_EQ(with_holes, 2);
}

TEST(MeshSlab, ASlabHasThePaintsThatItsFacesWearAndNoOthers) {
  Mesh box = BoxMesh(Vec3(1, 1, 1));
  for (MeshFace& face : box.faces) {
    Paint& paint = box.paints.emplace_back();
    paint.map = TextureMap{Vec3(static_cast<double>(box.paints.size()), 0, 0), Vec3(0, 1, 0), {}};
    face.paint = static_cast<uint32_t>(box.paints.size());
  }
  const auto paints_by_normal = [](const Mesh& mesh) {
    std::vector<std::pair<Vec3, Paint>> paints;
    for (const MeshFace& face : mesh.faces) {
      if (face.paint > 0) paints.emplace_back(Normal(mesh, face), mesh.paints.at(face.paint - 1));
    }
    return paints;
  };
  const auto of_box = paints_by_normal(box);
  for (const auto& [low, high, sides] :
       {std::tuple(0.25, 0.75, 4u), {0.0, 0.5, 5u}, {0.5, 1.0, 5u}}) {
    const Mesh slab = Slab(box, 0, low, high);
    EXPECT_EQ(slab.paints.size(), sides);
    const auto of_slab = paints_by_normal(slab);
    EXPECT_EQ(of_slab.size(), sides) << "caps have no paint";
    for (const auto& worn : of_slab) EXPECT_THAT(of_box, testing::Contains(worn));
  }
}

TEST(MeshSlab, NothingIsLeftOutsideTheMesh) {
  const Mesh box = BoxMesh(Vec3(2, 3, 5));
  EXPECT_TRUE(Slab(box, 0, 2, 4).faces.empty());
  EXPECT_TRUE(Slab(box, 0, -4, 0).faces.empty());
  EXPECT_TRUE(Slab(box, 0, 1, 1).faces.empty());
  EXPECT_TRUE(Slab(Mesh(), 0, 0, 1).faces.empty());
  EXPECT_EQ(Slab(box, 0, -1, 9), box);
}

}  // namespace
}  // namespace parti::grammar::tests
