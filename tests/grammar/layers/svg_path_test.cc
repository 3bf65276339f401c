#include "grammar/layers/svg_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grammar/layers/path_rings.h"

namespace parti::grammar::tests {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
constexpr double kHalfTurn = 3.141592653589793;

/// Corners of the path's first loop, with `samples` on its curves.
Ring RingFrom(std::string_view text, int samples = 1) {
  return RingsOf(ParseSvgPath(text).value(), samples, Vec2(1, 1)).at(0);
}
Error ErrorOf(std::string_view text) {
  const auto path = ParseSvgPath(text);
  EXPECT_FALSE(path.has_value()) << text;
  return path ? Error{} : path.error();
}
double AreaOf(std::string_view text, int samples = 2000) {
  return SignedArea(RingFrom(text, samples));
}

const Ring kSquare = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(SvgPath, ReadsLinesInAllForms) {
  for (const char* text : {
           "M0,0 L1,0 L1,1 L0,1 Z",
           "M 0 0 1 0 1 1 0 1z",
           "m0,0 l1,0 l0,1 l-1,0 z",
           "M0,0H1V1H0Z",
           "m0,0h1v1h-1z",
           "M0,0 1,0 1,1 0,1",
           "M0 0L1e0-0L1+1L.0.1E1Z",
           "\n M0,0\tL 1 , 0 1 1 0,1 \r\n Z ",
           "M5,5 M0,0 L1,0 L1,1 L0,1 L0,0 Z",
           "M0,0 L1,0 L1,0 L1,1 L0,1 Z Z",
       }) {
    EXPECT_EQ(RingFrom(text), kSquare) << text;
  }
}

TEST(SvgPath, ThePapersArchHasYUp) {
  const Ring arch = RingFrom("M0,0 L0,0.5 C0,1 1,1 1,0.5 L1,0Z", 50);
  ASSERT_THAT(arch, SizeIs(4 + 50));
  EXPECT_EQ(arch[0], Vec2(0, 0));
  EXPECT_EQ(arch[1], Vec2(0, 0.5));
  EXPECT_EQ(arch[52], Vec2(1, 0.5));
  EXPECT_EQ(arch[53], Vec2(1, 0));
  for (size_t i = 2; i < 52; ++i) EXPECT_GT(arch[i].y, 0.5);
}

TEST(SvgPath, SamplesAreSpreadEvenlyByLength) {
  const Ring arch = RingsOf(*ParseSvgPath("M0,0 L0,0.5 C0,1 1,1 1,0.5 L1,0Z"), 50, Vec2(3, 1))[0];
  const double first = glm::distance(arch[1], arch[2]);
  for (size_t i = 2; i < 52; ++i) {
    EXPECT_NEAR(glm::distance(arch[i], arch[i + 1]), first, 0.05 * first);
  }
}

TEST(SvgPath, EveryCurveGetsASample) {
  EXPECT_THAT(RingFrom("M0,0 Q0.5,1 1,0 Q0.99,-0.01 0.98,0 Z", 3), SizeIs(2 + 3 + 1 + 1));
  EXPECT_THAT(RingFrom("M0,0 L1,0 L1,1Z", 500), SizeIs(3));
}

TEST(SvgPath, ReadsQuadraticAndCubicCurves) {
  EXPECT_NEAR(AreaOf("M0,0 Q1,2 2,0 Z"), -4.0 / 3, 1e-5);
  EXPECT_NEAR(AreaOf("m0,0 q1,2 2,0 z"), -4.0 / 3, 1e-5);
  EXPECT_NEAR(AreaOf("M0,0 C0,4 4,4 4,0 Z"), -9.6, 1e-4);
  EXPECT_NEAR(AreaOf("M1,1 c0,4 4,4 4,0 Z"), -9.6, 1e-4);
}

TEST(SvgPath, SmoothCurvesMirrorTheControlPointBefore) {
  EXPECT_EQ(RingFrom("M0,0 Q1,1 2,0 T4,0 L4,-5 0,-5Z", 20),
            RingFrom("M0,0 Q1,1 2,0 Q3,-1 4,0 L4,-5 0,-5Z", 20));
  EXPECT_EQ(RingFrom("M0,0 C0,1 1,2 2,0 S4,-1 4,0 V-5 H0Z", 20),
            RingFrom("M0,0 C0,1 1,2 2,0 C3,-2 4,-1 4,0 V-5 H0Z", 20));
  // Without such a curve before, the control point is the pen.
  EXPECT_EQ(RingFrom("M0,0 L2,0 S4,1 4,0 V-5 H0Z", 20),
            RingFrom("M0,0 L2,0 C2,0 4,1 4,0 V-5 H0Z", 20));
  EXPECT_EQ(RingFrom("M0,0 C0,1 1,2 2,0 t2,0 V-5 H0Z", 20),
            RingFrom("M0,0 C0,1 1,2 2,0 Q2,0 4,0 V-5 H0Z", 20));
}

TEST(SvgPath, ArcsRunCounterClockwiseWithTheSweepFlag) {
  EXPECT_NEAR(AreaOf("M1,0 A1,1 0 0 1 -1,0 Z"), kHalfTurn / 2, 1e-5);
  EXPECT_NEAR(AreaOf("M1,0 A1,1 0 0 0 -1,0 Z"), -kHalfTurn / 2, 1e-5);
  EXPECT_NEAR(AreaOf("M1,0 A1,1 0 01-1,0 A1,1 0 0,1 1,0 Z"), kHalfTurn, 1e-4);
}

TEST(SvgPath, TheLargeArcFlagTakesTheLongerWay) {
  const double small = kHalfTurn / 4 - 0.5;
  EXPECT_NEAR(AreaOf("M1,0 A1,1 0 0 1 0,1 Z"), small, 1e-5);
  EXPECT_NEAR(AreaOf("M1,0 A1,1 0 1 0 0,1 Z"), -(kHalfTurn - small), 1e-4);
}

TEST(SvgPath, ArcsMayBeEllipsesAndTurned) {
  EXPECT_NEAR(AreaOf("M2,0 A2,1 0 0 1 -2,0 Z"), kHalfTurn, 1e-4);
  EXPECT_NEAR(AreaOf("M0,2 A2,1 90 0 1 0,-2 Z"), kHalfTurn, 1e-4);
  EXPECT_NEAR(AreaOf("M2,0 a2 1 360 0 1 -4 0 z"), kHalfTurn, 1e-4);
}

TEST(SvgPath, ArcsThatDoNotReachAreScaledUp) {
  EXPECT_NEAR(AreaOf("M1,0 A0.1,0.1 0 0 1 -1,0 Z"), kHalfTurn / 2, 1e-5);
  EXPECT_NEAR(AreaOf("M1,0 A-1,-1 0 0 1 -1,0 Z"), kHalfTurn / 2, 1e-5);
}

TEST(SvgPath, ArcsWithoutRadiusAreLines) {
  EXPECT_EQ(RingFrom("M0,0 A0,5 0 0 1 1,0 L1,1 0,1Z", 9), kSquare);
  EXPECT_EQ(RingFrom("M0,0 A1,1 0 1 1 0,0 L1,0 1,1 0,1Z", 9), kSquare);
}

TEST(SvgPath, FurtherLoopsAreRingsOfTheirOwn) {
  const auto path = ParseSvgPath("M0,0H1V1H0Z M0.2,0.2 h0.2v0.2h-0.2z l1,0 0,1z");
  ASSERT_THAT(*path, SizeIs(3));
  EXPECT_EQ(path->at(2).front().start(), Vec2(0.2, 0.2));  // Z brings the pen back
}

TEST(SvgPath, EndsAreExact) {
  const auto path = ParseSvgPath("M0.1,0.2 A0.3,0.7 33 1 0 0.7,0.9 C1,2 3,4 0.3,0.6 Z");
  const PathSegment& arc = path->at(0)[0];
  EXPECT_EQ(arc.At(0), Vec2(0.1, 0.2));
  EXPECT_EQ(arc.At(1), Vec2(0.7, 0.9));
  EXPECT_NEAR(glm::distance(arc.At(1e-9), arc.At(0)), 0, 1e-8);
  EXPECT_NEAR(glm::distance(arc.At(1 - 1e-9), arc.At(1)), 0, 1e-8);
}

TEST(SvgPath, ErrorsSayWhereInThePath) {
  const Error error = ErrorOf("M0,0 L0,1 B1,1 Z");
  EXPECT_EQ(error.code, ErrorCode::kBadText);
  EXPECT_EQ(error.message, "path, character 11: expected a command, got 'B'");
  ASSERT_TRUE(error.place.has_value());
  EXPECT_EQ(error.place->column, 11);
}

TEST(SvgPath, EveryKindOfMistakeHasItsMessage) {
  EXPECT_THAT(ErrorOf("").message, HasSubstr("a closed line, got the end"));
  EXPECT_THAT(ErrorOf("M0,0").message, HasSubstr("a closed line, got the end"));
  EXPECT_THAT(ErrorOf("L0,0 1,1").message, HasSubstr("M, where the path starts, got 'L'"));
  EXPECT_THAT(ErrorOf("0,0 1,1").message, HasSubstr("character 1: expected M"));
  EXPECT_THAT(ErrorOf("M0").message, HasSubstr("character 3: expected a number, got the end"));
  EXPECT_THAT(ErrorOf("M0,0 L1").message, HasSubstr("expected a number"));
  EXPECT_THAT(ErrorOf("M0,,0").message, HasSubstr("expected a number, got ','"));
  EXPECT_THAT(ErrorOf("M0,0 L1,1,").message, HasSubstr("expected a command, got ','"));
  EXPECT_THAT(ErrorOf("M0,0 Z 1,1").message, HasSubstr("expected a command, got '1'"));
  EXPECT_THAT(ErrorOf("M0,0 A1,1 0 2 0 1,1").message, HasSubstr("a flag, 0 or 1, got '2'"));
  EXPECT_THAT(ErrorOf("M0,0 L-,1").message, HasSubstr("expected a number, got '-'"));
  EXPECT_THAT(ErrorOf("M0,0 Lnan,1").message, HasSubstr("expected a number, got 'n'"));
  EXPECT_THAT(ErrorOf("M0,0 L\xff,1").message, HasSubstr("got '?'"));
  EXPECT_EQ(ErrorOf("M0,0 L1e9,1").code, ErrorCode::kBadNumber);
  EXPECT_EQ(ErrorOf("M0,0 L1e999,1").code, ErrorCode::kBadNumber);
}

TEST(SvgPath, EndlessPathsAreRefused) {
  std::string text = "M0,0";
  for (int i = 0; i < 20'000; ++i) text += " 1,1 0,0";
  EXPECT_EQ(ErrorOf(text).code, ErrorCode::kLimitReached);
}

}  // namespace
}  // namespace parti::grammar::tests
