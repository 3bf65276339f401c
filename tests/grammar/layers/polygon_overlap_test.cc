// What two polygons share, against an integral over horizontal strips: polygons that cross, that
// abut along slanted edges, and the strips that setbacks leave.
#include "grammar/layers/polygon_overlap.h"

#include <gtest/gtest.h>

#include "grammar/polygon_setback.h"
#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"
#include "tests/grammar/shared_area.h"

namespace parti::grammar::tests {
namespace {

double SumOf(const std::vector<Polygon>& pieces) {
  double sum = 0;
  for (const Polygon& piece : pieces) sum += Area(piece);
  return sum;
}

/// Both ways round, and against themselves.
void ExpectShared(const Polygon& a, const Polygon& b, const std::string& what) {
  const double shared = SharedArea(a, b), tolerance = 1e-7 * (1 + std::max(Area(a), Area(b)));
  for (const auto& [p, q] : {std::pair(&a, &b), {&b, &a}}) {
    const auto pieces = Overlap(*p, *q);
    ASSERT_TRUE(pieces) << what;
    ASSERT_NEAR(SumOf(*pieces), shared, tolerance) << what;
    for (const Polygon& piece : *pieces) {
      ASSERT_NEAR(SharedArea(piece, *p), Area(piece), tolerance) << what;
      ASSERT_NEAR(SharedArea(piece, *q), Area(piece), tolerance) << what;
    }
  }
}

Polygon Moved(Polygon polygon, const Vec2& by) {
  for (Vec2& p : polygon.outer) p += by;
  for (Ring& hole : polygon.holes) {
    for (Vec2& p : hole) p += by;
  }
  return polygon;
}

TEST(SharedArea, IsThatOfPlainCases) {
  const Polygon square = Rectangle({2, 2});
  EXPECT_NEAR(SharedArea(square, square), 4, 1e-12);
  EXPECT_NEAR(SharedArea(square, Moved(square, {1, 1})), 1, 1e-12);
  EXPECT_NEAR(SharedArea(square, Moved(square, {2, 0})), 0, 1e-12);
  const Polygon ring{RingFrom("0,0 4,0 4,4 0,4"), {RingFrom("1,1 1,3 3,3 3,1")}};
  EXPECT_NEAR(SharedArea(ring, square), 3, 1e-12);
  EXPECT_NEAR(SharedArea({RingFrom("0,0 4,0 0,4"), {}}, ring), 6, 1e-12);
}

TEST(OverlapProperty, RandomPolygonsShareWhatTheirStripsShare) {
  for (uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const Polygon a = AnyPolygon(&random), b = AnyPolygon(&random);
    const Vec2 by = PointIn(Bounds(a), &random) - PointIn(Bounds(b), &random);
    ExpectShared(a, Moved(b, by), "seed " + std::to_string(seed));
  }
}

/// Some of the 21 of 20,000 in which Clipper's own nesting or simple output went wrong, and others.
std::vector<uint64_t> Seeds() {
  std::vector<uint64_t> seeds = {511, 2046, 2394, 3230, 10204, 18041, 18586, 19602};
  for (uint64_t seed = 0; seed < 200; ++seed) seeds.push_back(seed);
  return seeds;
}

TEST(OverlapProperty, PartsThatAbutAlongSlantedEdgesShareNothingAndAreAllTheirs) {
  for (const uint64_t seed : Seeds()) {
    Random random(seed);
    const Polygon whole = AnyPolygon(&random);
    size_t corners = whole.outer.size();
    for (const Ring& hole : whole.holes) corners += hole.size();
    std::vector<EdgeSetback> edges(corners);
    for (EdgeSetback& edge : edges) {
      if (random.Uniform() < 0.5) continue;
      edge = {random.Uniform(0, 3), static_cast<int>(random.Uniform(0, 3))};
    }
    const auto cut = Setback(whole, edges);
    ASSERT_TRUE(cut) << seed;
    std::vector<Polygon> parts = cut->remainder;
    for (const auto& strip : cut->strips) parts.insert(parts.end(), strip.begin(), strip.end());
    const std::string what = "seed " + std::to_string(seed);
    for (size_t i = 0; i < parts.size(); ++i) {
      ExpectShared(whole, parts[i], what);
      for (size_t k = i + 1; k < parts.size(); ++k) ExpectShared(parts[i], parts[k], what);
    }
  }
}

}  // namespace
}  // namespace parti::grammar::tests
