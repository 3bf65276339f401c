#include "sketch/candidates.h"

#include <gmock/gmock.h>

#include <set>

#include "grammar/operation.h"
#include "sketch/heuristic_geometry.h"
#include "sketch/heuristics.h"
#include "sketch/lift.h"
#include "sketch/score.h"
#include "tests/sketch/sketch_scene.h"

namespace parti::sketch {
namespace {

using tests::At;

TEST(SampleLengths, LieNoFurtherApartThanTheSpacingAndReachAcrossThePicture) {
  const View view(tests::HouseCamera());
  CandidateParameters parameters;
  parameters.spacing_px = 20;
  parameters.most_lengths = 1000;
  const auto lengths = SampleLengths(tests::Lot(), view, parameters);
  ASSERT_TRUE(lengths);
  double px_per_m = 0, depth = 0;
  for (const Segment3& edge : grammar::EdgesOf(tests::Lot())) {
    px_per_m = std::max(px_per_m, view.PixelsPerMetre(edge.a));
    depth = std::max(depth, view.Depth(edge.a));
  }
  for (size_t i = 1; i < lengths->size(); ++i) {
    EXPECT_LE(((*lengths)[i] - (*lengths)[i - 1]) * px_per_m, 20 + 1e-9);
  }
  const double sigma = std::tan(Angle::Degrees(22.5).radians()) * depth;  // (6.10)
  EXPECT_NEAR(lengths->back(), 2 * sigma, 0.05 * sigma);
}

TEST(SampleLengths, RefuseAnItemBehindTheEye) {
  Camera camera = tests::HouseCamera();
  camera.target = camera.eye + (camera.eye - camera.target);
  const auto lengths = SampleLengths(tests::Lot(), View(camera));
  ASSERT_FALSE(lengths);
  EXPECT_EQ(lengths.error().code, ErrorCode::kBehindEye);
}

TEST(CandidatesOf, EveryOperationThatTakesTheItemTakesPart) {
  CandidateParameters generous;
  generous.generous = true;
  for (const grammar::Item& item : {tests::Lot(), tests::Facade(), tests::Box()}) {
    const auto candidates = CandidatesOf(item, View(tests::HouseCamera()), generous);
    ASSERT_TRUE(candidates);
    std::set<std::string_view> names;
    for (const Sample& sample : candidates->samples) names.insert(sample.action.operation->name);
    for (const grammar::Operation& row : grammar::Operations()) {
      // What has one face is taken apart into itself.
      const bool whole = row.name == "comp" && item.type != grammar::ItemType::kVolume;
      // Roofs stand on what lies.
      const bool rarer = HasHeuristic(row.name) && HeuristicFor(row.name)->rarer;
      const bool takes = (row.takes & grammar::Types(item.type)) != 0 && !row.in_place &&
                         row.sampled && !whole && (!rarer || LooksUp(item));
      EXPECT_EQ(names.count(row.name) == 1, takes) << row.name;
    }
  }
}

TEST(CandidatesOf, FamiliesAreRunsOfGrowingLengthWithTheSameWords) {
  const auto candidates = CandidatesOf(tests::Facade(), View(tests::HouseCamera()));
  ASSERT_TRUE(candidates);
  for (size_t i = 1; i < candidates->samples.size(); ++i) {
    const Sample& last = candidates->samples[i - 1];
    const Sample& next = candidates->samples[i];
    EXPECT_EQ(next.first, last.first + last.count);
    EXPECT_LE(last.family, next.family);
    if (last.family != next.family) continue;
    grammar::Action a = last.action, b = next.action;
    EXPECT_LT(std::abs(*grammar::Dials(&a)[0].value), std::abs(*grammar::Dials(&b)[0].value));
  }
}

class LiftTest : public ::testing::Test {
 protected:
  const Camera camera_ = tests::HouseCamera();
  const View view_{camera_};
  const grammar::Item lot_ = tests::Lot();
  const Candidates candidates_ = CandidatesOf(lot_, view_).value();
};

TEST_F(LiftTest, FindsTheRiserAndMovesItToTheDrawnLength) {
  const Segment3 riser{At(lot_, 20, 0), At(lot_, 20, 0, 6.37)};
  const auto line = Lift(view_.Project(riser).value(), candidates_, camera_);
  ASSERT_TRUE(line);
  const double top = std::max(line->world.a.y, line->world.b.y);
  EXPECT_NEAR(top, 6.37, 0.02);  // the samples lie about 0.5 m apart
  EXPECT_GT(line->fitness, 0.99);
}

TEST_F(LiftTest, ProjectionOfTheLiftedLineLiesNearTheDrawnOne) {  // property 1
  const LiftParameters parameters;
  for (const double height : {-5.0, 2.2, 4.9, 9.1}) {
    for (int corner = 0; corner < 4; ++corner) {
      const double x = corner == 1 || corner == 2 ? 20 : 0, y = corner >= 2 ? 12 : 0;
      const auto drawn = view_.Project(Segment3{At(lot_, x, y), At(lot_, x, y, height)}).value();
      const auto line = Lift(drawn, candidates_, camera_, parameters);
      ASSERT_TRUE(line);
      const auto back = view_.Project(line->world);
      ASSERT_TRUE(back);
      EXPECT_LT(std::sqrt(SquaredEndDistance(drawn, *back)), 3);
      // Reversing the line lifts the same one (property 2).
      const auto reversed = Lift({drawn.b, drawn.a}, candidates_, camera_, parameters);
      ASSERT_TRUE(reversed);
      EXPECT_EQ(reversed->world.a, line->world.a);
      EXPECT_EQ(reversed->world.b, line->world.b);
    }
  }
}

TEST_F(LiftTest, KeepsReadingsOfSeveralOperationsApart) {
  const auto drawn = view_.Project(Segment3{At(lot_, 2, 2), At(lot_, 18, 2)}).value();
  const auto line = Lift(drawn, candidates_, camera_);
  ASSERT_TRUE(line);
  std::set<std::string_view> operations;
  for (const LiftCandidate& c : line->alternatives) operations.insert(c.operation->name);
  EXPECT_TRUE(operations.count("offset"));
  EXPECT_TRUE(std::is_sorted(
      line->alternatives.begin(), line->alternatives.end(),
      [](const LiftCandidate& a, const LiftCandidate& b) { return a.fitness > b.fitness; }));
}

TEST_F(LiftTest, RefusesALineFarFromEverything) {
  const auto line = Lift({{5, 5}, {60, 9}}, candidates_, camera_);
  ASSERT_FALSE(line);
  EXPECT_EQ(line.error().code, ErrorCode::kNoFit);
  EXPECT_FALSE(line.error().hint.empty());
}

}  // namespace
}  // namespace parti::sketch
