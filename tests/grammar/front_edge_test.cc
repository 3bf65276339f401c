// The front of a shape: the street's side, else the longest; never the first edge as such.
#include "grammar/front_edge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"

namespace parti::grammar::tests {
namespace {

MATCHER_P(IsNear, v, "") { return glm::distance(arg, v) < 1e-6; }
const Vec3 kSouth(0, 0, 1), kNorth(0, 0, -1), kEast(1, 0, 0), kWest(-1, 0, 0), kUp(0, 1, 0);

Ring Rotated(Ring ring, size_t by) {
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(by), ring.end());
  return ring;
}

TEST(FrontOf, IsTheLongestSideWhereverTheOutlineBegins) {
  const Ring ring = RingFrom("0,0 10,0 10,30 0,30 0,20 -5,20 -5,10 0,10");
  for (size_t i = 0; i < ring.size(); ++i) {
    EXPECT_THAT(FrontOf(LotFrom({Rotated(ring, i)}).value()), IsNear(kEast)) << i;
  }
}

TEST(FrontOf, OfTwoAsLongSidesIsTheSouthern) {
  const Ring ring = RingFrom("0,0 20,0 20,14 0,14");
  for (size_t i = 0; i < 4; ++i) {
    const Item lot = LotFrom({Rotated(ring, i)}).value();
    EXPECT_THAT(FrontOf(lot), IsNear(kSouth)) << i;
    const Item mass = Apply(Extrude(9), lot)->front().item;
    EXPECT_THAT(FrontOf(mass), IsNear(kSouth)) << i;
  }
}

TEST(FrontOf, ASideIsLongInAllItsPieces) {
  // The north side is a run of short edges that waver by 5 cm.
  Ring ring = RingFrom("0,0 0,-9 14,-9 14,-2 20,-2 20,0");
  for (int i = 9; i > 0; --i) ring.emplace_back(2 * i, i % 2 == 0 ? 0.05 : -0.05);
  EXPECT_THAT(FrontOf(LotFrom({ring}).value()), IsNear(kNorth));
}

TEST(FrontOf, PropertyDoesNotDependOnTheFirstCorner) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Polygon polygon = AnyPolygon(&random);
    std::vector<Ring> rings = polygon.holes;
    rings.insert(rings.begin(), polygon.outer);
    const Item lot = LotFrom(rings).value();
    rings[0] = Rotated(rings[0], seed % rings[0].size());
    const Item same = LotFrom(rings).value();
    EXPECT_THAT(FrontOf(same), IsNear(FrontOf(lot))) << seed;
    const Vec2 a = PolygonOf(lot).outer[FrontEdge(lot)];
    const Vec2 b = PolygonOf(same).outer[FrontEdge(same)];
    EXPECT_THAT(lot.scope.ToWorld(Vec3(a, 0)), IsNear(same.scope.ToWorld(Vec3(b, 0)))) << seed;
  }
}

TEST(FrontOf, AStreetComesFirstAndIsInherited) {
  Item lot = Lot("0,0 20,0 20,14 0,14");
  lot.street_deg = 80.0F;
  EXPECT_GT(glm::dot(FrontOf(lot), kEast), 0.98);
  EXPECT_EQ(FrontEdge(lot), 1u);
  const Item mass = Apply(Extrude(9), lot)->front().item;
  EXPECT_EQ(mass.street_deg, lot.street_deg);
  EXPECT_GT(glm::dot(FrontOf(mass), kEast), 0.98);
  const auto parts = Apply(Split(Axis::kX, {Metres(5, "A"), Floating(1, "B")}), lot);
  EXPECT_EQ(parts->at(1).item.street_deg, lot.street_deg);
  for (const Item& face : FacesOf(mass)) EXPECT_EQ(face.street_deg, lot.street_deg);
}

TEST(FrontEdge, OfSeveralThatLookThereIsTheLongest) {
  const Item lot = Lot("0,0 4,0 4,1 16,1 16,0 20,0 20,30 0,30");
  EXPECT_THAT(FrontOf(lot), IsNear(kEast));
  Item facing_south = lot;
  facing_south.street_deg = 180.0F;
  EXPECT_EQ(FrontEdge(facing_south), 2u);
}

TEST(StreetSideOf, TurnsFromTheFrontToTheRight) {
  EXPECT_EQ(StreetSideOf(kSouth, kUp, kSouth), StreetSide::kFront);
  EXPECT_EQ(StreetSideOf(kSouth, kUp, kEast), StreetSide::kRight);
  EXPECT_EQ(StreetSideOf(kSouth, kUp, kNorth), StreetSide::kBack);
  EXPECT_EQ(StreetSideOf(kSouth, kUp, kWest), StreetSide::kLeft);
  EXPECT_EQ(StreetSideOf(kSouth, kUp, glm::normalize(kSouth + kEast)), StreetSide::kRight);
  EXPECT_EQ(StreetSideOf(kSouth, kUp, glm::normalize(kSouth + kWest)), StreetSide::kFront);
}

}  // namespace
}  // namespace parti::grammar::tests
