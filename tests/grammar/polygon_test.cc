// Polygons: reading, measuring, cutting, moving, triangulating.
#include "grammar/polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"

namespace parti::grammar::tests {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Error ErrorOf(const std::vector<Ring>& rings) {
  const auto polygon = PolygonFrom(rings);
  EXPECT_FALSE(polygon.has_value());
  return polygon ? Error{ErrorCode::kFile, ""} : polygon.error();
}
Error ErrorOf(const std::string& outline) { return ErrorOf({RingFrom(outline)}); }

double SumOfAreas(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& p : polygons) sum += Area(p);
  return sum;
}

TEST(PolygonFrom, WindingIsNormalisedAndTheFirstEdgeStaysFirst) {
  const auto polygon = PolygonFrom({RingFrom("0,0 0,8 10,8 10,0"), RingFrom("1,1 2,1 2,2 1,2")});
  ASSERT_TRUE(polygon.has_value());
  EXPECT_EQ(polygon->outer, RingFrom("0,8 0,0 10,0 10,8"));
  EXPECT_LT(SignedArea(polygon->holes[0]), 0);
  EXPECT_NEAR(Area(*polygon), 79, 1e-12);
}

TEST(PolygonFrom, RepeatedCornersAndSpikesAreDropped) {
  const Ring square = RingFrom("0,0 10,0 10,8 0,8");
  EXPECT_EQ(PolygonFrom({RingFrom("0,0 0,0 10,0 10,8 10,8 0,8 0,0")})->outer, square);
  EXPECT_EQ(PolygonFrom({RingFrom("0,0 10,0 10,5 14,5 10,5 10,8 0,8")})->outer.size(), 5u);
  EXPECT_NEAR(Area(*PolygonFrom({RingFrom("0,0 10,0 10,8 10,12 10,8 0,8")})), 80, 1e-12);
  EXPECT_EQ(PolygonFrom({RingFrom("0,0 10,0 10,8 10,12 10,20 10,8 0,8")})->outer, square);
}

TEST(PolygonFrom, StraightCornersAreKept) {
  EXPECT_EQ(PolygonFrom({RingFrom("0,0 5,0 10,0 10,8 0,8")})->outer.size(), 5u);
}

TEST(PolygonFrom, BowTieIsRefusedWithThePlace) {
  const Error error = ErrorOf("0,0 10,10 10,0 0,10");
  EXPECT_EQ(error.code, ErrorCode::kSelfIntersecting);
  EXPECT_THAT(error.message, AllOf(HasSubstr("crosses itself"), HasSubstr("(5.000, 5.000)")));
  EXPECT_FALSE(error.hint.empty());
}

TEST(PolygonFrom, TouchingItselfIsRefused) {
  EXPECT_THAT(ErrorOf("0,0 10,0 10,10 5,0 0,10").message,
              AllOf(HasSubstr("touches itself"), HasSubstr("(5.000, 0.000)")));
  EXPECT_EQ(ErrorOf("0,0 4,0 4,4 8,4 8,8 4,8 4,4 0,4").code, ErrorCode::kSelfIntersecting);
}

TEST(PolygonFrom, HolesThatTouchCrossOrLieOutsideAreRefused) {
  const Ring outline = RingFrom("0,0 10,0 10,10 0,10");
  EXPECT_THAT(ErrorOf({outline, RingFrom("0,4 3,4 3,6")}).message, HasSubstr("touches hole 1"));
  EXPECT_THAT(ErrorOf({outline, RingFrom("8,4 12,4 12,6 8,6")}).message, HasSubstr("crosses"));
  EXPECT_THAT(ErrorOf({outline, RingFrom("20,4 22,4 22,6")}).message, HasSubstr("outside"));
  EXPECT_THAT(ErrorOf({outline, RingFrom("2,2 8,2 8,8 2,8"), RingFrom("4,4 5,4 5,5")}).message,
              HasSubstr("inside another"));
  EXPECT_THAT(ErrorOf({outline, RingFrom("2,2 4,2 4,4"), RingFrom("4,4 6,4 6,6")}).code,
              ErrorCode::kSelfIntersecting);
}

