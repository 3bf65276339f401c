// extrude and comp: volumes that stand, and their faces by direction.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

using Kind = Selector::Kind;
MATCHER_P(IsNear, v, "") { return glm::distance(arg, v) < 1e-9; }

Item MassOn(const std::string& outline, double height) {
  return Apply(Extrude(height), Lot(outline))->front().item;
}

/// The face that a lone selector picks; there must be one.
Item FaceOf(const Item& mass, Kind kind, int index = 0) {
  const auto faces = Apply(Comp({Selected(kind, "F", index)}), mass);
  EXPECT_TRUE(faces && faces->size() == 1u);
  return faces->front().item;
}

TEST(Extrude, AFlatLotBecomesAStandingBox) {
  const Item mass = MassOn("0,0 10,0 10,8 0,8", 6);
  EXPECT_EQ(mass.type, ItemType::kVolume);
  EXPECT_EQ(mass.mesh, nullptr);
  EXPECT_THAT(mass.scope.x, IsNear(Vec3(1, 0, 0)));
  EXPECT_THAT(mass.scope.y, IsNear(Vec3(0, 1, 0)));
  EXPECT_THAT(mass.scope.z, IsNear(Vec3(0, 0, 1)));
  EXPECT_THAT(mass.scope.size, IsNear(Vec3(10, 6, 8)));
  EXPECT_THAT(mass.scope.origin, IsNear(Vec3(0, 0, -8)));
  EXPECT_THAT(mass.facing, IsNear(Vec3(0, 1, 0)));
}

/// A slope that rises 3 m over 8 m to the north, 10 m wide.
Item Slope() {
  return *PlanarFrom({{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 3, -8), Vec3(0, 3, -8)}});
}

Action Along(std::string direction, double distance) {
  return Make("extrudeAlong", {std::move(direction), distance});
}

TEST(ExtrudeAlong, UpASlopeStandsUprightAndKeepsItsSlope) {
  const Item mass = Apply(Along("world.up", 4), Slope())->front().item;
  EXPECT_NEAR(VolumeOf(mass), 10 * 8 * 4, 1e-9);
  EXPECT_THAT(mass.scope.y, IsNear(Vec3(0, 1, 0)));
  EXPECT_THAT(mass.scope.size, IsNear(Vec3(10, 7, 8)));
  const Item below = Apply(Along("world.up", -4), Slope())->front().item;
  EXPECT_NEAR(VolumeOf(below), 10 * 8 * 4, 1e-9);
  EXPECT_NEAR(below.scope.origin.y, -4, 1e-9);
}

TEST(ExtrudeAlong, AFlatTopIsLevelWithTheHighestCorner) {
  const Item mass = Apply(Along("world.up.flatTop", 1), Slope())->front().item;
  EXPECT_NEAR(mass.scope.size.y, 4, 1e-9);
  EXPECT_NEAR(VolumeOf(mass), 10 * 8 * (1 + 1.5), 1e-9);
  EXPECT_THAT(FaceOf(mass, Kind::kTop).facing, IsNear(Vec3(0, 1, 0)));
}

TEST(ExtrudeAlong, OnTheLevelItIsExtrude) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  EXPECT_EQ(Apply(Along("world.up", 3), lot)->front().item.mesh, nullptr);
  EXPECT_THAT(Apply(Along("face.normal", 3), Slope())->front().item.facing, IsNear(Slope().facing));
}

