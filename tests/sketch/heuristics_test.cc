// The rules of 6.5.1 to 6.5.4 on lines given in the world: what each accepts and refuses.
#include "sketch/heuristics.h"

#include <gmock/gmock.h>

#include "grammar/operation.h"
#include "tests/sketch/sketch_scene.h"

namespace parti::sketch {
namespace {

using grammar::Axis;
using ::testing::IsEmpty;
using ::testing::Not;
using tests::At;
using tests::Drawn;

double Distance(const Hypothesis& h) { return std::get<double>(h.action.arguments[0]); }

std::vector<Hypothesis> Named(std::string_view name, std::vector<Hypothesis> all) {
  std::erase_if(all, [&](const Hypothesis& h) { return h.action.operation->name != name; });
  return all;
}

Configuration OnLot(const std::vector<Segment3>& lines) {
  return Drawn(lines, tests::HouseCamera());
}

TEST(ExtrudeHeuristic, ReadsARiserFromACorner) {
  const auto lot = tests::Lot();
  const auto found = ExtrudeHeuristic(OnLot({{At(lot, 20, 0), At(lot, 20, 0, 7)}}), lot);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(Distance(found[0]), 7, 1e-9);
}

TEST(ExtrudeHeuristic, TakesTheMeanOfRisersAndParallels) {
  const auto lot = tests::Lot();
  const auto found = ExtrudeHeuristic(
      OnLot({{At(lot, 20, 0), At(lot, 20, 0, 7)}, {At(lot, 0, 0, 7.6), At(lot, 20, 0, 7.6)}}), lot);
  ASSERT_THAT(found, Not(IsEmpty()));
  EXPECT_NEAR(Distance(found[0]), 7.3, 1e-9);
}

TEST(ExtrudeHeuristic, ReadsALineIntoTheItemAsNegativeAndRarer) {
  const auto lot = tests::Lot();
  const auto found = ExtrudeHeuristic(OnLot({{At(lot, 0, 0, -4), At(lot, 0, 0)}}), lot);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(Distance(found[0]), -4, 1e-9);
  EXPECT_GT(found[0].price, 0);
}

TEST(ExtrudeHeuristic, RefusesRisersAwayFromCornersSlantedAndInPlaneLines) {
  const auto lot = tests::Lot();
  EXPECT_THAT(ExtrudeHeuristic(OnLot({{At(lot, 10, 6), At(lot, 10, 6, 7)}}), lot), IsEmpty());
  EXPECT_THAT(ExtrudeHeuristic(OnLot({{At(lot, 0, 0), At(lot, 5, 5, 7)}}), lot), IsEmpty());
  EXPECT_THAT(ExtrudeHeuristic(OnLot({{At(lot, 5, 0), At(lot, 5, 12)}}), lot), IsEmpty());
}

TEST(ExtrudeHeuristic, RefusesAllWhenOneLineIsOff) {
  const auto lot = tests::Lot();
  EXPECT_THAT(
      ExtrudeHeuristic(
          OnLot({{At(lot, 0, 0), At(lot, 0, 0, 7)}, {At(lot, 10, 6), At(lot, 10, 6, 7)}}), lot),
      IsEmpty());
}

TEST(OffsetHeuristic, ReadsAConcentricRectangle) {
  const auto lot = tests::Lot();
  const auto found = OffsetHeuristic(OnLot({{At(lot, 2, 2), At(lot, 18, 2)},
                                            {At(lot, 18, 10), At(lot, 18, 2)},
                                            {At(lot, 18, 10), At(lot, 2, 10)},
                                            {At(lot, 2, 10), At(lot, 2, 2)}}),
                                     lot);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(Distance(found[0]), -2, 1e-9);  // CGA: negative is inward
}

TEST(OffsetHeuristic, ReadsALineAlongABisector) {
  const auto lot = tests::Lot();
  const auto found = OffsetHeuristic(OnLot({{At(lot, 0, 0), At(lot, 2.5, 2.5)}}), lot);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(Distance(found[0]), -2.5, 1e-9);
}

TEST(OffsetHeuristic, ReadsALineOutsideAsOutwardAndRarer) {
  const auto lot = tests::Lot();
  const auto found = OffsetHeuristic(OnLot({{At(lot, -3, -3), At(lot, 23, -3)}}), lot);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(Distance(found[0]), 3, 1e-9);
  EXPECT_GT(found[0].price, 0);
}

TEST(OffsetHeuristic, RefusesParallelsThatEndOffTheBisectorsAndLinesAboveThePlane) {
  const auto lot = tests::Lot();
  EXPECT_THAT(OffsetHeuristic(OnLot({{At(lot, 8, 2), At(lot, 12, 2)}}), lot), IsEmpty());
  EXPECT_THAT(OffsetHeuristic(OnLot({{At(lot, 0, 6), At(lot, 20, 6)}}), lot), IsEmpty());
  EXPECT_THAT(OffsetHeuristic(OnLot({{At(lot, 2, 2, 5), At(lot, 18, 2, 5)}}), lot), IsEmpty());
}

TEST(SplitHeuristic, ReadsTheAxisAndTheSizes) {
  const auto facade = tests::Facade();
  const auto found =
      Named("split", SplitHeuristic(OnLot({{At(facade, 0, 3), At(facade, 16, 3)}}), facade));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(std::get<Axis>(found[0].action.arguments[0]), Axis::kY);
  ASSERT_EQ(found[0].action.successors.size(), 2u);
  EXPECT_EQ(std::get<grammar::Size>(found[0].action.successors[0].key),
            (grammar::Size{grammar::Size::Kind::kAbsolute, 3}));
  EXPECT_EQ(std::get<grammar::Size>(found[0].action.successors[1].key),
            (grammar::Size{grammar::Size::Kind::kFloating, 1}));
}

TEST(SplitHeuristic, TiesSizesThatAreNearlyEqual) {
  const auto facade = tests::Facade();
  const auto found = Named("split", SplitHeuristic(OnLot({{At(facade, 4.1, 0), At(facade, 4.1, 9)},
                                                          {At(facade, 12, 0), At(facade, 12, 9)}}),
                                                   facade));
  ASSERT_EQ(found.size(), 2u);  // all free, and tied
  EXPECT_THAT(found[0].equal, IsEmpty());
  EXPECT_THAT(found[1].equal, ::testing::ElementsAre(::testing::ElementsAre(0, 2)));
  const auto& sizes = found[1].action.successors;
  EXPECT_EQ(sizes[0].key, sizes[2].key);
  EXPECT_NEAR(std::get<grammar::Size>(sizes[0].key).value, 4.05, 1e-9);
}

TEST(SplitHeuristic, OffersARepeatForEvenSpacing) {
  const auto facade = tests::Facade();
  const auto found = SplitHeuristic(OnLot({{At(facade, 4, 0), At(facade, 4, 9)},
                                           {At(facade, 8.2, 0), At(facade, 8.2, 9)},
                                           {At(facade, 11.9, 9), At(facade, 11.9, 0)}}),
                                    facade);
  const auto repeats = Named("repeat", found);
  ASSERT_EQ(repeats.size(), 1u);
  EXPECT_NEAR(std::get<grammar::Size>(repeats[0].action.successors[0].key).value, 4, 1e-9);
  EXPECT_THAT(Named("split", found), Not(IsEmpty()));
}

TEST(SplitHeuristic, NoRepeatForUnevenSpacing) {
  const auto facade = tests::Facade();
  const auto found = SplitHeuristic(
      OnLot({{At(facade, 2, 0), At(facade, 2, 9)}, {At(facade, 7, 0), At(facade, 7, 9)}}), facade);
  EXPECT_THAT(Named("repeat", found), IsEmpty());
  EXPECT_THAT(Named("split", found), Not(IsEmpty()));
}

TEST(SplitHeuristic, LinesOnTwoFacesOfAVolumeAreOnePlane) {
  const auto box = tests::Box();
  const auto found = Named(
      "split",
      SplitHeuristic(OnLot({{Vec3(0, 2, 8), Vec3(10, 2, 8)}, {Vec3(10, 2.1, 8), Vec3(10, 2.1, 0)}}),
                     box));
  ASSERT_THAT(found, Not(IsEmpty()));
  EXPECT_EQ(std::get<Axis>(found[0].action.arguments[0]), Axis::kY);
  ASSERT_EQ(found[0].action.successors.size(), 2u);
  EXPECT_NEAR(std::get<grammar::Size>(found[0].action.successors[0].key).value, 2.05, 1e-9);
}

TEST(SplitHeuristic, RefusesLinesOnTheOutlineSlantedOnesAndMixedAxes) {
  const auto facade = tests::Facade();
  EXPECT_THAT(SplitHeuristic(OnLot({{At(facade, 0, 0), At(facade, 16, 0)}}), facade), IsEmpty());
  EXPECT_THAT(SplitHeuristic(OnLot({{At(facade, 0, 0), At(facade, 16, 9)}}), facade), IsEmpty());
  EXPECT_THAT(SplitHeuristic(OnLot({{At(facade, 0, 3), At(facade, 16, 3)},
                                    {At(facade, 5, 0), At(facade, 5, 9)}}),
                             facade),
              IsEmpty());
}

TEST(CompHeuristic, ReadsEdgesOfTheVolumeTwice) {
  const auto found = CompHeuristic(
      OnLot({{Vec3(0, 6, 8), Vec3(10, 6, 8)}, {Vec3(10, 6, 0), Vec3(10, 6, 8)}}), tests::Box());
  ASSERT_EQ(found.size(), 2u);  // errata 23
  EXPECT_EQ(found[0].action.successors.size(), 2u);
  EXPECT_EQ(found[1].action.successors.size(), 1u);
}

TEST(CompHeuristic, RefusesLinesThatAreNoEdgesAndPlanarItems) {
  EXPECT_THAT(
      CompHeuristic(OnLot({{Vec3(0, 6, 8), Vec3(10, 6, 8)}, {Vec3(0, 3, 8), Vec3(10, 3, 8)}}),
                    tests::Box()),
      IsEmpty());
  const auto lot = tests::Lot();
  EXPECT_THAT(CompHeuristic(OnLot({{At(lot, 0, 0), At(lot, 20, 0)}}), lot), IsEmpty());
}

TEST(Heuristics, SpeakForTheFiveOperationsOfTheThesis) {
  for (const auto name : {"extrude", "offset", "split", "repeat", "comp"}) {
    EXPECT_TRUE(HasHeuristic(name)) << name;
    EXPECT_NE(grammar::FindOperation(name), nullptr) << name;
  }
  EXPECT_FALSE(HasHeuristic("tag"));
}

}  // namespace
}  // namespace parti::sketch
