// Lines that are parts of edges, and lines that an operation leaves over: the second reading.
#include <gmock/gmock.h>

#include "grammar/operation.h"
#include "sketch/suggestion.h"
#include "tests/sketch/sketch_scene.h"

namespace parti::sketch {
namespace {

using grammar::Axis;
using tests::At;
using tests::Draw;
using Corners = std::vector<Vec3>;

constexpr double kShaky_px = 2.5;

std::vector<Camera> Cameras() {
  std::vector<Camera> cameras = {tests::HouseCamera(), tests::HouseCamera(), tests::HouseCamera()};
  cameras[1].eye = Vec3(-18, 6, 30);
  cameras[2].eye = Vec3(2, 8, 34);
  return cameras;
}

struct Drawn {
  grammar::Item item;
  std::vector<Corners> strokes;
};

std::vector<Suggestion> SuggestedFor(const Drawn& drawn, const Camera& camera) {
  std::vector<Stroke> strokes;
  for (const Corners& corners : drawn.strokes) {
    strokes.push_back(Draw(corners, camera, kShaky_px, strokes.size() + 1));
  }
  const auto found = SuggestFromStrokes(strokes, drawn.item, camera);
  EXPECT_TRUE(found.has_value()) << (found ? "" : found.error().message);
  return found.value_or(std::vector<Suggestion>{});
}

// Ends of the parts of a split along its axis, the item's own ends left out.
std::vector<double> CutsOf(const grammar::Action& action, const grammar::Item& item, Axis axis) {
  std::vector<double> cuts;
  if (action.operation->name != "split" || std::get<Axis>(action.arguments[0]) != axis) return cuts;
  double at = 0;
  const auto parts = grammar::Apply(action, item).value();
  for (const grammar::Product& part : parts) {
    if (at > 0) cuts.push_back(at);
    at += part.item.scope.size[static_cast<int>(axis)];
  }
  return cuts;
}

void ExpectCuts(const Drawn& drawn, Axis axis, const std::vector<double>& cuts) {
  for (const Camera& camera : Cameras()) {
    const auto best = SuggestedFor(drawn, camera);
    ASSERT_FALSE(best.empty());
    EXPECT_THAT(CutsOf(best[0].action, drawn.item, axis),
                ::testing::Pointwise(::testing::DoubleNear(0.3), cuts))
        << grammar::TextOf(best[0].action);
  }
}

TEST(PartlyDrawn, ALineFromInsideAFaceToItsEdgeCutsThere) {
  const auto facade = tests::Facade();
  ExpectCuts({facade, {{At(facade, 6, 4), At(facade, 6, 9)}}}, Axis::kX, {6});
  ExpectCuts({facade, {{At(facade, 6, 4), At(facade, 6, 0)}}}, Axis::kX, {6});
  ExpectCuts({facade, {{At(facade, 16, 3), At(facade, 7, 3)}}}, Axis::kY, {3});
}

TEST(PartlyDrawn, ALineWithinALotCutsThere) {
  const auto lot = tests::Lot();
  ExpectCuts({lot, {{At(lot, 13, 12), At(lot, 13, 5)}}}, Axis::kX, {13});
}

TEST(PartlyDrawn, ADoorCutsAtItsJambs) {
  const auto facade = tests::Facade();
  ExpectCuts({facade, {{At(facade, 7, 0), At(facade, 7, 3), At(facade, 9, 3), At(facade, 9, 0)}}},
             Axis::kX, {7, 9});
}

TEST(PartlyDrawn, ShortColumnsCutAtTheirSides) {
  const auto facade = tests::Facade();
  Drawn columns{facade, {}};
  for (const double x : {5.0, 6.0, 10.0, 11.0}) {
    columns.strokes.push_back({At(facade, x, 0), At(facade, x, 6)});
  }
  ExpectCuts(columns, Axis::kX, {5, 6, 10, 11});
}

TEST(PartlyDrawn, AWindowIsOfferedBySidesAndByTopAndBottom) {
  const auto facade = tests::Facade();
  const Drawn window{
      facade,
      {{At(facade, 3, 4), At(facade, 6, 4), At(facade, 6, 7), At(facade, 3, 7), At(facade, 3, 4)}}};
  for (const Camera& camera : Cameras()) {
    const auto best = SuggestedFor(window, camera);
    ASSERT_GE(best.size(), 2u);
    int across = 0, upright = 0;
    for (size_t i = 0; i < std::min<size_t>(best.size(), 3); ++i) {
      across += CutsOf(best[i].action, facade, Axis::kX).size() == 2 ? 1 : 0;
      upright += CutsOf(best[i].action, facade, Axis::kY).size() == 2 ? 1 : 0;
    }
    EXPECT_EQ(across, 1);
    EXPECT_EQ(upright, 1);
  }
}

TEST(PartlyDrawn, AShortLineAroundACornerCutsTheWholeVolume) {
  const auto box = tests::Box();
  ExpectCuts({box, {{Vec3(6, 3, 8), Vec3(10, 3, 8), Vec3(10, 3, 4)}}}, Axis::kY, {3});
}

TEST(PartlyDrawn, AGableOverWallsIsLeftOverForTheRoof) {
  const auto lot = tests::Lot();
  const Drawn front{
      lot,
      {{At(lot, 0, 0), At(lot, 0, 0, 6), At(lot, 10, 0, 10), At(lot, 20, 0, 6), At(lot, 20, 0)}}};
  for (const Camera& camera : Cameras()) {
    const auto best = SuggestedFor(front, camera);
    ASSERT_FALSE(best.empty());
    EXPECT_EQ(best[0].action.operation->name, "extrude");
    EXPECT_NEAR(std::get<double>(best[0].action.arguments[0]), 6, 0.5);
  }
}

TEST(PartlyDrawn, ALineInTheAirIsNoPartOfAnything) {
  const auto lot = tests::Lot();
  const auto stroke = Draw({At(lot, 8, 2, 7), At(lot, 11, 3, 7.6)}, tests::HouseCamera());
  const auto found = SuggestFromStrokes({stroke}, lot, tests::HouseCamera());
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kNoFit);
}

TEST(PartlyDrawn, WhatWholeEdgesExplainIsReadOnce) {
  const auto facade = tests::Facade();
  const Camera camera = tests::HouseCamera();
  const auto strokes =
      ReadStrokes({Draw({At(facade, 0, 3), At(facade, 16, 3)}, camera, kShaky_px)}).value();
  const auto first = ReadSketch(strokes, facade, camera);
  ASSERT_TRUE(first);
  EXPECT_TRUE(ExplainsAll(*first));
  const auto generous = ReadSketch(strokes, facade, camera, Generous({}));
  ASSERT_TRUE(generous);
  EXPECT_EQ(generous->suggestions.front().action, first->suggestions.front().action);
}

TEST(PartlyDrawn, ASlipOfThePenIsNoLineToExplain) {
  SketchReading reading;
  reading.configuration = tests::Drawn({{Vec3(0, 0, 0), Vec3(5, 0, 0)}}, tests::HouseCamera());
  reading.suggestions.emplace_back();
  EXPECT_TRUE(ExplainsAll(reading));
  reading.lost_px = 5;
  EXPECT_TRUE(ExplainsAll(reading));
  reading.lost_px = 500;
  EXPECT_FALSE(ExplainsAll(reading));
  reading.lost_px = 0;
  reading.suggestions.front().worst_line = 15;
  EXPECT_FALSE(ExplainsAll(reading));
}

}  // namespace
}  // namespace parti::sketch