TEST(PolygonFrom, WhatHasNoAreaIsRefused) {
  EXPECT_EQ(ErrorOf(std::vector<Ring>{}).code, ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(ErrorOf({Ring{}}).code, ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(ErrorOf("0,0 1,1").code, ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(ErrorOf("0,0 5,0 10,0").code, ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(ErrorOf("3,3 3,3 3,3 3,3").code, ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(ErrorOf("0,0 1e-5,0 1e-5,1e-5 0,1e-5").code, ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(ErrorOf({RingFrom("0,0 10,0 10,10 0,10"), RingFrom("2,2 4,4 6,6")}).code,
            ErrorCode::kDegenerateGeometry);
}

TEST(PolygonFrom, NumbersThatAreNotFiniteAreRefused) {
  EXPECT_EQ(ErrorOf({{Vec2(0, 0), Vec2(kNaN, 0), Vec2(1, 1)}}).code, ErrorCode::kBadNumber);
  EXPECT_EQ(ErrorOf({{Vec2(0, 0), Vec2(1, 0), Vec2(1, kInfinity)}}).code, ErrorCode::kBadNumber);
  EXPECT_EQ(ErrorOf("-1e308,0 1e-312,-1e-241 0,1e308 1e214,-1e308").code, ErrorCode::kBadNumber);
}

TEST(PolygonFrom, MapCoordinatesAndHugeOnesWork) {
  for (const double far : {6e5, 1e9}) {
    Ring ring = RingFrom("0,0 10,0 10,8 0,8");
    for (Vec2& p : ring) p += Vec2(far, -far);
    const auto polygon = PolygonFrom({ring});
    ASSERT_TRUE(polygon.has_value()) << polygon.error().message;
    EXPECT_NEAR(Area(*polygon), 80, 1e-5);
  }
  EXPECT_NEAR(Area(*PolygonFrom({RingFrom("-1e9,-1e9 1e9,-1e9 1e9,1e9 -1e9,1e9")})), 4e18, 1e6);
}

TEST(Contains, TheBorderIsInside) {
  const auto polygon = PolygonFrom({RingFrom("0,0 10,0 10,10 0,10"), RingFrom("4,4 6,4 6,6 4,6")});
  EXPECT_TRUE(Contains(*polygon, Vec2(1, 1)));
  EXPECT_TRUE(Contains(*polygon, Vec2(10, 5)));
  EXPECT_TRUE(Contains(*polygon, Vec2(4, 5)));
  EXPECT_FALSE(Contains(*polygon, Vec2(5, 5)));
  EXPECT_FALSE(Contains(*polygon, Vec2(11, 5)));
}

TEST(Slab, ACutAlongEdgesLeavesNoSlivers) {
  const auto court = PolygonFrom({RingFrom("0,0 10,0 10,10 0,10"), RingFrom("3,3 7,3 7,7 3,7")});
  const auto left = Slab(*court, 0, 0, 7);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].outer.size(), 8u);  // a C: the courtyard lies open
  EXPECT_TRUE(left[0].holes.empty());
  EXPECT_NEAR(Area(left[0]), 54, 1e-12);
  const auto right = Slab(*court, 0, 7, 10);
  ASSERT_EQ(right.size(), 1u);
  EXPECT_EQ(right[0].outer.size(), 4u);
  EXPECT_TRUE(Slab(*court, 0, 10, 12).empty());
  EXPECT_TRUE(Slab(*court, 0, 5, 5).empty());
  EXPECT_EQ(Slab(*court, 1, -5, 50).size(), 1u);
}

TEST(Slab, AConcavePolygonFallsApart) {
  const auto u = PolygonFrom({RingFrom("0,0 9,0 9,9 6,9 6,3 3,3 3,9 0,9")});
  EXPECT_EQ(Slab(*u, 1, 3, 9).size(), 2u);
  EXPECT_EQ(Slab(*u, 1, 4, 5).size(), 2u);
  EXPECT_EQ(Slab(*u, 1, 0, 3).size(), 1u);
  EXPECT_EQ(Slab(*u, 0, 3, 6).size(), 1u);
}

// (1) areas add up; (2) a point lies in the slab of its coordinate, and in no other.
RC_GTEST_PROP(SlabProperty, SlabsTileThePolygon, (uint64_t seed)) {
  Random random(seed);
  const Polygon polygon = AnyPolygon(&random);
  const Box2 box = Bounds(polygon);
  const int axis = random.Uniform() < 0.5 ? 0 : 1;
  const bool whole = random.Uniform() < 0.5;
  std::vector<double> cuts = {box.low[axis], box.high[axis]};
  for (int i = 0; i < 5; ++i) {
    const double at = random.Uniform(box.low[axis], box.high[axis]);
    cuts.push_back(whole ? std::round(at) : at);
  }
  // Cuts through corners, too.
  cuts.push_back(polygon.outer[static_cast<size_t>(random.Uniform(0, 3))][axis]);
  std::sort(cuts.begin(), cuts.end());
  std::vector<std::vector<Polygon>> slabs;
  double sum = 0;
  for (size_t i = 0; i + 1 < cuts.size(); ++i) {
    slabs.push_back(Slab(polygon, axis, cuts[i], cuts[i + 1]));
    sum += SumOfAreas(slabs.back());
    for (const Polygon& piece : slabs.back()) {
      RC_ASSERT(Bounds(piece).low[axis] >= cuts[i] - 1e-8);
      RC_ASSERT(Bounds(piece).high[axis] <= cuts[i + 1] + 1e-8);
    }
  }
  RC_ASSERT(std::abs(sum - Area(polygon)) < 1e-7);
  for (int k = 0; k < 50; ++k) {
    const Vec2 p = PointIn(box, &random);
    if (DistanceToBorder(polygon, p) < 1e-4) continue;
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (std::abs(p[axis] - cuts[i]) < 1e-4 || std::abs(p[axis] - cuts[i + 1]) < 1e-4) continue;
      const bool meant = p[axis] > cuts[i] && p[axis] < cuts[i + 1] && Contains(polygon, p);
      const auto count = std::count_if(slabs[i].begin(), slabs[i].end(),
                                       [&](const Polygon& s) { return Contains(s, p); });
      RC_ASSERT(count == (meant ? 1 : 0));
    }
  }
}

TEST(Offset, RectangleMovesBothWays) {
  const Polygon rectangle = Rectangle(Vec2(10, 8));
  EXPECT_NEAR(SumOfAreas(*Offset(rectangle, 1)), 8 * 6, 1e-9);
  EXPECT_NEAR(SumOfAreas(*Offset(rectangle, -1)), 12 * 10, 1e-9);
  EXPECT_TRUE(Offset(rectangle, 4)->empty());
  EXPECT_TRUE(Offset(rectangle, 1e6)->empty());
  EXPECT_EQ(Offset(rectangle, 0)->front(), rectangle);
}

TEST(Offset, EdgesVanishAndPiecesFallApart) {
  const auto dumbbell =
      PolygonFrom({RingFrom("0,0 8,0 8,3 12,3 12,0 20,0 20,8 12,8 12,5 8,5 8,8 0,8")});
  ASSERT_TRUE(dumbbell.has_value());
  EXPECT_EQ(Offset(*dumbbell, 0.9)->size(), 1u);
  const auto apart = Offset(*dumbbell, 1.5);
  ASSERT_EQ(apart->size(), 2u);
  EXPECT_NEAR(SumOfAreas(*apart), 2 * 25, 1e-6);
  const auto border = Border(*dumbbell, *apart);
  ASSERT_EQ(border.size(), 1u);
  EXPECT_EQ(border[0].holes.size(), 2u);
  EXPECT_NEAR(Area(border[0]) + 50, Area(*dumbbell), 1e-6);
}

TEST(Offset, AClosedBayBecomesAHole) {
  const auto c = PolygonFrom({RingFrom("0,0 10,0 10,4 9,4 9,1 1,1 1,9 9,9 9,6 10,6 10,10 0,10")});
  const auto grown = Offset(*c, -1.5);
  ASSERT_EQ(grown->size(), 1u);
  ASSERT_EQ(grown->front().holes.size(), 1u);
  EXPECT_NEAR(Area(grown->front()), 13 * 13 - 5 * 5, 1e-6);
}

TEST(Offset, HolesGrowInwardAndShrinkOutward) {
  const auto court =
      PolygonFrom({RingFrom("0,0 20,0 20,20 0,20"), RingFrom("8,8 12,8 12,12 8,12")});
  EXPECT_NEAR(SumOfAreas(*Offset(*court, 1)), 18 * 18 - 6 * 6, 1e-6);
  EXPECT_NEAR(SumOfAreas(*Offset(*court, -1)), 22 * 22 - 2 * 2, 1e-6);
  EXPECT_NEAR(SumOfAreas(*Offset(*court, -2)), 24 * 24, 1e-6);
  EXPECT_TRUE(Offset(*court, 4)->empty());
  const auto moved = Offset(*court, 1);
  EXPECT_NEAR(SumOfAreas(Border(*court, *moved)), 400 - 16 - (18 * 18 - 36), 1e-6);
  EXPECT_EQ(Border(*court, *moved).size(), 2u);
}

// Inward: points of the pieces are at least the distance from the border, and points farther than
// the mitres can reach are in a piece. The convex fast path and CGAL agree on it.
RC_GTEST_PROP(OffsetProperty, InwardPiecesKeepTheirDistance, (uint64_t seed)) {
  Random random(seed);
  const Polygon polygon = AnyPolygon(&random);
  const double distance = random.Uniform(0.05, 1.5);
  const auto pieces = Offset(polygon, distance);
  RC_ASSERT(pieces.has_value());
  RC_ASSERT(SumOfAreas(*pieces) < Area(polygon));
  const auto border = Border(polygon, *pieces);
  RC_ASSERT(std::abs(SumOfAreas(border) + SumOfAreas(*pieces) - Area(polygon)) < 1e-6);
  const Box2 box = Bounds(polygon);
  for (int k = 0; k < 100; ++k) {
    const Vec2 p = PointIn(box, &random);
    const bool inside = std::any_of(pieces->begin(), pieces->end(),
                                    [&](const Polygon& piece) { return Contains(piece, p); });
    const double from_border = DistanceToBorder(polygon, p);
    if (inside) RC_ASSERT(Contains(polygon, p) && from_border > distance - 1e-6);
    // Where a reflex corner is near, the mitre takes more than the distance; else it must not.
    bool near_reflex = false;
    const auto visit = [&](const Ring& ring) {
      for (size_t i = 0; i < ring.size(); ++i) {
        const Vec2 a = ring[(i + 1) % ring.size()] - ring[i];
        const Vec2 b = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
        near_reflex |= Cross(a, b) < 0;
      }
    };
    visit(polygon.outer);
    for (const Ring& hole : polygon.holes) visit(hole);
    if (!near_reflex && Contains(polygon, p) && from_border > distance + 1e-6) RC_ASSERT(inside);
  }
}

// Offsets by a and then b are the offset by a + b: the straight skeleton's own property.
RC_GTEST_PROP(OffsetProperty, OffsetsAddUp, (uint64_t seed)) {
  Random random(seed);
  const Polygon polygon = AnyPolygon(&random);
  const double a = random.Uniform(0.05, 0.4), b = random.Uniform(0.05, 0.4);
  const auto first = Offset(polygon, a);
  const auto both = Offset(polygon, a + b);
  RC_ASSERT(first && both);
  double sum = 0;
  for (const Polygon& piece : *first) {
    const auto second = Offset(piece, b);
    RC_ASSERT(second.has_value());
    sum += SumOfAreas(*second);
  }
  // Walls of 30 m may move by 0.05 mm where corners on them are left out (kStraight).
  RC_ASSERT(std::abs(sum - SumOfAreas(*both)) < 1e-3);
}

RC_GTEST_PROP(OffsetProperty, OutwardContainsThePolygonAndItsSurroundings, (uint64_t seed)) {
  Random random(seed);
  const Polygon polygon = AnyPolygon(&random);
  const double distance = random.Uniform(0.05, 1.5);
  const auto grown = Offset(polygon, -distance);
  RC_ASSERT(grown.has_value());
  RC_ASSERT(grown->size() == 1u);
  Box2 box = Bounds(polygon);
  box.low -= Vec2(2 * distance);
  box.high += Vec2(2 * distance);
  for (int k = 0; k < 100; ++k) {
    const Vec2 p = PointIn(box, &random);
    if (Contains(polygon, p) || DistanceToBorder(polygon, p) < distance - 1e-6) {
      RC_ASSERT(Contains(grown->front(), p));
    }
  }
}

// Triangles cover the polygon: areas add up, all are counter-clockwise, all lie inside.
RC_GTEST_PROP(TriangulateProperty, TrianglesCoverThePolygon, (uint64_t seed)) {
  Random random(seed);
  const Polygon polygon = AnyPolygon(&random);
  Ring corners = polygon.outer;
  for (const Ring& hole : polygon.holes) corners.insert(corners.end(), hole.begin(), hole.end());
  const auto triangles = Triangulate(polygon);
  RC_ASSERT(triangles.size() == 3 * (corners.size() - 2 + 2 * polygon.holes.size()));
  double sum = 0;
  for (size_t i = 0; i < triangles.size(); i += 3) {
    const Ring t = {corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]};
    RC_ASSERT(SignedArea(t) > -1e-12);
    sum += SignedArea(t);
    RC_ASSERT(Contains(polygon, (t[0] + t[1] + t[2]) / 3.0));
  }
  RC_ASSERT(std::abs(sum - Area(polygon)) < 1e-9 * (1 + Area(polygon)));
}

TEST(Triangulate, APinchedPieceIsCovered) {
  // A courtyard's corner on the cut: the piece touches itself there.
  const auto court = PolygonFrom({RingFrom("0,0 10,0 10,10 0,10"), RingFrom("5,3 7,5 5,7 3,5")});
  const auto left = Slab(*court, 0, 0, 7);
  ASSERT_EQ(left.size(), 1u);
  Ring corners = left[0].outer;
  for (const Ring& hole : left[0].holes) corners.insert(corners.end(), hole.begin(), hole.end());
  double sum = 0;
  const auto triangles = Triangulate(left[0]);
  for (size_t i = 0; i < triangles.size(); i += 3) {
    sum +=
        SignedArea({corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]});
  }
  EXPECT_NEAR(sum, 70 - 8, 1e-9);
  const auto moved = Offset(left[0], 0.5);
  ASSERT_TRUE(moved.has_value()) << moved.error().message;
  EXPECT_GT(SumOfAreas(*moved), 30);
}

}  // namespace
}  // namespace parti::grammar::tests
