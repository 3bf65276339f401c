#include "app/crease_lines.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "base/random.h"

namespace parti::app {
namespace {

double TotalLength(const std::vector<Segment3>& segments) {
  double length = 0;
  for (const Segment3& s : segments) length += glm::length(s.b - s.a);
  return length;
}

double DistanceTo(const std::vector<Segment3>& segments, const Vec3& p) {
  double nearest = 1e9;
  for (const Segment3& s : segments) {
    const Vec3 d = s.b - s.a;
    const double t = std::clamp(glm::dot(p - s.a, d) / glm::dot(d, d), 0.0, 1.0);
    nearest = std::min(nearest, glm::length(s.a + d * t - p));
  }
  return nearest;
}

TEST(WithoutOverlaps, EdgesOfNeighboursAreDrawnOnce) {
  // A long edge over three shorter ones, the last drawn the other way and longer.
  const auto lines = WithoutOverlaps({{{0, 3, 0}, {6, 3, 0}},
                                      {{0, 3, 0}, {2, 3, 0}},
                                      {{2, 3, 0}, {4, 3, 0}},
                                      {{7, 3, 0}, {4, 3, 0}},
                                      {{0, 3, 0}, {0, 0, 0}}});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_DOUBLE_EQ(TotalLength(lines), 7 + 3);
}

TEST(WithoutOverlaps, GapsAndParallelsStay) {
  EXPECT_EQ(WithoutOverlaps({{{0, 0, 0}, {1, 0, 0}}, {{1.01, 0, 0}, {2, 0, 0}}}).size(), 2u);
  EXPECT_EQ(WithoutOverlaps({{{0, 0, 0}, {1, 0, 0}}, {{0, 0.01, 0}, {1, 0.01, 0}}}).size(), 2u);
  EXPECT_EQ(WithoutOverlaps({{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 0.01, 0}}}).size(), 2u);
}

TEST(WithoutOverlaps, WhatIsNoLineIsLeftOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(WithoutOverlaps(
                  {{{1, 2, 3}, {1, 2, 3}}, {{nan, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1e300, 0, 0}}})
                  .empty());
  EXPECT_TRUE(WithoutOverlaps({}).empty());
}

/// Pieces of some few lines, so that many overlap.
std::vector<Segment3> Pieces(uint64_t seed) {
  Random random(seed);
  std::vector<Segment3> pieces;
  for (int line = 0; line < 4; ++line) {
    const Vec3 from(random.Uniform(-20, 20), random.Uniform(0, 20), random.Uniform(-20, 20));
    const Vec3 along = glm::normalize(Vec3(random.Normal(), random.Normal(), random.Normal()));
    for (int i = 0; i < 6; ++i) {
      const double a = random.Uniform(0, 15), b = a + random.Uniform(-5, 5);
      pieces.push_back({from + along * a, from + along * b});
    }
  }
  return pieces;
}

RC_GTEST_PROP(WithoutOverlaps, CoversTheSamePointsOnce, (uint64_t seed)) {
  const std::vector<Segment3> given = Pieces(seed), result = WithoutOverlaps(given);
  for (const Segment3& s : given) {  // (1)
    for (const double t : {0.0, 0.3, 1.0})
      RC_ASSERT(DistanceTo(result, s.a + (s.b - s.a) * t) < 2e-3);
  }
  for (const Segment3& s : result) {
    for (const double t : {0.0, 0.4, 1.0})
      RC_ASSERT(DistanceTo(given, s.a + (s.b - s.a) * t) < 2e-3);
  }
  RC_ASSERT(TotalLength(result) <= TotalLength(given) + 1e-3);
}

RC_GTEST_PROP(WithoutOverlaps, OrderAndDirectionDoNotMatter, (uint64_t seed)) {
  std::vector<Segment3> given = Pieces(seed);
  const auto result = WithoutOverlaps(given);
  std::reverse(given.begin(), given.end());
  for (Segment3& s : given) std::swap(s.a, s.b);
  const auto reversed = WithoutOverlaps(given);
  RC_ASSERT(reversed.size() == result.size());  // (2)
  RC_ASSERT(std::abs(TotalLength(reversed) - TotalLength(result)) < 1e-6);
}

}  // namespace
}  // namespace parti::app
