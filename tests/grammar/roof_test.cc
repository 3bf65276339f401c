// The rows of roofs: what stands where, and which way its faces look.
#include "grammar/roof.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grammar/action_text.h"
#include "grammar/polygon_skeleton.h"
#include "tests/grammar/roof_checks.h"

namespace parti::grammar::tests {
namespace {

using Kind = Selector::Kind;
MATCHER_P(IsNear, v, "") { return glm::distance(arg, v) < 1e-6; }

Action Roof(std::string_view name, std::vector<Argument> arguments) {
  arguments.insert(arguments.begin(), std::string("byAngle"));
  return Make(name, std::move(arguments), {}, "Roof");
}
Action Hip(double angle, double overhang = 0) { return Roof("roofHip", {angle, overhang}); }
Action Gable(double angle, double x = 0, double y = 0) { return Roof("roofGable", {angle, x, y}); }

Item Over(const Item& lot, const Action& action) {
  const auto products = Apply(action, lot);
  EXPECT_TRUE(products.has_value()) << products.error().message;
  EXPECT_EQ(products->size(), 1u);
  return products->front().item;
}

/// Faces that the selector takes.
std::vector<Item> Faces(const Item& roof, Kind kind) {
  std::vector<Item> faces;
  const auto products = Apply(Comp({Selected(kind, "A")}), roof);
  for (const Product& p : *products) faces.push_back(p.item);
  return faces;
}

// CGAL alone never ends on this one, on any grid (docs/roofs.md, 4).
TEST(Roofs, EndWhereMuchMeetsAtOnce) {
  const Polygon court{{{18, 0},
                       {18, 3},
                       {15, 3},
                       {15, 1},
                       {12, 1},
                       {12, 3},
                       {7, 3},
                       {7, 8},
                       {5, 8},
                       {5, 6},
                       {3, 6},
                       {3, 1},
                       {0, 1},
                       {0, 0}},
                      {{{11, 1}, {8, 1}, {8, 2}, {11, 2}}}};
  for (const double scale : {1.0, 0.3, 2.5}) {
    Polygon polygon = court;
    for (Vec2& p : polygon.outer) p *= scale;
    for (Vec2& p : polygon.holes[0]) p *= scale;
    const auto hip = HipRoof(polygon, {false, 35}, 0);
    ASSERT_TRUE(hip.has_value()) << scale;
    EXPECT_EQ(WrongWithRoof(polygon, *hip), "") << scale;
    const auto gable = GableRoof(polygon, {false, 40}, {}, Vec2(0, -1));
    ASSERT_TRUE(gable.has_value()) << scale;
    EXPECT_EQ(WrongWithRoof(polygon, *gable), "") << scale;
    const double inward_m = 0.4 * scale;
    const auto inset = Offset(polygon, inward_m);
    ASSERT_TRUE(inset.has_value()) << scale;
    EXPECT_EQ(WrongWithInset(polygon, *inset, inward_m), "") << scale;
  }
}

TEST(RoofHip, OverARectangleHasFourPlanesAndABottom) {
  const Item lot = Lot("0,0 20,0 20,12 0,12");
  const Item roof = Over(lot, Hip(45));
  EXPECT_THAT(roof.scope.size, IsNear(Vec3(20, 6, 12)));
  EXPECT_EQ(roof.facing, lot.facing);
  EXPECT_EQ(roof.mesh->faces.size(), 5u);
  EXPECT_EQ(OpenEdges(*roof.mesh), 0);
  EXPECT_NEAR(VolumeOf(roof), 8.0 * 12 * 6 / 2 + 12.0 * 12 * 6 / 3, 1e-6);
  EXPECT_EQ(Faces(roof, Kind::kBottom).size(), 1u);
  EXPECT_EQ(Faces(roof, Kind::kTop).size(), 4u);  // 45 degrees look up
}

TEST(RoofHip, PlanesBeginAtTheirEaves) {
  const Item roof = Over(Lot("0,0 20,0 20,12 0,12"), Hip(30));
  const auto planes = Faces(roof, Kind::kTop);
  ASSERT_EQ(planes.size(), 4u);
  for (const Item& plane : planes) {
    EXPECT_NEAR(plane.scope.x.y, 0, 1e-9);
    EXPECT_GT(plane.scope.y.y, 0.4);  // up the roof
    EXPECT_NEAR(plane.scope.ToWorld(Vec3(0, 0, 0)).y, 0, 1e-9);
    EXPECT_GT(plane.facing.y, 0.8);
  }
}

TEST(RoofHip, ByHeightIsThatHigh) {
  const Item lot = Lot("0,0 20,0 20,12 8,12 8,20 0,20");
  const auto roof = Apply(Make("roofHip", {std::string("byHeight"), 4.0, 0.0}, {}, "Roof"), lot);
  ASSERT_TRUE(roof.has_value());
  EXPECT_NEAR(roof->front().item.scope.size.y, 4, 1e-6);
}

TEST(RoofHip, OverhangLetsThePlanesDown) {
  const Item lot = Lot("0,0 20,0 20,12 0,12");
  const Item roof = Over(lot, Hip(45, std::sqrt(2.0)));
  EXPECT_THAT(roof.scope.size, IsNear(Vec3(22, 7, 14)));
  EXPECT_NEAR(roof.scope.origin.y, -1, 1e-9);
  EXPECT_EQ(OpenEdges(*roof.mesh), 0);
}

TEST(RoofHip, KeepsCourtyards) {
  const auto polygon =
      PolygonFrom({RingFrom("0,0 30,0 30,30 0,30"), RingFrom("10,10 20,10 20,20 10,20")});
  const auto mesh = HipRoof(*polygon, {false, 45}, 0);
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(WrongWithRoof(*polygon, *mesh), "");
  EXPECT_EQ(mesh->faces.size(), 9u);
  EXPECT_EQ(mesh->faces[0].holes.size(), 1u);
}

TEST(RoofHip, CornersOnStraightWallsMakeNoFaces) {
  const Polygon polygon{RingFrom("0,0 5,0 10,0.00001 20,0 20,12 0,12 0,6"), {}};
  EXPECT_EQ(HipRoof(polygon, {false, 30}, 0)->faces.size(), 5u);
}

TEST(RoofHip, PlanesThatMeetAgainBehindABayAreOne) {
  const Polygon polygon{RingFrom("0,0 8,0 8,-1 12,-1 12,0 20,0 20,30 0,30"), {}};
  const auto mesh = HipRoof(polygon, {false, 30}, 0);
  EXPECT_EQ(WrongWithRoof(polygon, *mesh), "");
  EXPECT_EQ(mesh->faces.size(), 1u + 7u);  // two of the eight edges share a plane
}

TEST(RoofHip, RefusesAnglesThatAreNone) {
  const Item lot = Lot("0,0 20,0 20,12 0,12");
  for (const double angle : {0.0, 89.5, 90.0}) {
    const auto roof = Apply(Hip(angle), lot);
    ASSERT_FALSE(roof.has_value());
    EXPECT_EQ(roof.error().code, ErrorCode::kBadNumber);
    EXPECT_FALSE(roof.error().hint.empty());
  }
}

TEST(RoofGable, PutsTheEndsOfARectangleUpright) {
  const Item roof = Over(Lot("0,0 20,0 20,12 0,12"), Gable(45));
  EXPECT_THAT(roof.scope.size, IsNear(Vec3(20, 6, 12)));
  EXPECT_EQ(OpenEdges(*roof.mesh), 0);
  EXPECT_NEAR(VolumeOf(roof), 20 * 12 * 6 / 2.0, 1e-6);
  EXPECT_EQ(roof.mesh->points.size(), 6u);  // a ridge of two points
  const auto gables = Faces(roof, Kind::kVertical);
  ASSERT_EQ(gables.size(), 2u);
  for (const Item& gable : gables) {
    EXPECT_NEAR(gable.scope.size.x, 12, 1e-9);
    EXPECT_NEAR(gable.scope.size.y, 6, 1e-6);
  }
}

TEST(RoofGable, OfASquareHasItsEavesOnTheStreet) {
  for (const float street : {0.0F, 90.0F, 180.0F, 270.0F}) {
    Item lot = Lot("0,0 12,0 12,12 0,12");
    lot.street_deg = street;
    const Item roof = Over(lot, Gable(45));
    const auto gables = Faces(roof, Kind::kVertical);
    ASSERT_EQ(gables.size(), 2u);
    const Vec3 way(std::sin(street * kPi / 180), 0, -std::cos(street * kPi / 180));
    for (const Item& gable : gables) EXPECT_NEAR(glm::dot(gable.facing, way), 0, 1e-6);
  }
}

TEST(RoofGable, OverhangsEavesDownTheRoofAndGablesOutward) {
  const Item roof = Over(Lot("0,0 20,0 20,12 0,12"), Gable(45, std::sqrt(2.0), 0.5));
  EXPECT_THAT(roof.scope.size, IsNear(Vec3(21, 7, 14)));
  EXPECT_EQ(OpenEdges(*roof.mesh), 0);
  EXPECT_NEAR(VolumeOf(roof), 21 * 14 * 7 / 2.0, 1e-6);
}

TEST(RoofGable, OfAnLHasTwoGablesAndAValley) {
  const Polygon polygon{RingFrom("0,0 20,0 20,8 8,8 8,20 0,20"), {}};
  const auto mesh = GableRoof(polygon, {false, 45}, {}, Vec2(0, -1));
  EXPECT_EQ(WrongWithRoof(polygon, *mesh), "");
  int upright = 0;
  for (const MeshFace& face : mesh->faces) upright += std::abs(Normal(*mesh, face).z) < 1e-9;
  EXPECT_EQ(upright, 2);
}

TEST(RoofPyramid, MeetsOverTheCentroid) {
  const Item roof = Over(Lot("0,0 20,0 20,12 0,12"), Roof("roofPyramid", {45.0}));
  EXPECT_THAT(roof.scope.size, IsNear(Vec3(20, 6, 12)));  // 45 degrees over the front
  EXPECT_EQ(roof.mesh->points.size(), 5u);
  EXPECT_NEAR(VolumeOf(roof), 20 * 12 * 6 / 3.0, 1e-6);
}

TEST(RoofPyramid, OverAnLMeetsWhereAllEdgesAreSeen) {
  const Polygon polygon{RingFrom("0,0 20,0 20,8 8,8 8,20 0,20"), {}};
  const auto mesh = PyramidRoof(polygon, {true, 5}, 0);
  EXPECT_EQ(WrongWithRoof(polygon, *mesh), "");
  EXPECT_EQ(mesh->faces.size(), 7u);
}

TEST(RoofPyramid, OverAUIsAHipRoof) {
  const Polygon polygon{RingFrom("0,0 30,0 30,20 22,20 22,8 8,8 8,20 0,20"), {}};
  const auto mesh = PyramidRoof(polygon, {true, 5}, 0);
  EXPECT_EQ(WrongWithRoof(polygon, *mesh), "");
}

TEST(RoofShed, RisesFromTheFrontOrFromTheEdgeThatIsNamed) {
  const Item lot = Lot("0,0 20,0 20,12 0,12");
  const Item roof = Over(lot, Roof("roofShed", {45.0, -1.0}));
  EXPECT_THAT(roof.scope.size, IsNear(Vec3(20, 12, 12)));
  EXPECT_EQ(roof.mesh->faces.size(), 5u);
  EXPECT_EQ(OpenEdges(*roof.mesh), 0);
  EXPECT_NEAR(VolumeOf(roof), 20 * 12 * 12 / 2.0, 1e-6);
  EXPECT_GT(Faces(roof, Kind::kTop).at(0).facing.z, 0.7);  // looks south, to the street
  EXPECT_THAT(Over(lot, Roof("roofShed", {45.0, 1.0})).scope.size, IsNear(Vec3(20, 20, 12)));
}

TEST(RoofShed, OfAnyOutlineIsClosedAndOnTheGround) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    const Polygon polygon = AnyPolygon(&random);
    const auto mesh = ShedRoof(polygon, {false, 20}, seed % polygon.outer.size());
    ASSERT_TRUE(mesh.has_value());
    EXPECT_EQ(OpenEdges(*mesh), 0) << seed;
    EXPECT_NEAR(ProjectedArea(*mesh, mesh->faces[1]), Area(polygon), 1e-6) << seed;
    for (const Vec3& p : mesh->points) EXPECT_GE(p.z, 0);
  }
}

