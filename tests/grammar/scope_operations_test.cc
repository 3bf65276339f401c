// alignScopeToAxes, alignScopeToGeometry, rotateScope, translate, rotate: what moves, and what only
// gets other axes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grammar/action_text.h"
#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"

namespace parti::grammar::tests {
namespace {

MATCHER_P(IsNear, v, "") { return glm::distance(arg, v) < 1e-9; }

Item After(const Action& action, const Item& item) { return Apply(action, item)->front().item; }
Action ToAxes(std::string axis) { return Make("alignScopeToAxes", {std::move(axis)}); }
Action ToGeometry(std::string face, std::string edge) {
  return Make("alignScopeToGeometry", {std::string("yUp"), std::move(face), std::move(edge)});
}
Action RotateScope(double x, double y, double z) { return Make("rotateScope", {x, y, z}); }
Action InWorld(const std::string& name, std::string mode, double x, double y, double z) {
  return Make(name, {std::move(mode), std::string("world"), x, y, z});
}

/// Everything that is seen of an item: its corners, in order.
std::vector<Vec3> Seen(const Item& item) {
  std::vector<Vec3> corners;
  for (const Segment3& edge : EdgesOf(item)) corners.push_back((edge.a + edge.b) * 0.5);
  std::sort(corners.begin(), corners.end(), [](const Vec3& a, const Vec3& b) {
    constexpr double kNear = 1e-6;
    for (int i = 0; i < 3; ++i) {
      if (std::abs(a[i] - b[i]) > kNear) return a[i] < b[i];
    }
    return false;
  });
  return corners;
}

void ExpectSamePlace(const Item& a, const Item& b) {
  const std::vector<Vec3> first = Seen(a), second = Seen(b);
  ASSERT_EQ(first.size(), second.size());
  for (size_t i = 0; i < first.size(); ++i) EXPECT_THAT(first[i], IsNear(second[i]));
}

const char* const kTurnedLot = "0,0 8,6 5,10 -3,4";

TEST(AlignScopeToAxes, GivesALotTheWorldsAxes) {
  const Item lot = Lot(kTurnedLot);
  const Item aligned = After(ToAxes("all"), lot);
  EXPECT_THAT(aligned.scope.x, IsNear(Vec3(1, 0, 0)));
  EXPECT_THAT(aligned.scope.z, IsNear(lot.scope.z));
  EXPECT_THAT(aligned.scope.size, IsNear(Vec3(11, 10, 0)));
  ExpectSamePlace(aligned, lot);
  EXPECT_THAT(After(ToAxes("y"), lot).scope.x, IsNear(lot.scope.x));
}

TEST(AlignScopeToAxes, GivesAWallAnUprightY) {
  const Item wall = *PlanarFrom({{Vec3(0, 0, 0), Vec3(0, 3, 0), Vec3(-4, 3, 0), Vec3(-4, 0, 0)}});
  const Item aligned = After(ToAxes("y"), wall);
  EXPECT_THAT(aligned.scope.y, IsNear(Vec3(0, 1, 0)));
  EXPECT_THAT(aligned.scope.size, IsNear(Vec3(4, 3, 0)));
  ExpectSamePlace(aligned, wall);
}

TEST(AlignScopeToAxes, BoxesTurnedOutOfTheirAxesBecomeMeshes) {
  const Item box = After(Extrude(3), Lot(kTurnedLot));
  const Item aligned = After(ToAxes("all"), box);
  EXPECT_THAT(aligned.scope.x, IsNear(Vec3(1, 0, 0)));
  EXPECT_THAT(aligned.scope.size, IsNear(Vec3(11, 3, 10)));
  EXPECT_NEAR(VolumeOf(aligned), VolumeOf(box), 1e-9);
  ExpectSamePlace(aligned, box);
}

TEST(AlignScopeToGeometry, PutsXAlongAnEdge) {
  const Item lot = Lot(kTurnedLot);
  EXPECT_THAT(After(ToGeometry("0", "1"), lot).scope.x, IsNear(glm::normalize(Vec3(-3, 0, -4))));
  EXPECT_THAT(After(ToGeometry("0", "-1"), lot).scope.x, IsNear(glm::normalize(Vec3(3, 0, 4))));
  EXPECT_THAT(After(ToGeometry("any", "longest"), lot).scope.x,
              IsNear(glm::normalize(Vec3(8, 0, -6))));
  EXPECT_THAT(After(ToGeometry("2", "none"), lot).scope.x, IsNear(glm::normalize(Vec3(-8, 0, 6))));
}

TEST(AlignScopeToGeometry, PutsAWallOnItsLowestEdge) {
  const Item gable = *PlanarFrom({{Vec3(4, 0, 0), Vec3(2, 3, 0), Vec3(0, 0, 0)}});
  const Item aligned = After(ToGeometry("any", "world.lowest"), gable);
  EXPECT_NEAR(std::abs(aligned.scope.x.x), 1, 1e-9);
  EXPECT_NEAR(aligned.scope.size.y, 3, 1e-9);
  ExpectSamePlace(aligned, gable);
}

TEST(AlignScopeToGeometry, WordsAndNumbersThatMeanNothingAreRefused) {
  EXPECT_FALSE(Apply(ToGeometry("0", "shortest"), Lot(kTurnedLot)).has_value());
  EXPECT_FALSE(Apply(ToGeometry("1.5", "0"), Lot(kTurnedLot)).has_value());
  EXPECT_TRUE(Apply(ToGeometry("99", "99"), Lot(kTurnedLot)).has_value());
}

TEST(RotateScope, TurnsAFlatShapesAxesInItsPlane) {
  const Item lot = Lot("0,0 8,0 8,5 0,5");
  const Item turned = After(RotateScope(0, 90, 0), lot);
  EXPECT_THAT(turned.scope.x, IsNear(Vec3(0, 0, -1)));
  EXPECT_THAT(turned.scope.size, IsNear(Vec3(5, 8, 0)));
  EXPECT_EQ(turned.polygon, nullptr);
  ExpectSamePlace(turned, lot);
}

TEST(RotateScope, MakesAnotherSideTheFront) {
  const Item box = After(Extrude(3), Lot("0,0 8,0 8,5 0,5"));
  const Item turned = After(RotateScope(0, 90, 0), box);
  EXPECT_THAT(turned.scope.z, IsNear(Vec3(1, 0, 0)));
  EXPECT_THAT(turned.scope.size, IsNear(Vec3(5, 3, 8)));
  EXPECT_EQ(turned.mesh, nullptr);
}

RC_GTEST_PROP(ScopeOperations, LeaveGeometryWhereItIs, ()) {
  Random random(*rc::gen::arbitrary<uint64_t>());
  const Item lot = *PlanarFrom({{Vec3(0, 0, 0), Vec3(random.Uniform(2, 9), 0, 0),
                                 Vec3(random.Uniform(2, 9), 0, random.Uniform(-9, -2)),
                                 Vec3(random.Uniform(-2, 1), 0, random.Uniform(-9, -2))}});
  const Item item = random.Uniform() < 0.5 ? lot : After(Extrude(2), lot);
  for (const Action& action :
       {ToAxes("all"), ToAxes("x"), ToAxes("y"), ToAxes("z"), ToGeometry("any", "longest"),
        ToGeometry("0", "2"), RotateScope(0, random.Uniform(-180, 180), 0)}) {
    const Item turned = After(action, item);
    RC_ASSERT(std::abs(AreaOf(turned) - AreaOf(item)) < 1e-6 * AreaOf(item));
    RC_ASSERT(Seen(turned).size() == Seen(item).size());
    RC_ASSERT(glm::distance(Seen(turned).front(), Seen(item).front()) < 1e-6);
  }
}

TEST(TranslateInWorld, GoesUpFromASlope) {
  const Item slope =
      *PlanarFrom({{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 3, -8), Vec3(0, 3, -8)}});
  EXPECT_THAT(After(InWorld("translate", "rel", 0, 2, 0), slope).scope.origin,
              IsNear(slope.scope.origin + Vec3(0, 2, 0)));
  EXPECT_THAT(Seen(After(InWorld("translate", "abs", 1, 2, 3), Lot("5,5 9,5 9,9 5,9")))[0],
              IsNear(Vec3(1, 2, 5)));
}

TEST(RotateInWorld, TurnsAboutTheWorldsAxes) {
  const Item box = After(Extrude(3), Lot(kTurnedLot));
  const Item turned = After(InWorld("rotate", "rel", 0, 90, 0), box);
  EXPECT_THAT(turned.scope.x, IsNear(Vec3(box.scope.x.z, 0, -box.scope.x.x)));
  EXPECT_THAT(turned.scope.origin, IsNear(box.scope.origin));
  EXPECT_THAT(After(InWorld("rotate", "abs", 0, 0, 0), box).scope.x, IsNear(Vec3(1, 0, 0)));
}

TEST(DeleteHoles, FillsPlanarShapesAndFacesOfVolumes) {
  const auto ring =
      Apply(*ParseAction("shapeO(1, 2, 1, 2) { shape: A }"), Lot("0,0 10,0 10,8 0,8"));
  ASSERT_TRUE(ring.has_value()) << FormatError(ring.error());
  const Item court = ring->front().item;
  EXPECT_NEAR(AreaOf(court), 80 - 6 * 6, 1e-9);
  const Item filled = After(Make("deleteHoles", {}), court);
  EXPECT_NEAR(AreaOf(filled), 80, 1e-9);
  EXPECT_EQ(filled.scope.size, court.scope.size);
  const Item block = Apply(Extrude(3), court)->front().item;
  const Item capped = After(Make("deleteHoles", {}), block);
  EXPECT_NEAR(AreaOf(capped), AreaOf(block) + 2 * 36, 1e-9) << "floor and roof of the court";
  EXPECT_FALSE(capped.mesh->closed) << "its walls stay inside";
  const Item box = Apply(Extrude(3), filled)->front().item;
  EXPECT_EQ(After(Make("deleteHoles", {}), box).mesh, box.mesh) << "nothing to fill";
}

}  // namespace
}  // namespace parti::grammar::tests