TEST(ExtrudeAlong, UprightShapesAndNoDistanceAreRefused) {
  const Item wall = *PlanarFrom({{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(4, 3, 0), Vec3(0, 3, 0)}});
  EXPECT_EQ(Apply(Along("world.up", 3), wall).error().code, ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(Apply(Along("world.up", 0), Slope()).error().code, ErrorCode::kDegenerateGeometry);
}

TEST(Extrude, NegativeGoesInward) {
  const Item cellar = MassOn("0,0 10,0 10,8 0,8", -3);
  EXPECT_THAT(cellar.scope.y, IsNear(Vec3(0, 1, 0)));
  EXPECT_THAT(cellar.scope.origin, IsNear(Vec3(0, -3, -8)));
  EXPECT_THAT(cellar.scope.size, IsNear(Vec3(10, 3, 8)));
  const Item ell = MassOn("0,0 10,0 10,8 5,8 5,4 0,4", -3);
  EXPECT_NEAR(VolumeOf(ell), 180, 1e-9);
  EXPECT_NEAR(ell.scope.origin.y, -3, 1e-9);
}

TEST(Extrude, AFacadeKeepsItsAxes) {
  const Item facade = FaceOf(MassOn("0,0 10,0 10,8 0,8", 6), Kind::kFront);
  const Item bay = Apply(Extrude(1.5), facade)->front().item;
  EXPECT_THAT(bay.scope.x, IsNear(facade.scope.x));
  EXPECT_THAT(bay.scope.y, IsNear(Vec3(0, 1, 0)));
  EXPECT_THAT(bay.scope.z, IsNear(facade.scope.z));
  EXPECT_THAT(bay.scope.size, IsNear(Vec3(10, 6, 1.5)));
  EXPECT_THAT(bay.facing, IsNear(facade.facing));
  const Item niche = Apply(Extrude(-1.5), facade)->front().item;
  EXPECT_THAT(niche.scope.origin, IsNear(facade.scope.origin - facade.scope.z * 1.5));
}

TEST(Extrude, InwardFromAFacadeIsANicheThatIsOpenToTheStreet) {
  const Item facade = FaceOf(MassOn("0,0 10,0 10,8 0,8", 6), Kind::kFront);
  const Item niche = Apply(Extrude(-1.5), facade)->front().item;
  const auto faces = FacesOf(niche);
  ASSERT_EQ(faces.size(), 5u);
  for (const Item& face : faces) {
    const Vec3 inside = niche.scope.ToWorld(niche.scope.size * 0.5);
    EXPECT_GT(glm::dot(face.facing, inside - face.scope.origin), 0) << "it looks inward";
    EXPECT_THAT(glm::cross(face.scope.z, face.scope.x), IsNear(face.scope.y));
  }
  const Item back = FaceOf(niche, Kind::kFront);
  EXPECT_THAT(back.facing, IsNear(facade.facing));
  EXPECT_THAT(back.scope.origin + back.scope.z * 1.5 - facade.scope.origin, IsNear(Vec3(0, 0, 0)));
  EXPECT_NEAR(AreaOf(niche), 10 * 6 + 2 * 1.5 * (10 + 6), 1e-9);
  EXPECT_NEAR(VolumeOf(niche), 90, 1e-9);
}

TEST(Extrude, ANicheOfAnyOutlineLosesItsMouthAndNothingElse) {
  const auto court = LotFrom({RingFrom("0,0 20,0 20,20 0,20"), RingFrom("8,8 12,8 12,12 8,12")});
  const Item moat = Apply(Extrude(-2), *court)->front().item;
  EXPECT_NEAR(AreaOf(moat), 400 - 16 + 2 * (80 + 16), 1e-6);
  const Item floor = FaceOf(moat, Kind::kTop);
  EXPECT_NEAR(AreaOf(floor), 384, 1e-6);
  EXPECT_NEAR(floor.scope.origin.y, -2, 1e-9);
  std::vector<Vec3> corners;
  TrianglesOf(moat, &corners);
  double area = 0;
  for (size_t i = 0; i < corners.size(); i += 3) {
    const Vec3 n = glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
    EXPECT_GT(n.y, -1e-9) << "nothing looks down";
    area += glm::length(n) / 2;
  }
  EXPECT_NEAR(area, AreaOf(moat), 1e-6);
}

TEST(Extrude, AnUprightShapeOnItsSideStandsUpToo) {
  // The first edge runs upward: it can't stay x.
  const auto sign = PlanarFrom({{Vec3(0, 0, 0), Vec3(0, 4, 0), Vec3(-3, 4, 0), Vec3(-3, 0, 0)}});
  const Item slab = Apply(Extrude(1), *sign)->front().item;
  EXPECT_THAT(slab.scope.y, IsNear(Vec3(0, 1, 0)));
  EXPECT_THAT(slab.scope.z, IsNear(Vec3(0, 0, 1)));
  EXPECT_THAT(slab.scope.size, IsNear(Vec3(3, 4, 1)));
  EXPECT_THAT(glm::cross(slab.scope.x, slab.scope.y), IsNear(slab.scope.z));
}

TEST(Extrude, PolygonsWithHolesBecomeClosedVolumes) {
  const auto court = LotFrom({RingFrom("0,0 20,0 20,20 0,20"), RingFrom("8,8 12,8 12,12 8,12")});
  const Item mass = Apply(Extrude(6), *court)->front().item;
  EXPECT_NEAR(VolumeOf(mass), 6 * (400 - 16), 1e-9);
  EXPECT_EQ(OpenEdges(MeshOf(mass)), 0);
  EXPECT_EQ(Apply(AllFaces(), mass)->size(), 10u);
  const auto roof = Apply(Comp({Selected(Kind::kTop, "Roof")}), mass);
  ASSERT_EQ(roof->size(), 1u);
  EXPECT_EQ(roof->front().item.polygon->holes.size(), 1u);
}

TEST(Extrude, ByZeroIsRefused) {
  EXPECT_EQ(Apply(Extrude(0), Lot("0,0 10,0 10,8 0,8")).error().code,
            ErrorCode::kDegenerateGeometry);
}

TEST(Comp, FrontIsTheFirstEdge) {
  for (const std::string outline : {"0,0 10,0 10,8 0,8", "0,0 10,0 10,8 5,8 5,4 0,4"}) {
    const Item mass = MassOn(outline, 6);
    const Item front = FaceOf(mass, Kind::kFront);
    EXPECT_THAT(front.facing, IsNear(Vec3(0, 0, 1)));
    EXPECT_THAT(front.scope.origin, IsNear(Vec3(0, 0, 0)));
    EXPECT_THAT(front.scope.x, IsNear(Vec3(1, 0, 0)));
    EXPECT_THAT(front.scope.size, IsNear(Vec3(10, 6, 0)));
    EXPECT_THAT(FaceOf(mass, Kind::kRight).facing, IsNear(Vec3(1, 0, 0)));
    EXPECT_THAT(FaceOf(mass, Kind::kBottom).facing, IsNear(Vec3(0, -1, 0)));
    const Item top = FaceOf(mass, Kind::kTop);
    EXPECT_THAT(top.facing, IsNear(Vec3(0, 1, 0)));
    EXPECT_THAT(top.scope.x, IsNear(Vec3(1, 0, 0)));
    EXPECT_NEAR(top.scope.origin.y, 6, 1e-12);
  }
}

TEST(Comp, EachFaceGoesToTheFirstSelectorThatFits) {
  const Item mass = MassOn("0,0 10,0 10,8 0,8", 6);
  const auto symbols = [&](std::vector<Successor> successors) {
    const Action action = Comp(std::move(successors));
    std::string text;
    const auto products = Apply(action, mass);
    for (const Product& p : *products) {
      text += SuccessorAt(action, p.successor).symbol;
    }
    return text;
  };
  EXPECT_EQ(symbols({Selected(Kind::kSide, "S"), Selected(Kind::kTop, "T")}), "TSSSS");
  EXPECT_EQ(symbols({Selected(Kind::kFront, "F"), Selected(Kind::kSide, "S")}), "FSSS");
  EXPECT_EQ(symbols({Selected(Kind::kSide, "S"), Selected(Kind::kFront, "F")}), "SSSS");
  EXPECT_EQ(symbols({Selected(Kind::kTop, "NIL"), Selected(Kind::kAll, "A")}), "AAAAA");
  EXPECT_EQ(symbols({Selected(Kind::kHorizontal, "H"), Selected(Kind::kVertical, "V")}), "HHVVVV");
  EXPECT_EQ(symbols({Selected(Kind::kLeft, "L"), Selected(Kind::kBack, "B"),
                     Selected(Kind::kRight, "R"), Selected(Kind::kBottom, "D")}),
            "DRBL");
  EXPECT_EQ(symbols({Selected(Kind::kIndex, "I", 1), Selected(Kind::kIndex, "J", 99)}), "I");
}

TEST(Comp, ADiagonalFaceHasOneSide) {
  // Faces at exactly 45 deg: each is in one quadrant, whatever rounding says.
  const Item mass = MassOn("0,0 10,0 14,4 14,14 10,18 0,18 -4,14 -4,4", 6);
  int count = 0;
  for (const Kind kind : {Kind::kFront, Kind::kRight, Kind::kBack, Kind::kLeft}) {
    const auto faces = Apply(Comp({Selected(kind, "F")}), mass);
    EXPECT_EQ(faces->size(), 2u) << NameOf(kind);
    count += static_cast<int>(faces->size());
  }
  EXPECT_EQ(count, 8);
}

TEST(Comp, FacesOfACutVolumeStandOnTheirBottom) {
  const Item mass = MassOn("0,0 10,0 10,8 5,8 5,4 0,4", 6);
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    const auto parts =
        Apply(Split(axis, {Metres(2, "A"), Metres(2.5, "B"), Floating(1, "C")}), mass);
    for (const Product& part : *parts) {
      for (const Item& face : FacesOf(part.item)) {
        const bool upright = std::abs(face.facing.y) < 0.5;
        EXPECT_THAT(upright ? face.scope.y : glm::abs(face.facing), IsNear(Vec3(0, 1, 0)));
      }
    }
  }
}

