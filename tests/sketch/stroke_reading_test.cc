#include "sketch/stroke_reading.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/sketch/sketch_scene.h"

namespace parti::sketch {
namespace {

using ::testing::SizeIs;

Stroke Along(const std::vector<Vec2>& corners) {
  Stroke stroke;
  for (size_t i = 0; i + 1 < corners.size(); ++i) {
    for (int k = i == 0 ? 0 : 1; k <= 30; ++k) {
      const double t = stroke.empty() ? 0 : stroke.back().t_s + (k % 30 < 3 ? 0.03 : 0.008);
      stroke.push_back({corners[i] + (corners[i + 1] - corners[i]) * (k / 30.0), t});
    }
  }
  return stroke;
}

TEST(ReadStroke, AStraightStrokeIsOneLineFromEndToEnd) {
  const auto readings = ReadStroke(Along({{100, 100}, {400, 120}}));
  ASSERT_TRUE(readings);
  ASSERT_THAT(*readings, SizeIs(1));
  ASSERT_THAT((*readings)[0].lines, SizeIs(1));
  EXPECT_EQ((*readings)[0].lines[0].a, Vec2(100, 100));
  EXPECT_EQ((*readings)[0].lines[0].b, Vec2(400, 120));
  EXPECT_EQ((*readings)[0].price, 0);
}

TEST(ReadStroke, AHookAtTheEndLeavesTheWholeLineAsAReading) {
  const Stroke stroke = Along({{100, 100}, {500, 100}, {540, 30}});
  const auto readings = ReadStroke(stroke);
  ASSERT_TRUE(readings);
  bool whole = false;
  for (const StrokeReading& reading : *readings) {
    whole = whole || (reading.lines.size() == 1 && reading.lines[0].b == Vec2(540, 30));
    EXPECT_GE(reading.price, 0);
  }
  EXPECT_TRUE(whole);
}

TEST(ReadStroke, EndsOfAClosedOutlineMeetWhereItsSidesCross) {
  // The pen goes down inside the first side and lifts before it has come back.
  const auto readings =
      ReadStroke(Along({{118, 100}, {500, 100}, {500, 300}, {100, 300}, {100, 125}}));
  ASSERT_TRUE(readings);
  ASSERT_THAT((*readings)[0].lines, SizeIs(4));
  EXPECT_LT(glm::distance((*readings)[0].lines.front().a, Vec2(100, 100)), 8);
  EXPECT_LT(glm::distance((*readings)[0].lines.back().b, Vec2(100, 100)), 8);
}

TEST(ReadStroke, ReversingTheStrokeReversesTheLines) {
  Stroke stroke = Along({{100, 500}, {110, 200}, {500, 220}, {510, 520}});
  const auto forward = ReadStroke(stroke);
  std::reverse(stroke.begin(), stroke.end());
  for (StrokeSample& s : stroke) s.t_s = 10 - s.t_s;
  const auto backward = ReadStroke(stroke);
  ASSERT_TRUE(forward && backward);
  const auto& lines = (*forward)[0].lines;
  const auto& reversed = (*backward)[0].lines;
  ASSERT_EQ(lines.size(), reversed.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    EXPECT_LT(glm::distance(lines[i].a, reversed[lines.size() - 1 - i].b), 12);
  }
}

TEST(ReadStroke, ErrorsTellTapsAndBadNumbersApart) {
  const auto tap = ReadStroke(StrokeFrom("5,5"));
  ASSERT_FALSE(tap);
  EXPECT_EQ(tap.error().code, ErrorCode::kTooShort);
  Stroke broken = Along({{0, 0}, {100, 0}});
  broken[3].position.x = std::numeric_limits<double>::quiet_NaN();
  const auto bad = ReadStroke(broken);
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().code, ErrorCode::kBadNumber);
}

TEST(ReadStrokes, PassesOverTapsAsLongAsThereIsALine) {
  const auto some = ReadStrokes({StrokeFrom("5,5"), Along({{0, 0}, {100, 0}})});
  ASSERT_TRUE(some);
  EXPECT_THAT(*some, SizeIs(1));
  const auto none = ReadStrokes({StrokeFrom("5,5")});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kTooShort);
  const auto empty = ReadStrokes({});
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().code, ErrorCode::kTooShort);
}

}  // namespace
}  // namespace parti::sketch
