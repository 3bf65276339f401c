// setback, shapeL, shapeU and shapeO: what edges sweep, and what is left.
#include <gtest/gtest.h>

#include "grammar/action_text.h"
#include "grammar/polygon_setback.h"
#include "grammar/polygon_skeleton.h"
#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"
#include "tests/grammar/roof_shapes.h"

namespace parti::grammar::tests {
namespace {

Result<std::vector<Product>> Apply(const std::string& text, const Item& item) {
  return grammar::Apply(ParseAction(text).value(), item);
}

double SumOf(const std::vector<Product>& products, int successor) {
  double sum = 0;
  for (const Product& p : products) sum += p.successor == successor ? AreaOf(p.item) : 0;
  return sum;
}

double SumOf(const std::vector<Polygon>& pieces) {
  double sum = 0;
  for (const Polygon& piece : pieces) sum += Area(piece);
  return sum;
}

std::vector<EdgeSetback> AllBy(const Polygon& polygon, double distance) {
  size_t count = polygon.outer.size();
  for (const Ring& hole : polygon.holes) count += hole.size();
  return std::vector<EdgeSetback>(count, {distance, 0});
}

TEST(SetbackRow, TakesAStripAlongTheFront) {
  const Item lot = Lot("0,0 20,0 20,14 0,14");
  const auto parts = Apply("setback(4) { front: Garden | remainder: House }", lot);
  ASSERT_TRUE(parts.has_value()) << parts.error().message;
  ASSERT_EQ(parts->size(), 2u);
  EXPECT_NEAR(AreaOf(parts->at(0).item), 80, 1e-6);
  EXPECT_NEAR(AreaOf(parts->at(1).item), 200, 1e-6);
  EXPECT_EQ(parts->at(0).item.polygon, nullptr);  // rectangles both
  EXPECT_EQ(parts->at(1).item.polygon, nullptr);
  EXPECT_GT(parts->at(0).item.scope.ToWorld(Vec3(0, 0, 0)).z, -4.001);  // the south
}

TEST(SetbackRow, FrontIsTheStreetWhereverTheOutlineBegins) {
  for (const float street : {0.0F, 90.0F, 180.0F, 270.0F}) {
    Item lot = Lot("0,0 20,0 20,14 0,14");
    lot.street_deg = street;
    const auto parts =
        Apply("setback(1) { street.front: A | street.side: B | street.back: C }", lot);
    ASSERT_TRUE(parts.has_value());
    const bool along_x = street == 0.0F || street == 180.0F;
    EXPECT_NEAR(SumOf(*parts, 0), (along_x ? 20 : 14) - 1, 1e-6) << street;
    EXPECT_NEAR(SumOf(*parts, 1), along_x ? 2 * 13 : 2 * 19, 1e-6) << street;
  }
}

TEST(SetbackRow, OfAllEdgesIsARing) {
  const auto parts = Apply("setback(2) { all: A | remainder: B }", Lot("0,0 20,0 20,14 0,14"));
  ASSERT_EQ(parts->size(), 2u);
  EXPECT_EQ(parts->at(0).item.polygon->holes.size(), 1u);
  EXPECT_NEAR(AreaOf(parts->at(1).item), 16 * 10, 1e-6);
}

TEST(SetbackRow, TheFirstSelectorThatTakesAnEdgeHasIt) {
  const Item lot = Lot("0,0 20,0 20,14 0,14");
  const auto parts = Apply("setback(2) { front: NIL | all: A | remainder: B }", lot);
  EXPECT_NEAR(SumOf(*parts, 1), 2 * (10 + 10 + 16) + 3 * 4, 1e-6);  // mitres at the front
  EXPECT_NEAR(SumOf(*parts, 2), 16 * 10, 1e-6);
  EXPECT_NEAR(SumOf(*parts, 0), 0, 0);
  const auto one = Apply("setback(2) { 1: A | remainder: B }", lot);
  EXPECT_NEAR(SumOf(*one, 0), 28, 1e-6);
}

TEST(SetbackRow, OfMoreThanThereIsLeavesNothing) {
  const auto parts = Apply("setback(50) { front: A | remainder: B }", Lot("0,0 20,0 20,14 0,14"));
  ASSERT_EQ(parts->size(), 1u);
  EXPECT_NEAR(SumOf(*parts, 0), 280, 1e-6);
}

TEST(SetbackRow, ByNothingIsAllRemainder) {
  const auto parts = Apply("setback(0) { front: A | remainder: B }", Lot("0,0 20,0 20,14 0,14"));
  ASSERT_EQ(parts->size(), 1u);
  EXPECT_EQ(parts->front().successor, 1);
}

TEST(SetbackRow, OnAWallTopAndBottomAreSelected) {
  const Item mass = grammar::Apply(Extrude(9), Lot("0,0 20,0 20,14 0,14"))->front().item;
  const Item wall =
      grammar::Apply(Comp({Selected(Selector::Kind::kFront, "F")}), mass)->front().item;
  const auto parts = Apply("setback(1) { bottom: A | top: B | left: C | remainder: D }", wall);
  ASSERT_TRUE(parts.has_value());
  EXPECT_NEAR(SumOf(*parts, 0), 19.5, 1e-6);
  EXPECT_NEAR(SumOf(*parts, 1), 19.5, 1e-6);
  EXPECT_NEAR(SumOf(*parts, 2), 8, 1e-6);
  EXPECT_NEAR(SumOf(*parts, 3), 19 * 7, 1e-6);
}

TEST(Setback, GoesAlongWhatStaysAtInnerAndOuterCorners) {
  const Polygon l{RingFrom("0,0 20,0 20,8 8,8 8,20 0,20"), {}};
  std::vector<EdgeSetback> edges = AllBy(l, 0);
  edges[2].distance_m = 3;  // the inner edge from (20, 8) to (8, 8)
  const auto parts = Setback(l, edges);
  ASSERT_TRUE(parts.has_value());
  EXPECT_NEAR(SumOf(parts->strips[0]), 12 * 3, 1e-6);
  edges = AllBy(l, 0);
  edges[0].distance_m = 3;
  EXPECT_NEAR(SumOf(Setback(l, edges)->strips[0]), 20 * 3, 1e-6);
}

TEST(Shapes, AreWingsAlongTheSides) {
  const Item lot = Lot("0,0 30,0 30,20 0,20");
  const auto l = Apply("shapeL(6, 5) { shape: A | remainder: B }", lot);
  ASSERT_EQ(l->size(), 2u);
  EXPECT_NEAR(SumOf(*l, 0), 30 * 6 + 14 * 5, 1e-6);
  EXPECT_NEAR(SumOf(*l, 1), 25 * 14, 1e-6);
  EXPECT_NEAR(l->at(1).item.scope.ToWorld(Vec3(0, 0, 0)).x, 5, 1e-6);  // left is west here
  const auto u = Apply("shapeU(6, 4, 5) { shape: A | remainder: B }", lot);
  EXPECT_NEAR(SumOf(*u, 1), 21 * 14, 1e-6);
  EXPECT_NEAR(u->at(1).item.scope.ToWorld(Vec3(0, 0, 0)).x, 5, 1e-6);
  const auto o = Apply("shapeO(6, 4, 3, 5) { remainder: B | shape: A }", lot);
  EXPECT_NEAR(SumOf(*o, 0), 21 * 11, 1e-6);
  EXPECT_EQ(o->at(0).item.polygon->holes.size(), 1u);
}

TEST(SetbackProperty, PartsMakeUpTheWhole) {
  for (uint64_t seed = 0; seed < 150; ++seed) {
    Random random(seed);
    const Polygon polygon = AnyPolygon(&random);
    std::vector<EdgeSetback> edges = AllBy(polygon, 0);
    for (EdgeSetback& edge : edges) {
      if (random.Uniform() < 0.5) continue;
      edge = {random.Uniform(0, 3), static_cast<int>(random.Uniform(0, 3))};
    }
    const auto parts = Setback(polygon, edges);
    ASSERT_TRUE(parts.has_value()) << seed;
    double sum = SumOf(parts->remainder);
    for (const auto& strip : parts->strips) sum += SumOf(strip);
    EXPECT_NEAR(sum, Area(polygon), 1e-6 * (1 + Area(polygon))) << seed;
  }
}

TEST(SetbackProperty, AllEdgesLeaveWhatOffsetLeaves) {
  for (uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    for (const Polygon& polygon : {Polygon{RandomTangle(24, &random), {}}, AnyPolygon(&random)}) {
      std::vector<EdgeSetback> edges = AllBy(polygon, 1);
      for (EdgeSetback& edge : edges) edge.strip = static_cast<int>(random.Uniform(-1, 3));
      const auto parts = Setback(polygon, edges);
      const auto inside = Offset(polygon, 1);
      ASSERT_TRUE(inside.has_value()) << seed;
      ASSERT_TRUE(parts.has_value()) << seed << parts.error().message;
      EXPECT_NEAR(SumOf(parts->remainder), SumOf(*inside), 1e-6) << seed;
      double sum = SumOf(parts->remainder);
      for (const auto& strip : parts->strips) sum += SumOf(strip);
      EXPECT_LE(sum, Area(polygon) * (1 + 1e-6)) << seed;
    }
  }
}

}  // namespace
}  // namespace parti::grammar::tests
