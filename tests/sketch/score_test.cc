#include "sketch/score.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace parti::sketch {
namespace {

TEST(Score, Equation6_12_IsOneAtThePointAndOneOverEAtTheRadius) {
  EXPECT_DOUBLE_EQ(EndFitness({3, 4}, {3, 4}, 20), 1);
  EXPECT_NEAR(EndFitness({0, 0}, {12, 16}, 20), std::exp(-1), 1e-12);
}

TEST(Score, Equation6_13_IsTheProductOfBothEnds) {
  const Segment2 drawn{{0, 0}, {100, 0}}, candidate{{3, 0}, {100, 4}};
  EXPECT_NEAR(LineFitness(drawn, candidate, 10),
              EndFitness({0, 0}, {3, 0}, 10) * EndFitness({100, 0}, {100, 4}, 10), 1e-12);
}

TEST(Score, SquaredDistanceTakesTheBetterOrientation) {
  EXPECT_DOUBLE_EQ(SquaredEndDistance({{0, 0}, {100, 0}}, {{100, 3}, {0, 4}}), 25);
}

TEST(Score, ALineOverAPartOfAnEdgeHasFreeEnds) {
  const Segment2 edge{{0, 0}, {100, 0}};
  const Cover inside = CoverOf({{70, 3}, {30, 4}}, edge, 25);
  EXPECT_EQ(inside.free_ends, 2);
  EXPECT_DOUBLE_EQ(inside.squared_px, 25);
  EXPECT_NEAR(inside.at_a, 0.7, 1e-12);
  EXPECT_NEAR(inside.at_b, 0.3, 1e-12);
  const Cover to_the_end = CoverOf({{60, 0}, {102, 0}}, edge, 25);
  EXPECT_EQ(to_the_end.free_ends, 1);
  EXPECT_DOUBLE_EQ(to_the_end.at_b, 1);
  EXPECT_DOUBLE_EQ(to_the_end.squared_px, 4);
}

TEST(Score, AnEndNearTheEdgesEndOrBeyondItIsNotFree) {
  const Segment2 edge{{0, 0}, {100, 0}};
  const Cover near = CoverOf({{3, 0}, {130, 0}}, edge, 25);
  EXPECT_EQ(near.free_ends, 0);
  EXPECT_DOUBLE_EQ(near.squared_px, 9 + 900);
  const double whole = std::numeric_limits<double>::infinity();
  EXPECT_EQ(CoverOf({{30, 0}, {70, 0}}, edge, whole).free_ends, 0);
}

RC_GTEST_PROP(Score, DirectionOfDrawingChangesNothing, (int a, int b, int c, int d)) {
  const auto coordinate = [](int v) { return static_cast<double>(v % 1000); };
  const Segment2 drawn{{coordinate(a), coordinate(b)}, {coordinate(c), coordinate(d)}};
  const Segment2 other{{10, 20}, {300, 40}};
  const double fitness = LineFitness(drawn, other, 50);
  RC_ASSERT(fitness >= 0 && fitness <= 1);
  RC_ASSERT(LineFitness({drawn.b, drawn.a}, other, 50) == fitness);
  RC_ASSERT(LineFitness(drawn, {other.b, other.a}, 50) == fitness);
}

}  // namespace
}  // namespace parti::sketch