TEST(TaperRow, IsAPyramidOrOneCutOff) {
  const Item lot = Lot("0,0 20,0 20,12 0,12");
  EXPECT_NEAR(VolumeOf(Over(lot, Make("taper", {6.0, 0.0}, {}, "A"))), 20 * 12 * 6 / 3.0, 1e-6);
  const Item cut = Over(lot, Make("taper", {6.0, 0.5}, {}, "A"));
  EXPECT_EQ(cut.mesh->faces.size(), 6u);
  EXPECT_NEAR(VolumeOf(cut), 20 * 12 * 12 / 3.0 * 7 / 8, 1e-6);
}

TEST(TaperRow, GoesDownwardWithItsFacesOutward) {
  const Item pit = Over(Lot("0,0 20,0 20,12 0,12"), Make("taper", {-6.0, 0.5}, {}, "A"));
  EXPECT_NEAR(pit.scope.origin.y, -6, 1e-9);
  EXPECT_GT(VolumeOf(pit), 0);
  EXPECT_EQ(OpenEdges(*pit.mesh), 0);
}

TEST(TaperRow, OfAUIsCutWhereItsHeightIs) {
  const Polygon polygon{RingFrom("0,0 30,0 30,20 22,20 22,8 8,8 8,20 0,20"), {}};
  const auto mesh = Taper(polygon, 3, 0.5);
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(OpenEdges(*mesh), 0);
  double highest = 0;
  for (const Vec3& p : mesh->points) highest = std::max(highest, p.z);
  EXPECT_NEAR(highest, 3, 1e-9);
}

