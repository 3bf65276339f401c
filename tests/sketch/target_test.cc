// Which shape a sketch is drawn on, on a house as it grows.
#include "sketch/target.h"

#include <gmock/gmock.h>

#include "grammar/operation.h"
#include "tests/sketch/sketch_scene.h"

namespace parti::sketch {
namespace {

using tests::At;
using tests::Draw;
using tests::Face;

constexpr double kShaky_px = 2.5;

// A house of 20 x 12 x 9 m taken apart into its visible faces; beside it a lot.
struct House {
  grammar::Item south = Face({-10, 0, 6}, {1, 0, 0}, {0, 0, 1}, 20, 9);
  grammar::Item east = Face({10, 0, 6}, {0, 0, -1}, {1, 0, 0}, 12, 9);
  grammar::Item north = Face({10, 0, -6}, {-1, 0, 0}, {0, 0, -1}, 20, 9);
  grammar::Item west = Face({-10, 0, -6}, {0, 0, 1}, {-1, 0, 0}, 12, 9);
  grammar::Item roof = Face({-10, 9, 6}, {1, 0, 0}, {0, 1, 0}, 20, 12);
  grammar::Item lot = Face({14, 0, 6}, {1, 0, 0}, {0, 1, 0}, 8, 8);

  std::vector<grammar::Item> Items() const { return {south, east, north, west, roof, lot}; }
};

size_t TargetOf(const std::vector<Stroke>& strokes, const std::vector<grammar::Item>& items) {
  const auto ranked = RankTargets(strokes, tests::HouseCamera(), items);
  EXPECT_TRUE(ranked.has_value()) << (ranked ? "" : ranked.error().message);
  return ranked ? ranked->front().item : items.size();
}

TEST(RankTargets, ALineUpFromALotsCornerMeansTheLot) {
  const House house;
  const auto stroke =
      Draw({At(house.lot, 8, 0), At(house.lot, 8, 0, 5)}, tests::HouseCamera(), kShaky_px);
  EXPECT_EQ(TargetOf({stroke}, house.Items()), 5u);
}

TEST(RankTargets, LinesAcrossAFacadeMeanThatFacade) {
  const House house;
  std::vector<Stroke> strokes;
  for (const double y : {3.0, 6.5}) {
    strokes.push_back(Draw({At(house.south, 0, y), At(house.south, 20, y)}, tests::HouseCamera(),
                           kShaky_px, static_cast<uint64_t>(y)));
  }
  EXPECT_EQ(TargetOf(strokes, house.Items()), 0u);
}

TEST(RankTargets, ALineFromInsideAFacadeToItsEdgeMeansThatFacade) {
  const House house;
  const auto up =
      Draw({At(house.south, 8, 4), At(house.south, 8, 9)}, tests::HouseCamera(), kShaky_px);
  EXPECT_EQ(TargetOf({up}, house.Items()), 0u);
  const auto down =
      Draw({At(house.east, 5, 5), At(house.east, 5, 0)}, tests::HouseCamera(), kShaky_px);
  EXPECT_EQ(TargetOf({down}, house.Items()), 1u);
}

TEST(RankTargets, AGableOverTheEndOfAHouseIsARoofOverItsFlatOne) {
  const House house;
  const auto gable = Draw({At(house.roof, 20, 0), At(house.roof, 20, 6, 4), At(house.roof, 20, 12)},
                          tests::HouseCamera(), kShaky_px);
  const auto ranked = RankTargets({gable}, tests::HouseCamera(), house.Items());
  ASSERT_TRUE(ranked);
  EXPECT_EQ(ranked->front().item, 4u);
  EXPECT_EQ(ranked->front().reading.suggestions.front().action.operation->name, "roofGable");
}

TEST(RankTargets, ADoorOnAFacadeMeansThatFacade) {
  const House house;
  const auto door = Draw({At(house.south, 9, 0), At(house.south, 9, 3), At(house.south, 11, 3),
                          At(house.south, 11, 0)},
                         tests::HouseCamera(), kShaky_px);
  EXPECT_EQ(TargetOf({door}, house.Items()), 0u);
}

TEST(RankTargets, LinesAcrossAFacadeMeanTheFacadeNotItsParent) {
  const House house;
  grammar::Item mass;
  mass.type = grammar::ItemType::kVolume;
  mass.scope.origin = Vec3(-10, 0, -6);
  mass.scope.size = Vec3(20, 9, 12);
  std::vector<grammar::Item> items = house.Items();
  items.insert(items.begin(), mass);
  std::vector<Stroke> strokes;
  for (const double y : {3.0, 6.5}) {
    strokes.push_back(Draw({At(house.east, 0, y), At(house.east, 12, y)}, tests::HouseCamera(),
                           kShaky_px, static_cast<uint64_t>(y)));
  }
  EXPECT_EQ(TargetOf(strokes, items), 2u);
}

TEST(RankTargets, ARectangleOnTheRoofMeansTheRoof) {
  const House house;
  const auto stroke = Draw({At(house.roof, 2, 2), At(house.roof, 18, 2), At(house.roof, 18, 10),
                            At(house.roof, 2, 10), At(house.roof, 2, 2)},
                           tests::HouseCamera(), kShaky_px);
  EXPECT_EQ(TargetOf({stroke}, house.Items()), 4u);
}

TEST(RankTargets, ALineUpFromTheInnerRoofMeansTheInnerRoofNotItsBorder) {
  const House house;
  grammar::Action offset = grammar::Default(*grammar::FindOperation("offset"));
  std::get<double>(offset.arguments[0]) = -2;
  grammar::Successor inside, border;
  inside.key = grammar::Selector{grammar::Selector::Kind::kInside};
  border.key = grammar::Selector{grammar::Selector::Kind::kBorder};
  offset.successors = {border, inside};
  const auto products = grammar::Apply(offset, house.roof).value();
  std::vector<grammar::Item> items = house.Items();
  items.erase(items.begin() + 4);
  size_t inner = 0;
  for (const grammar::Product& product : products) {
    if (product.successor == 1) inner = items.size();
    items.push_back(product.item);
  }
  const auto stroke =
      Draw({At(house.roof, 18, 2), At(house.roof, 18, 2, 2.5)}, tests::HouseCamera(), kShaky_px);
  EXPECT_EQ(TargetOf({stroke}, items), inner);
}

TEST(RankTargets, LinesAcrossOneFloorMeanThatFloor) {
  const House house;
  std::vector<grammar::Item> items = {house.east, house.roof};
  for (int floor = 0; floor < 3; ++floor) {
    items.push_back(Face(At(house.south, 0, 3.0 * floor), {1, 0, 0}, {0, 0, 1}, 20, 3));
  }
  std::vector<Stroke> strokes;
  for (int i = 1; i < 5; ++i) {
    strokes.push_back(Draw({At(house.south, 4.0 * i, 3), At(house.south, 4.0 * i, 6)},
                           tests::HouseCamera(), kShaky_px, static_cast<uint64_t>(i)));
  }
  EXPECT_EQ(TargetOf(strokes, items), 3u);
}

TEST(RankTargets, WhatIsHiddenIsNotMeant) {
  const House house;
  // The north face and a lot behind the house can't be seen; lines over the south face could be on
  // them all the same.
  std::vector<Stroke> strokes = {
      Draw({At(house.south, 0, 4), At(house.south, 20, 4)}, tests::HouseCamera(), 0)};
  const auto ranked = RankTargets(strokes, tests::HouseCamera(), house.Items());
  ASSERT_TRUE(ranked);
  for (const RankedTarget& target : *ranked) EXPECT_NE(target.item, 2u);
}

TEST(RankTargets, ErrorsSayWhatIsMissing) {
  const House house;
  const std::vector<grammar::Item> items = house.Items();
  EXPECT_EQ(RankTargets({StrokeFrom("5,5")}, tests::HouseCamera(), items).error().code,
            ErrorCode::kTooShort);
  EXPECT_EQ(RankTargets({StrokeFrom("1,1 9,2 30,3")}, tests::HouseCamera(), items).error().code,
            ErrorCode::kNoFit);
  EXPECT_EQ(RankTargets({StrokeFrom("1,1 9,2 30,3")}, tests::HouseCamera(), {}).error().code,
            ErrorCode::kNoFit);
  Camera camera = tests::HouseCamera();
  camera.eye = camera.target;
  EXPECT_EQ(RankTargets({StrokeFrom("1,1 9,2 30,3")}, camera, items).error().code,
            ErrorCode::kBadNumber);
}

}  // namespace
}  // namespace parti::sketch
