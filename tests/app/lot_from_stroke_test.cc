#include "app/lot_from_stroke.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/lot.h"
#include "base/random.h"
#include "tests/app/ground_strokes.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;

using Corners = std::vector<Vec2>;
using Drawn = std::vector<std::shared_ptr<const DrawnStroke>>;

/// A pen along straight lines through these points, slow at each; 0.2 m between samples, with
/// a hand's scatter in metres.
Stroke Through(const Corners& points, double scatter_m = 0, uint64_t seed = 1) {
  Random random(seed);
  Stroke stroke;
  double t_s = 0;
  for (size_t i = 1; i < points.size(); ++i) {
    const Vec2 along = points[i] - points[i - 1];
    const int steps = std::max(8, static_cast<int>(glm::length(along) / 0.2));
    for (int k = i == 1 ? 0 : 1; k <= steps; ++k) {
      const double u = 0.5 - 0.5 * std::cos(kPi * k / steps);
      t_s += 0.008;
      const Vec2 off = scatter_m * Vec2(random.Normal(), random.Normal());
      stroke.push_back({points[i - 1] + along * u + off, t_s});
    }
  }
  return stroke;
}

Drawn Seen(const std::vector<Stroke>& strokes, const Camera& camera = GroundView()) {
  Drawn drawn;
  for (const Stroke& stroke : strokes) drawn.push_back(SeenFrom(camera, stroke));
  return drawn;
}

Corners Read(const Drawn& drawn) {
  const auto lot = LotFromStrokes(drawn);
  EXPECT_TRUE(lot) << lot.error().message;
  if (!lot) return {};
  EXPECT_TRUE(ParseLots(*lot)) << *lot;
  return CornersOf(*lot);
}

