#include "sketch/segmentation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "base/random.h"

namespace parti::sketch {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

// Straight runs between the given points, a sample every `spacing`, slowing at each corner as a
// hand does, with a tremor of `tremor` standard deviation.
Stroke Drawn(const std::vector<Vec2>& points, double tremor = 0, double spacing = 2) {
  Random random(7);
  Stroke stroke = {{points[0], 0}};
  for (size_t i = 1; i < points.size(); ++i) {
    const double length = glm::distance(points[i - 1], points[i]);
    const int n = std::max(2, static_cast<int>(length / spacing));
    for (int k = 1; k <= n; ++k) {
      const double u = static_cast<double>(k) / n;
      const Vec2 jitter = tremor * Vec2(random.Normal(), random.Normal());
      const double slowness = 1 / (0.1 + 4 * u * (1 - u));  // of a bell-shaped speed
      stroke.push_back(
          {glm::mix(points[i - 1], points[i], u) + jitter, stroke.back().t_s + 0.001 * slowness});
    }
  }
  return stroke;
}

Stroke Circle(double radius, double from_deg = 0, double to_deg = 360) {
  Stroke stroke;
  for (int i = 0; i <= 120; ++i) {
    const double a = Angle::Degrees(from_deg + (to_deg - from_deg) * i / 120).radians();
    stroke.push_back({radius * Vec2(std::cos(a), std::sin(a)), 0.01 * i});
  }
  return stroke;
}

Segmentation Segmented(const Stroke& stroke) {
  const auto found = SegmentStroke(stroke);
  EXPECT_TRUE(found.has_value());
  return found ? *found : Segmentation{};
}

int Lines(const Segmentation& s) {
  return static_cast<int>(std::count_if(s.segments.begin(), s.segments.end(), [](const auto& x) {
    return x.kind == SegmentKind::kLine;
  }));
}

void ExpectWellFormed(const Segmentation& s, const Stroke& stroke) {
  ASSERT_GE(s.corners.size(), 2u);
  ASSERT_EQ(s.segments.size(), s.corners.size() - 1);
  EXPECT_EQ(s.corners.front(), 0);
  EXPECT_EQ(s.corners.back(), static_cast<int>(stroke.size()) - 1);
  for (size_t i = 0; i < s.segments.size(); ++i) {
    EXPECT_EQ(s.segments[i].from, s.corners[i]);
    EXPECT_EQ(s.segments[i].to, s.corners[i + 1]);
    EXPECT_LT(s.corners[i], s.corners[i + 1]);
  }
}

const std::vector<Vec2> kRectangle = {{0, 0}, {300, 0}, {300, 180}, {0, 180}, {4, 6}};

TEST(SegmentStroke, ThreeSamplesOfAnL) {
  EXPECT_THAT(Segmented(StrokeFrom("0,0 10,0 10,8")).corners, ElementsAre(0, 1, 2));
}

TEST(SegmentStroke, TwoSamplesAreALine) {
  const Segmentation s = Segmented(StrokeFrom("0,0 10,0"));
  EXPECT_THAT(s.corners, ElementsAre(0, 1));
  EXPECT_EQ(s.segments[0].kind, SegmentKind::kLine);
}

TEST(SegmentStroke, ARectangleInOneStrokeIsFourLines) {
  for (const double tremor : {0.0, 0.7, 2.0}) {
    const Segmentation s = Segmented(Drawn(kRectangle, tremor));
    EXPECT_THAT(s.segments, SizeIs(4)) << "tremor " << tremor;
    EXPECT_EQ(Lines(s), 4);
  }
}

TEST(SegmentStroke, CornersLieWhereThePenTurned) {
  const Stroke stroke = Drawn(kRectangle, 0.7);
  const Segmentation s = Segmented(stroke);
  ASSERT_THAT(s.corners, SizeIs(5));
  for (int i = 1; i <= 3; ++i) {
    EXPECT_LT(glm::distance(stroke[s.corners[i]].position, kRectangle[i]), 6) << i;
  }
}

TEST(SegmentStroke, ALongLineWithATremorIsOneLine) {
  const Segmentation s = Segmented(Drawn({{0, 0}, {1000, 130}}, 3));
  EXPECT_THAT(s.segments, SizeIs(1));
  EXPECT_EQ(Lines(s), 1);
}

TEST(SegmentStroke, HooksAtBothEndsAreNoSegments) {
  const Segmentation line = Segmented(Drawn({{12, -25}, {0, 0}, {400, 0}, {380, 22}}));
  EXPECT_THAT(line.segments, SizeIs(1));
  EXPECT_EQ(Lines(line), 1);
}

TEST(SegmentStroke, AnArrowIsDrawnWithAHeadThatRetracesItself) {
  const Segmentation s = Segmented(Drawn({{0, 0}, {300, 0}, {230, 50}, {300, 0}, {230, -50}}, 0.7));
  EXPECT_EQ(Lines(s), 4);
}

TEST(SegmentStroke, ACircleIsACurveWithoutCorners) {
  const Segmentation s = Segmented(Circle(90));
  EXPECT_THAT(s.segments, SizeIs(1));
  EXPECT_EQ(Lines(s), 0);
}

TEST(SegmentStroke, ALineIntoAHalfCircleHasACurve) {
  Stroke stroke = Drawn({{-100, -300}, {-100, 0}});
  const double t_s = stroke.back().t_s;
  for (auto sample : Circle(100, 180, 360)) {
    sample.position.y = -sample.position.y;
    sample.t_s += t_s;
    stroke.push_back(sample);
  }
  EXPECT_LT(Lines(Segmented(stroke)), static_cast<int>(Segmented(stroke).segments.size()));
}

TEST(SegmentStroke, WithoutTimesCurvatureAloneFindsTheCorners) {
  Stroke stroke = Drawn(kRectangle, 0.7);
  for (auto& sample : stroke) sample.t_s = 0;
  EXPECT_EQ(Lines(Segmented(stroke)), 4);
}

TEST(SegmentStroke, TimesInBatchesGiveTheSameCorners) {
  Stroke stroke = Drawn(kRectangle, 0.7);
  const Segmentation fine = Segmented(stroke);
  for (size_t i = 0; i < stroke.size(); ++i) {
    stroke[i].t_s = stroke[std::min(stroke.size() - 1, i / 4 * 4 + 3)].t_s;
  }
  const Segmentation batched = Segmented(stroke);
  ASSERT_EQ(batched.corners.size(), fine.corners.size());
  for (size_t i = 0; i < fine.corners.size(); ++i) {
    EXPECT_NEAR(batched.corners[i], fine.corners[i], 4);
  }
}

TEST(SegmentStroke, CoincidentSamplesChangeNothing) {
  const Stroke stroke = Drawn(kRectangle, 0.7);
  Stroke doubled;
  for (const auto& sample : stroke) doubled.insert(doubled.end(), 2, sample);
  EXPECT_EQ(Segmented(doubled).segments.size(), Segmented(stroke).segments.size());
}

TEST(SegmentStroke, ATapIsTooShort) {
  for (const char* tap : {"", "3,4", "3,4 3,4"}) {
    const auto found = SegmentStroke(StrokeFrom(tap));
    ASSERT_FALSE(found) << tap;
    EXPECT_EQ(found.error().code, ErrorCode::kTooShort);
  }
}

TEST(SegmentStroke, AHugeScribbleStaysWellFormedAndBounded) {
  Random random(3);
  Stroke stroke;
  for (int i = 0; i < 100'000; ++i) {
    const int batch = i / 3;
    stroke.push_back({Vec2(random.Uniform(0, 500), random.Uniform(0, 500)), 1e-3 * batch});
  }
  const Segmentation s = Segmented(stroke);
  ExpectWellFormed(s, stroke);
  EXPECT_LE(s.corners.size(), 2u + SegmentationParameters().most_candidates);
}

TEST(SegmentStroke, TinyAndHugeUnitsSegmentAlike) {
  for (const double scale : {1e-9, 1e9}) {
    Stroke stroke = Drawn(kRectangle, 0.7);
    for (auto& sample : stroke) sample.position *= scale;
    EXPECT_EQ(Lines(Segmented(stroke)), 4) << scale;
  }
}

// A random polyline whose corners turn by 50 degrees or more and whose legs are not short.
Stroke RandomPolyline() {
  std::vector<Vec2> points = {{0, 0}};
  double heading = Angle::Degrees(*rc::gen::inRange(0, 360)).radians();
  const int legs = *rc::gen::inRange(1, 6);
  for (int i = 0; i < legs; ++i) {
    const double length = *rc::gen::inRange(150, 300);
    points.push_back(points.back() + length * Vec2(std::cos(heading), std::sin(heading)));
    const double turn = *rc::gen::inRange(50, 150) * (*rc::gen::arbitrary<bool>() ? 1 : -1);
    heading += Angle::Degrees(turn).radians();
  }
  return Drawn(points, 0.5);
}

RC_GTEST_PROP(SegmentStroke, Property1_MovingTurningScalingAndSlowingChangesNothing, ()) {
  const Stroke stroke = RandomPolyline();
  const double angle = Angle::Degrees(*rc::gen::inRange(0, 360)).radians();
  const double scale = std::exp(0.1 * *rc::gen::inRange(-60, 60));
  const double slower = std::exp(0.1 * *rc::gen::inRange(-30, 30));
  const Vec2 offset(*rc::gen::inRange(-5000, 5000), *rc::gen::inRange(-5000, 5000));
  Stroke moved = stroke;
  for (auto& s : moved) {
    const Vec2 p = s.position;
    s.position = offset + scale * Vec2(std::cos(angle) * p.x - std::sin(angle) * p.y,
                                       std::sin(angle) * p.x + std::cos(angle) * p.y);
    s.t_s *= slower;
  }
  const Segmentation still = Segmented(stroke), after = Segmented(moved);
  RC_ASSERT(still.corners.size() == after.corners.size());
  // A corner between two points of the path is equally near to both, and rounding chooses.
  const double step = Diagonal(stroke) / SegmentationParameters().steps_per_diagonal;
  for (size_t i = 0; i < still.corners.size(); ++i) {
    const Vec2 a = stroke[still.corners[i]].position, b = stroke[after.corners[i]].position;
    RC_ASSERT(glm::distance(a, b) <= 2 * step);
  }
}

RC_GTEST_PROP(SegmentStroke, Property2_ReversalMirrorsTheCorners, ()) {
  const Stroke stroke = RandomPolyline();
  Stroke reversed(stroke.rbegin(), stroke.rend());
  for (auto& s : reversed) s.t_s = stroke.back().t_s - s.t_s;
  Segmentation back = Segmented(reversed);
  const int last = static_cast<int>(stroke.size()) - 1;
  for (int& corner : back.corners) corner = last - corner;
  std::reverse(back.corners.begin(), back.corners.end());
  const Segmentation forth = Segmented(stroke);
  RC_ASSERT(back.corners.size() == forth.corners.size());
  const double step = Diagonal(stroke) / SegmentationParameters().steps_per_diagonal;
  for (size_t i = 0; i < back.corners.size(); ++i) {
    const Vec2 a = stroke[forth.corners[i]].position, b = stroke[back.corners[i]].position;
    RC_ASSERT(glm::distance(a, b) <= 2 * step);
  }
}

RC_GTEST_PROP(SegmentStroke, AnyFiniteStrokeIsWellFormedOrATap, ()) {
  Stroke stroke;
  const int samples = *rc::gen::inRange(0, 60);
  double t_s = 0;
  for (int i = 0; i < samples; ++i) {
    t_s += 0.01 * *rc::gen::inRange(0, 3);
    stroke.push_back({Vec2(*rc::gen::inRange(0, 5), *rc::gen::inRange(0, 5)), t_s});
  }
  const auto found = SegmentStroke(stroke);
  if (found) {
    ExpectWellFormed(*found, stroke);
  } else {
    RC_ASSERT(Diagonal(stroke) == 0);
  }
}

}  // namespace
}  // namespace parti::sketch
