// Items from the world's rings and boxes; their scopes, faces, edges and triangles.
#include "grammar/item.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"

namespace parti::grammar::tests {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

MATCHER_P(IsNear, v, "") { return glm::distance(arg, v) < 1e-9; }

TEST(PlanarFrom, LotFacesUpWhateverItsWinding) {
  for (const std::string outline : {"0,0 10,0 10,8 0,8", "0,8 10,8 10,0 0,0"}) {
    const Item lot = Lot(outline);
    EXPECT_THAT(lot.facing, IsNear(Vec3(0, 1, 0)));
    EXPECT_THAT(lot.scope.z, IsNear(Vec3(0, 1, 0)));
    EXPECT_EQ(lot.polygon, nullptr);
    EXPECT_THAT(lot.scope.size, IsNear(Vec3(10, 8, 0)));
  }
}

TEST(PlanarFrom, XRunsAlongTheFirstEdge) {
  const Item lot = Lot("0,0 3,4 -1,7 -4,3");
  EXPECT_THAT(lot.scope.x, IsNear(Vec3(0.6, 0, -0.8)));
  EXPECT_THAT(lot.scope.y, IsNear(Vec3(-0.8, 0, -0.6)));
  EXPECT_THAT(lot.scope.origin, IsNear(Vec3(0, 0, 0)));
  // The first edge of some length, where corners repeat.
  EXPECT_THAT(Lot("0,0 0,0 3,4 -1,7 -4,3").scope.x, IsNear(Vec3(0.6, 0, -0.8)));
  // A spike first: what is left counts.
  EXPECT_THAT(Lot("-4,3 -9,3 -4,3 0,0 3,4 -1,7").scope.x, IsNear(Vec3(0.8, 0, 0.6)));
}

TEST(PlanarFrom, ScopeStandsAtTheMinimumCorner) {
  const Item lot = Lot("0,0 10,0 12,8 -3,8");
  EXPECT_THAT(lot.scope.origin, IsNear(Vec3(-3, 0, 0)));
  EXPECT_THAT(lot.scope.size, IsNear(Vec3(15, 8, 0)));
  ASSERT_NE(lot.polygon, nullptr);
  EXPECT_NEAR(AreaOf(lot), 100, 1e-9);
  EXPECT_EQ(Bounds(*lot.polygon).low, Vec2(0, 0));
}

TEST(PlanarFrom, RoundedRectanglesAreRectangles) {
  const Item face = Lot("0,0 8.66025,5 4.66025,11.92820 -4,6.92820");
  EXPECT_EQ(face.polygon, nullptr);
}

TEST(PlanarFrom, SlightlyUnevenCornersAreProjected) {
  const auto item =
      PlanarFrom({{Vec3(0, 0, 0), Vec3(10, 0.004, 0), Vec3(10, 0, -8), Vec3(0, 0.004, -8)}});
  ASSERT_TRUE(item.has_value()) << item.error().message;
  EXPECT_NEAR(AreaOf(*item), 80, 1e-3);
}

TEST(PlanarFrom, UnevenCornersAreRefusedWithPlaceAndDistance) {
  const auto item = PlanarFrom({{Vec3(0, 0, 0), Vec3(10, 1, 0), Vec3(10, 0, -8), Vec3(0, 1, -8)}});
  ASSERT_FALSE(item.has_value());
  EXPECT_EQ(item.error().code, ErrorCode::kNotPlanar);
  EXPECT_THAT(item.error().message, ::testing::HasSubstr("off the plane"));
}

TEST(PlanarFrom, RefusesWhatIsNoPolygon) {
  const auto code = [](const std::vector<std::vector<Vec3>>& rings) {
    const auto item = PlanarFrom(rings);
    EXPECT_FALSE(item.has_value());
    return item ? ErrorCode::kFile : item.error().code;
  };
  EXPECT_EQ(code({}), ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(code({{}}), ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(code({{Vec3(0), Vec3(1)}}), ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(code({{Vec3(0), Vec3(1), Vec3(2)}}), ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(code({{Vec3(0), Vec3(0), Vec3(0), Vec3(0)}}), ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(code({{Vec3(0), Vec3(kNaN, 0, 0), Vec3(2, 0, 1)}}), ErrorCode::kBadNumber);
  EXPECT_EQ(code({{Vec3(0, 0, 0), Vec3(4, 0, 4), Vec3(4, 0, 0), Vec3(0, 0, 4)}}),
            ErrorCode::kSelfIntersecting);
  EXPECT_EQ(LotFrom({RingFrom("0,0 10,10 10,0 0,10")}).error().code, ErrorCode::kSelfIntersecting);
  EXPECT_EQ(LotFrom({RingFrom("0,0 0,0 0,0")}).error().code, ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(LotFrom({RingFrom("0,0 5,0 5,0 0,0")}).error().code, ErrorCode::kDegenerateGeometry);
}

TEST(BoxFrom, StandsUp) {
  Scope scope;
  scope.x = Vec3(0, 1, 0);  // its x axis is up
  scope.y = Vec3(0, 0, 1);
  scope.z = Vec3(1, 0, 0);
  scope.size = Vec3(3, 4, 5);
  const auto box = BoxFrom(scope);
  ASSERT_TRUE(box.has_value());
  EXPECT_THAT(box->scope.y, IsNear(Vec3(0, 1, 0)));
  EXPECT_THAT(box->scope.z, IsNear(Vec3(1, 0, 0)));
  EXPECT_THAT(box->scope.size, IsNear(Vec3(4, 3, 5)));
  EXPECT_THAT(glm::cross(box->scope.x, box->scope.y), IsNear(box->scope.z));
  EXPECT_NEAR(VolumeOf(*box), 60, 1e-12);
  EXPECT_EQ(box->facing, Vec3(0, 0, 0));
}

TEST(BoxFrom, RefusesBadSizesAndAxes) {
  Scope scope;
  EXPECT_EQ(BoxFrom(scope).error().code, ErrorCode::kDegenerateGeometry);
  scope.size = Vec3(1, -1, 1);
  EXPECT_EQ(BoxFrom(scope).error().code, ErrorCode::kDegenerateGeometry);
  scope.size = Vec3(1, kNaN, 1);
  EXPECT_EQ(BoxFrom(scope).error().code, ErrorCode::kBadNumber);
  scope.size = Vec3(1, 1, 1);
  scope.x = Vec3(2, 0, 0);
  EXPECT_EQ(BoxFrom(scope).error().code, ErrorCode::kBadNumber);
  scope.x = Vec3(-1, 0, 0);  // left-handed
  EXPECT_EQ(BoxFrom(scope).error().code, ErrorCode::kBadNumber);
}

TEST(FacesOf, NullGeometryAndItsMeshHaveTheSameFaces) {
  Item box = Apply(Extrude(6), Lot("0,0 6,8 -2,14 -8,6"))->front().item;
  ASSERT_EQ(box.mesh, nullptr);
  const std::vector<Item> quick = FacesOf(box);
  box.mesh = std::make_shared<const Mesh>(MeshOf(box));
  const std::vector<Item> general = FacesOf(box);
  ASSERT_EQ(quick.size(), general.size());
  for (size_t i = 0; i < quick.size(); ++i) {
    EXPECT_EQ(general[i].polygon, nullptr);
    EXPECT_THAT(quick[i].scope.origin, IsNear(general[i].scope.origin)) << i;
    EXPECT_THAT(quick[i].scope.x, IsNear(general[i].scope.x)) << i;
    EXPECT_THAT(quick[i].scope.y, IsNear(general[i].scope.y)) << i;
    EXPECT_THAT(quick[i].scope.z, IsNear(general[i].scope.z)) << i;
    EXPECT_THAT(quick[i].scope.size, IsNear(general[i].scope.size)) << i;
    EXPECT_THAT(quick[i].facing, IsNear(general[i].facing)) << i;
  }
  const Item plain = Apply(Extrude(6), Lot("0,0 6,8 -2,14 -8,6"))->front().item;
  EXPECT_EQ(EdgesOf(plain).size(), EdgesOf(box).size());
  std::vector<Vec3> a, b;
  TrianglesOf(plain, &a);
  TrianglesOf(box, &b);
  EXPECT_EQ(a.size(), b.size());
  EXPECT_NEAR(AreaOf(plain), AreaOf(box), 1e-9);
}

/// Area, enclosed volume and centre of gravity of triangles: what windings show in.
struct Solid {
  double area = 0, volume = 0;
  explicit Solid(const std::vector<Vec3>& corners) {
    for (size_t i = 0; i + 2 < corners.size(); i += 3) {
      const Vec3 n = glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
      area += glm::length(n) / 2;
      volume += glm::dot(corners[i] - corners[0], n) / 6;
    }
  }
};

RC_GTEST_PROP(ItemProperty, TrianglesFacesAndEdgesAgree, (uint64_t seed)) {
  Random random(seed);
  const Polygon polygon = AnyPolygon(&random);
  std::vector<Ring> rings = {polygon.outer};
  rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  const auto lot = LotFrom(rings);
  RC_ASSERT(lot.has_value());
  RC_ASSERT(std::abs(AreaOf(*lot) - Area(polygon)) < 1e-6);
  const double height = random.Uniform(1, 9);
  const Item mass = Apply(Extrude(height), *lot)->front().item;
  RC_ASSERT(std::abs(VolumeOf(mass) - height * AreaOf(*lot)) < 1e-6);
  std::vector<Vec3> corners;
  TrianglesOf(mass, &corners);
  const Solid solid(corners);
  RC_ASSERT(std::abs(solid.volume - VolumeOf(mass)) < 1e-6);
  RC_ASSERT(std::abs(solid.area - AreaOf(mass)) < 1e-6);
  double faces = 0;
  for (const Item& face : FacesOf(mass)) {
    faces += AreaOf(face);
    // Upright faces stand on their x axis.
    if (std::abs(face.facing.y) < 0.5) RC_ASSERT(face.scope.y.y > 1 - 1e-9);
    RC_ASSERT(std::abs(glm::dot(glm::cross(face.scope.x, face.scope.y), face.facing) - 1) < 1e-9);
  }
  RC_ASSERT(std::abs(faces - AreaOf(mass)) < 1e-6);
  const Mesh mesh = MeshOf(mass);
  size_t directed = 0;
  for (const MeshFace& face : mesh.faces) {
    directed += face.loop.size();
    for (const auto& hole : face.holes) directed += hole.size();
  }
  RC_ASSERT(EdgesOf(mass).size() == directed / 2);
}

}  // namespace
}  // namespace parti::grammar::tests