TEST(Roofs, KeepColorAndStreet) {
  Item lot = Lot("0,0 20,0 20,12 0,12");
  lot.color_rgb = 0xad7859;
  lot.street_deg = 90.0F;
  for (const Action& action :
       {Hip(30), Gable(30), Roof("roofPyramid", {30.0}), Roof("roofShed", {30.0, -1.0}),
        Make("taper", {3.0, 0.0}, {}, "A")}) {
    const Item roof = Over(lot, action);
    EXPECT_EQ(roof.color_rgb, lot.color_rgb);
    EXPECT_EQ(roof.street_deg, lot.street_deg);
    EXPECT_EQ(roof.type, ItemType::kVolume);
  }
}

TEST(Roofs, PropertyTurningTheOutlineTurnsTheRoof) {
  for (uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const Polygon polygon = StarPolygon(&random);
    Polygon turned = polygon;
    const auto turn = [](Vec2& p) { p = Vec2(0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y) * 1.0; };
    std::for_each(turned.outer.begin(), turned.outer.end(), turn);
    for (Ring& hole : turned.holes) std::for_each(hole.begin(), hole.end(), turn);
    const auto roof = HipRoof(polygon, {false, 30}, 0), same = HipRoof(turned, {false, 30}, 0);
    ASSERT_TRUE(roof && same);
    EXPECT_NEAR(Volume(*roof), Volume(*same), 1e-4 * Volume(*roof)) << seed;
  }
}

TEST(Roofs, OptionalArgumentsMayBeLeftOut) {
  EXPECT_EQ(ParseAction("roofHip(30)")->arguments.size(), 3u);
  EXPECT_EQ(TextOf(*ParseAction("roofHip(byAngle, 30, 0) Roof")), "roofHip(30) Roof");
  EXPECT_EQ(TextOf(*ParseAction("roofHip(byHeight, 4)")), "roofHip(byHeight, 4)");
  EXPECT_EQ(TextOf(*ParseAction("roofGable(30, 0.5)")), "roofGable(30, 0.5)");
  EXPECT_FALSE(ParseAction("roofHip()").has_value());
  EXPECT_FALSE(ParseAction("roofHip(byWidth, 4)").has_value());
}

}  // namespace
}  // namespace parti::grammar::tests
