#include "sketch/readable.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "grammar/operation.h"
#include "sketch/actions.h"
#include "tests/sketch/sketch_scene.h"

namespace parti::sketch {
namespace {

using tests::At;
using tests::Drawn;

const SketchParameters kParameters;

SketchedLines Lines(const std::vector<Segment3>& lines) {
  return {Drawn(lines, tests::HouseCamera()), kParameters.noise};
}

/// What an extrusion of the lot becomes under a line that was drawn `drawn_m` high.
double ReadableHeight(double height_m, double drawn_m) {
  const auto lot = tests::Lot();
  const auto action = ActionOfLength(*grammar::FindOperation("extrude"), height_m);
  const auto readable = Readable(action, MadeEdges(lot),
                                 Lines({{At(lot, 20, 0), At(lot, 20, 0, drawn_m)}}), kParameters);
  return std::get<double>(readable.arguments[0]);
}

TEST(Readable, LosesTheDigitsThatThePenDoesNotKnow) {
  EXPECT_EQ(ReadableHeight(7.01023337599759, 7.01), 7);
  EXPECT_EQ(ReadableHeight(3.2004, 3.2), 3.2);
}

TEST(Readable, KeepsWhatThePenSays) {
  const double height = ReadableHeight(7.4812, 7.4812);
  EXPECT_NEAR(height, 7.4812, 0.1);
  EXPECT_NE(height, 7);
}

TEST(Readable, EqualNumbersStayEqual) {
  const auto facade = tests::Facade();
  const auto action = SplitAction(*grammar::FindOperation("split"), grammar::Axis::kY,
                                  {2.013, 4.974, 2.013}, {0, 1, 0});
  const auto readable = Readable(action, MadeEdges(facade),
                                 Lines({{At(facade, 0, 2.013), At(facade, 16, 2.013)},
                                        {At(facade, 0, 6.987), At(facade, 16, 6.987)}}),
                                 kParameters);
  const auto size = [&](size_t i) {
    return std::get<grammar::Size>(readable.successors[i].key).value;
  };
  EXPECT_EQ(size(0), size(2));
  EXPECT_EQ(size(0), 2);
}

TEST(Readable, AnActionThatMakesNothingComesBackAsItWas) {
  const auto lot = tests::Lot();
  const auto action = ActionOfLength(*grammar::FindOperation("extrude"), 0);
  EXPECT_EQ(
      Readable(action, MadeEdges(lot), Lines({{At(lot, 0, 0), At(lot, 0, 0, 3)}}), kParameters),
      action);
}

RC_GTEST_PROP(Readable, NothingMovesFarAndTheEvidenceStays, ()) {
  const double drawn = *rc::gen::inRange(1000, 15000) / 1000.0;
  const double height = ReadableHeight(drawn, drawn);
  RC_ASSERT(std::abs(height - drawn) <= kParameters.ranking.readable_share * drawn + 1e-9);
  const auto lot = tests::Lot();
  const auto edges = MadeEdges(lot).Of(ActionOfLength(*grammar::FindOperation("extrude"), height));
  RC_ASSERT(edges);
  const Match match = MatchLines(Lines({{At(lot, 20, 0), At(lot, 20, 0, drawn)}}), *edges,
                                 kParameters.descent.outlier_deviations);
  RC_ASSERT(match.error / 2 <= kParameters.ranking.readable_loss + 1e-9);
}

}  // namespace
}  // namespace parti::sketch