TEST(Color, IsInherited) {
  const Item lot = Lot("0,0 10,0 10,8 5,8 5,4 0,4");
  const Item red = Apply(Make("color", {std::string("#Ff0001")}), lot)->front().item;
  EXPECT_EQ(red.color_rgb, 0xff0001u);
  const Item mass = Apply(Extrude(6), red)->front().item;
  EXPECT_EQ(mass.color_rgb, 0xff0001u);
  EXPECT_EQ(FaceOf(mass, Kind::kFront).color_rgb, 0xff0001u);
  EXPECT_EQ(Apply(OffsetBy(-1), red)->front().item.color_rgb, 0xff0001u);
  EXPECT_EQ(Apply(Split(Axis::kX, {Metres(1, "A")}), red)->front().item.color_rgb, 0xff0001u);
  EXPECT_NE(Apply(Make("color", {std::string("#000000")}), lot)->front().item.color_rgb, 0u);
}

TEST(TagAndSymbol, LeaveTheItemAsItIs) {
  const Item lot = Lot("0,0 10,0 10,8 5,8 5,4 0,4");
  for (const char* name : {"tag", "symbol"}) {
    const auto products = Apply(Make(name, {std::string("x")}), lot);
    ASSERT_TRUE(products && products->size() == 1u);
    EXPECT_EQ(products->front().item.polygon, lot.polygon);
    EXPECT_EQ(products->front().successor, -1);
  }
}

}  // namespace
}  // namespace parti::grammar::tests