/// Corners sorted, so that the side at which an outline begins does not matter.
Corners Sorted(Corners corners) {
  std::sort(corners.begin(), corners.end(),
            [](const Vec2& a, const Vec2& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  return corners;
}

const Corners kRectangle = {{-8, -5}, {8, -5}, {8, 5}, {-8, 5}};
const Corners kRectangleSorted = {{-8, -5}, {-8, 5}, {8, -5}, {8, 5}};

TEST(LotFromStrokeTest, ACarelessRectangleHasRightAnglesAndRoundNumbers) {
  const auto stroke =
      Through({{-8.1, -5.2}, {8.2, -4.7}, {7.8, 5.1}, {-8.2, 4.8}, {-7.8, -5}}, 0.05);
  EXPECT_EQ(Sorted(Read(Seen({stroke}))), kRectangleSorted);
}

TEST(LotFromStrokeTest, ItMayBeginAnywhereAndRunEitherWay) {
  for (int start = 0; start < 8; ++start) {
    for (const bool reversed : {false, true}) {
      Corners path = {{-8, -5}, {8, -5}, {8, 5}, {-8, 5}};
      std::rotate(path.begin(), path.begin() + start / 2, path.end());
      // Odd ones begin in the middle of a side.
      if (start % 2 == 1) path.push_back((path.front() + path.back()) * 0.5);
      if (start % 2 == 1) std::rotate(path.begin(), path.end() - 1, path.end());
      path.push_back(path.front());
      if (reversed) std::reverse(path.begin(), path.end());
      EXPECT_EQ(Sorted(Read(Seen({Through(path, 0.04, 3)}))), kRectangleSorted)
          << start << " " << reversed;  // (1)
    }
  }
}

TEST(LotFromStrokeTest, FourLinesThatMeetAreALotWhateverTheirOrderAndDirection) {
  const auto side = [](const Vec2& a, const Vec2& b) { return Through({a, b}, 0.03); };
  // Some overshoot, some fall short.
  std::vector<Stroke> sides = {side({-8.4, -5}, {8.2, -5.1}), side({8, 5.3}, {8.1, -4.6}),
                               side({7.7, 5}, {-8.1, 4.9}), side({-8, -5.5}, {-7.9, 5.2})};
  for (int turn = 0; turn < 4; ++turn) {
    std::rotate(sides.begin(), sides.begin() + 1, sides.end());
    EXPECT_EQ(Sorted(Read(Seen(sides))), kRectangleSorted);
  }
  std::swap(sides[1], sides[2]);
  EXPECT_EQ(Sorted(Read(Seen(sides))), kRectangleSorted);
}

TEST(LotFromStrokeTest, ThreeSidesAreNotClosedYet) {
  const auto lot = LotFromStrokes(
      Seen({Through({{-8, -2}, {8, -2}}), Through({{8, -2}, {8, 3}}), Through({{8, 3}, {-8, 3}})}));
  ASSERT_FALSE(lot);
  EXPECT_EQ(lot.error().code, ErrorCode::kNoFit);
  EXPECT_THAT(lot.error().hint, HasSubstr("draw on"));
}

TEST(LotFromStrokeTest, SidesDrawnInDifferentViewsMeetOnTheGround) {
  Camera other = GroundView();
  other.eye = {-20, 30, 30};
  Drawn drawn = Seen({Through({{8, 5}, {-8, 5}, {-8, -5}})});
  drawn.push_back(SeenFrom(GroundView(), Through({{-8, -5}, {8, -5}, {8, 5}})));
  EXPECT_EQ(Sorted(Read(drawn)), kRectangleSorted);
}

TEST(LotFromStrokeTest, NearlyEqualSidesAreEqual) {
  const Corners square =
      Read(Seen({Through({{-6, -5.7}, {6.1, -5.8}, {6, 5.6}, {-6, 5.8}, {-6, -5.7}})}));
  ASSERT_EQ(square.size(), 4u);
  EXPECT_NEAR(glm::distance(square[0], square[1]), glm::distance(square[1], square[2]), 1e-9);
}

TEST(LotFromStrokeTest, AnLShapeKeepsItsSixRightAngles) {
  const Corners ell = Read(Seen({Through(
      {{-8.1, -6}, {0.2, -5.8}, {0, 1.1}, {8, 0.9}, {8.2, 6}, {-8, 6.2}, {-8, -6}}, 0.05)}));
  const Corners meant = {{-8, -6}, {-8, 6}, {0, -6}, {0, 1}, {8, 1}, {8, 6}};
  ASSERT_EQ(ell.size(), meant.size());
  for (size_t i = 0; i < meant.size(); ++i) {
    EXPECT_NEAR(glm::distance(Sorted(ell)[i], meant[i]), 0, 0.4);
    const Vec2 side = ell[(i + 1) % 6] - ell[i];
    EXPECT_TRUE(side.x == 0 || side.y == 0);
  }
}

TEST(LotFromStrokeTest, ASlantedLotFollowsItsOwnDirectionInWholeDegrees) {
  const double angle = Angle::Degrees(31).radians();
  Corners path = kRectangle;
  path.push_back(path.front());
  for (Vec2& p : path) {
    p = {p.x * std::cos(angle) - p.y * std::sin(angle),
         p.x * std::sin(angle) + p.y * std::cos(angle)};
  }
  const Corners lot = Read(Seen({Through(path, 0.03)}));
  ASSERT_EQ(lot.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    const Vec2 side = lot[(i + 1) % 4] - lot[i];
    const double degrees = Angle::Radians(std::atan2(side.y, side.x)).degrees();
    EXPECT_NEAR(std::remainder(degrees - 30, 90), 0, 0.02);
  }
}

TEST(LotFromStrokeTest, ASideThatIsMeantToSlantStays) {
  const Corners lot = Read(Seen({Through({{-8, -5}, {8, -5}, {3, 5}, {-8, 5}, {-8, -5}}, 0.03)}));
  EXPECT_EQ(Sorted(lot), (Corners{{-8, -5}, {-8, 5}, {3, 5}, {8, -5}}));
}

TEST(LotFromStrokeTest, ACircleIsRegularAndAnApseIsRound) {
  Stroke circle, apse = Through({{-6, 5}, {-6, -5}, {6, -5}, {6, 5}});
  for (int i = 0; i <= 80; ++i) {
    const double angle = 2 * kPi * i / 80;
    circle.push_back({Vec2(9.1 * std::cos(angle), 8.8 * std::sin(angle)), 0.01 * i});
  }
  const double end_s = apse.back().t_s;
  for (int i = 1; i <= 50; ++i) {
    const double angle = kPi * i / 50;
    apse.push_back({Vec2(6 * std::cos(angle), 5 + 6 * std::sin(angle)), end_s + 0.01 * i});
  }
  const Corners round = Read(Seen({circle}));
  ASSERT_EQ(round.size(), 32u);
  for (const Vec2& p : round) EXPECT_NEAR(glm::length(p), 9, 0.01);
  const Corners mixed = Read(Seen({apse}));
  EXPECT_GT(mixed.size(), 10u);
  EXPECT_LT(mixed.size(), 24u);
  EXPECT_NEAR(std::max_element(mixed.begin(), mixed.end(),
                               [](const Vec2& a, const Vec2& b) { return a.y < b.y; })
                  ->y,
              11, 0.3);
}

TEST(LotFromStrokeTest, WhatCannotBeALotSaysWhatToDo) {
  const auto error = [](const Drawn& drawn) {
    const auto lot = LotFromStrokes(drawn);
    EXPECT_FALSE(lot) << *lot;
    return lot ? Error{ErrorCode::kFile, ""} : lot.error();
  };
  const auto view = [](std::string_view pixels) {
    return Drawn{
        std::make_shared<const DrawnStroke>(DrawnStroke{StrokeFrom(pixels), GroundView()})};
  };
  EXPECT_EQ(error(view("800,500")).code, ErrorCode::kTooShort);
  EXPECT_EQ(error(view("800,500 804,500 804,504 800,504 800,500")).code, ErrorCode::kTooShort);
  EXPECT_EQ(error({}).code, ErrorCode::kTooShort);
  EXPECT_EQ(error(Seen({Through({{-8, -5}, {8, 5}, {8, -5}, {-8, 5}, {-8, -5}})})).code,
            ErrorCode::kSelfIntersecting);
  EXPECT_EQ(error(Seen({Through({{-8, 0}, {8, 0.1}, {-8, 0.2}})})).code,
            ErrorCode::kDegenerateGeometry);
  Camera level = GroundView();
  level.eye = {0, 1.6, 40};
  level.target = {0, 1.6, 0};
  const auto sky = Drawn{std::make_shared<const DrawnStroke>(
      DrawnStroke{StrokeFrom("400,100 900,100 900,300 400,300 400,100"), level})};
  EXPECT_EQ(error(sky).code, ErrorCode::kGrazingView);
  EXPECT_THAT(error(sky).hint, HasSubstr("higher up"));
  Camera near = GroundView();
  near.eye = {0.02, 0.3, 0.2};
  EXPECT_EQ(error(Seen({Through({{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}, {0, 0}})}, near)).code,
            ErrorCode::kDegenerateGeometry);
  Camera far = GroundView();
  far.eye = {0, 9000, 9000};
  const auto huge =
      error(Seen({Through({{0, 0}, {3000, 0}, {3000, 3000}, {0, 3000}, {0, 0}})}, far));
  EXPECT_EQ(huge.code, ErrorCode::kDegenerateGeometry);
  EXPECT_THAT(huge.message, HasSubstr("3000 m"));
}

TEST(LotFromStrokeTest, SamplesThatAreNoNumbersAreRefused) {
  DrawnStroke bad{StrokeFrom("400,600 900,600 900,800 400,800 400,600"), GroundView()};
  bad.stroke[2].position.x = NAN;
  EXPECT_FALSE(LotFromStrokes(Drawn{std::make_shared<const DrawnStroke>(bad)}));
}

TEST(LotFromStrokeTest, AnyScribbleIsALotOrAnError) {
  Random random(11);
  int lots = 0;
  for (int i = 0; i < 300; ++i) {
    Stroke stroke;
    const auto n = 2 + random.Next() % 60;
    Vec2 p(random.Uniform(0, 1600), random.Uniform(300, 1000));
    for (uint64_t k = 0; k < n; ++k) {
      p += 40.0 * Vec2(random.Normal(), random.Normal());
      stroke.push_back({p, 0.01 * static_cast<double>(k)});
    }
    const auto lot = LotFromStrokes(
        Drawn{std::make_shared<const DrawnStroke>(DrawnStroke{stroke, GroundView()})});
    if (!lot) continue;
    ++lots;
    EXPECT_TRUE(ParseLots(*lot)) << *lot;  // (2)
  }
  EXPECT_LT(lots, 60);
}

}  // namespace
}  // namespace parti::app
