// Roofs and wings, drawn over and in shapes that lie: rarer operations, read the second time.
#include <gmock/gmock.h>

#include "grammar/operation.h"
#include "sketch/candidates.h"
#include "sketch/heuristics.h"
#include "sketch/made_edges.h"
#include "sketch/suggestion.h"
#include "tests/sketch/sketch_scene.h"

namespace parti::sketch {
namespace {

using tests::At;
using tests::Draw;
using Corners = std::vector<Vec3>;
using ::testing::DoubleNear;
using ::testing::Pointwise;

constexpr double kShaky_px = 2.5;

std::vector<Camera> Cameras() {
  std::vector<Camera> cameras = {tests::HouseCamera(), tests::HouseCamera(), tests::HouseCamera()};
  cameras[1].eye = Vec3(28, 12, 12);
  cameras[2].eye = Vec3(20, 26, 22);
  return cameras;
}

Result<std::vector<Suggestion>> Suggested(const grammar::Item& item,
                                          const std::vector<Corners>& drawn, const Camera& camera) {
  std::vector<Stroke> strokes;
  for (const Corners& corners : drawn) {
    strokes.push_back(Draw(corners, camera, kShaky_px, strokes.size() + 1));
  }
  return SuggestFromStrokes(strokes, item, camera);
}

// The first suggestion in every view: that operation, with those numbers first.
void ExpectFirst(const grammar::Item& item, const std::vector<Corners>& drawn,
                 std::string_view operation, const std::vector<double>& numbers) {
  for (const Camera& camera : Cameras()) {
    auto found = Suggested(item, drawn, camera);
    ASSERT_TRUE(found) << found.error().message;
    grammar::Action& action = found->front().action;
    EXPECT_EQ(action.operation->name, operation) << grammar::TextOf(action);
    std::vector<double> first;
    for (const grammar::Dial& dial : grammar::Dials(&action)) {
      if (first.size() < numbers.size()) first.push_back(*dial.value);
    }
    EXPECT_THAT(first, Pointwise(DoubleNear(0.5), numbers));
  }
}

TEST(Roofs, AGableOverAnEndIsAGableRoof) {
  const auto flat = tests::Lot();  // 20 x 12 m: its gables are at the short ends
  const Corners gable = {At(flat, 20, 0), At(flat, 20, 6, 4), At(flat, 20, 12)};
  ExpectFirst(flat, {gable}, "roofGable", {4});
  ExpectFirst(flat, {Corners(gable.rbegin(), gable.rend())}, "roofGable", {4});
  ExpectFirst(flat, {gable, {At(flat, 20, 6, 4), At(flat, 0, 6, 4)}}, "roofGable", {4});
}

TEST(Roofs, HipsAndTheirRidgeAreAHipRoof) {
  const auto flat = tests::Lot();
  ExpectFirst(flat,
              {{At(flat, 0, 0), At(flat, 6, 6, 3)},
               {At(flat, 20, 0), At(flat, 14, 6, 3)},
               {At(flat, 6, 6, 3), At(flat, 14, 6, 3)}},
              "roofHip", {3});
}

TEST(Roofs, LinesToOnePointAreAPyramid) {
  const auto flat = tests::Lot();
  ExpectFirst(flat,
              {{At(flat, 0, 0), At(flat, 10, 6, 5), At(flat, 20, 0)},
               {At(flat, 20, 12), At(flat, 10, 6, 5)}},
              "roofPyramid", {5});
}

TEST(Roofs, StandOnWhatLiesOnly) {
  const auto facade = tests::Facade();
  const Corners gable = {At(facade, 16, 0), At(facade, 16, 4.5, 3), At(facade, 16, 9)};
  for (const Camera& camera : Cameras()) {
    const auto found = Suggested(facade, {gable}, camera);
    if (!found) continue;
    for (const Suggestion& suggestion : *found) {
      EXPECT_FALSE(suggestion.action.operation->name.starts_with("roof"));
    }
  }
}

TEST(Wings, AnElbowIsAnL) {
  const auto lot = tests::Lot();
  const Corners elbow = {At(lot, 8, 12), At(lot, 8, 5), At(lot, 20, 5)};
  ExpectFirst(lot, {elbow}, "shapeL", {5, 8});
  ExpectFirst(lot, {{elbow[0], elbow[1]}, {elbow[2], elbow[1]}}, "shapeL", {5, 8});
}

TEST(Wings, ACourtOpenToTheBackIsAU) {
  const auto lot = tests::Lot();
  ExpectFirst(lot, {{At(lot, 6, 12), At(lot, 6, 4), At(lot, 15, 4), At(lot, 15, 12)}}, "shapeU",
              {4, 5, 6});
}

TEST(Wings, ACourtOutOfTheMiddleIsAnO) {
  const auto lot = tests::Lot();
  ExpectFirst(lot,
              {{At(lot, 9, 5), At(lot, 16, 5), At(lot, 16, 10), At(lot, 9, 10), At(lot, 9, 5)}},
              "shapeO", {5, 4, 2, 9});
}

TEST(Wings, OfOneWidthAreAnOffset) {
  const auto lot = tests::Lot();
  ExpectFirst(lot, {{At(lot, 3, 3), At(lot, 17, 3), At(lot, 17, 9), At(lot, 3, 9), At(lot, 3, 3)}},
              "offset", {-3});
}

TEST(RarerOperations, AreSampledWhenReadingGenerouslyOnly) {
  const auto lot = tests::Lot();
  const View view(tests::HouseCamera());
  const auto rarer = [](const Sample& sample) {
    return HeuristicFor(sample.action.operation->name)->rarer;
  };
  EXPECT_TRUE(std::ranges::none_of(CandidatesOf(lot, view)->samples, rarer));
  CandidateParameters generous;
  generous.generous = true;
  EXPECT_TRUE(std::ranges::any_of(CandidatesOf(lot, view, generous)->samples, rarer));
}

TEST(RarerOperations, HaveTheEdgesThatTheyMakeBetweenSamplesToo) {
  const auto lot = tests::Lot();
  CandidateParameters generous;
  generous.generous = true;
  const auto candidates = CandidatesOf(lot, View(tests::HouseCamera()), generous);
  ASSERT_TRUE(candidates);
  const MadeEdges made(lot);
  for (const Sample& sample : candidates->samples) {
    const auto edges = made.Of(sample.action);
    ASSERT_TRUE(edges);
    ASSERT_EQ(edges->size(), sample.count) << grammar::TextOf(sample.action);
    for (size_t i = 0; i < edges->size(); ++i) {
      const Segment3& known = candidates->edges[sample.first + i];
      EXPECT_LT(glm::distance(known.a, (*edges)[i].a), 1e-6) << grammar::TextOf(sample.action);
      EXPECT_LT(glm::distance(known.b, (*edges)[i].b), 1e-6) << grammar::TextOf(sample.action);
    }
  }
}

}  // namespace
}  // namespace parti::sketch
