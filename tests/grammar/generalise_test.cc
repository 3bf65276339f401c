#include "grammar/generalise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.h"
#include "tests/grammar/derived.h"

namespace parti::grammar {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;

/// Four façades of a house: a ground floor with doors, and floors with windows.
constexpr std::string_view kHouse = R"(
  .Lot --> extrude(19) Mass
  .Mass --> comp(f) { side: Facade | top: Roof }
  .Facade --> split(y) { 4: Ground | { 3: Floor }* }
  .Ground --> split(x) { { ~5: Door }* }
  .Floor --> split(x) { { ~2: Tile }* }
  .Tile --> offset(-0.2) { inside: Glass | border: Frame }
)";

class GeneraliseTest : public ::testing::Test {
 protected:
  std::vector<QueryCandidate> Offered(const std::vector<std::string>& ids) const {
    std::vector<TappedShape> tapped;
    for (const std::string& id : ids) tapped.push_back({0, *tree().AtId(id)});
    return Generalise(trees_, tapped);
  }
  std::vector<std::string> OfferedTexts(const std::vector<std::string>& ids) const {
    std::vector<std::string> texts;
    for (const QueryCandidate& c : Offered(ids)) texts.push_back(TextOf(c.query));
    return texts;
  }
  /// The ids of the shapes that a query selects.
  std::string IdOf(std::string_view query, size_t number) const {
    const auto product = ProductOf(*ParseQuery(query), tree());
    return tree().IdOf(product->at(number));
  }
  const ShapeTree& tree() const { return house_.tree; }

  const Derivation house_ = Derived(kHouse);
  const std::vector<const ShapeTree*> trees_ = {&house_.tree};
};

TEST_F(GeneraliseTest, OneTapOffersItsKindItsSideItsRowItsColumnAndItselfAlone) {
  const std::string window = IdOf(".Facade:south > .Floor:nth(2) > .Tile:nth(4) > .Glass", 0);
  const auto texts = OfferedTexts({window});
  EXPECT_EQ(texts.at(0), ".Glass");
  EXPECT_EQ(texts.at(1), ".Glass:south");
  EXPECT_THAT(texts, Contains(".Floor:even > .Glass"));
  EXPECT_THAT(texts, Contains(".Tile:nth(4) > .Glass"));
  EXPECT_THAT(texts, Contains(".Floor:nth(2) > .Glass"));
  const auto offered = Offered({window});
  EXPECT_TRUE(std::any_of(offered.begin(), offered.end(), [](const QueryCandidate& c) {
    return c.count == 1;
  })) << "this one only";
}

TEST_F(GeneraliseTest, TwoWindowsOnEvenFloorsOfOneSideMeanEvenFloorsOfThatSide) {
  const auto offered = Offered({IdOf(".Facade:north > .Floor:nth(2) > .Tile:nth(1) > .Glass", 0),
                                IdOf(".Facade:north > .Floor:nth(2) > .Tile:nth(4) > .Glass", 0),
                                IdOf(".Facade:north > .Floor:nth(2) > .Tile:nth(9) > .Glass", 0)});
  ASSERT_THAT(offered, Not(IsEmpty()));
  EXPECT_EQ(TextOf(offered[0].query), ".Floor:nth(2) > .Glass:north");
  EXPECT_EQ(offered[0].reading, "every Glass facing north in every 2nd Floor");
  EXPECT_EQ(offered[0].count, 10u);
}

TEST_F(GeneraliseTest, AColumnIsTheSamePlaceOnEveryFloor) {
  const auto texts = OfferedTexts({IdOf(".Facade:east > .Floor:nth(1) > .Tile:nth(3)", 0),
                                   IdOf(".Facade:east > .Floor:nth(3) > .Tile:nth(3)", 0)});
  EXPECT_EQ(texts.at(0), ".Tile:nth(3):east");
}

TEST_F(GeneraliseTest, EveryThirdOfARowIsSeen) {
  const std::string floor = ".Facade:south > .Floor:first > ";
  EXPECT_THAT(OfferedTexts({IdOf(floor + ".Tile:nth(2)", 0), IdOf(floor + ".Tile:nth(5)", 0),
                            IdOf(floor + ".Tile:nth(8)", 0)}),
              Contains(".Floor:first > .Tile:nth(2, 3)"));
}

TEST_F(GeneraliseTest, DifferentKindsShareAnOperationOrASide) {
  const auto texts = OfferedTexts({IdOf(".Door:south", 0), IdOf(".Tile:south", 3)});
  EXPECT_THAT(texts, Contains("Split"));
  EXPECT_THAT(texts, Contains("Split:south"));
}

TEST_F(GeneraliseTest, ShapesWithNothingInCommonAreAllThatIsVisible) {
  const auto texts = OfferedTexts({IdOf(".Roof", 0), IdOf(".Glass:south", 3)});
  EXPECT_THAT(texts, ::testing::ElementsAre(":leaf"));
}

TEST_F(GeneraliseTest, TheLotItselfIsMeantByItsName) {
  EXPECT_THAT(OfferedTexts({"."}), Contains(".Lot"));
}

TEST_F(GeneraliseTest, NothingTappedOffersNothing) { EXPECT_THAT(Offered({}), IsEmpty()); }

TEST_F(GeneraliseTest, EveryCandidateSelectsAllThatWasTappedAndNoTwoTheSame) {
  Random random(7);
  for (int round = 0; round < 60; ++round) {
    std::vector<TappedShape> tapped;
    for (int i = 0; i <= round % 4; ++i) {
      tapped.push_back({0, static_cast<ShapeIndex>(random.Next() % tree().size())});
    }
    const auto offered = Generalise(trees_, tapped);
    ASSERT_THAT(offered, Not(IsEmpty())) << round;
    std::vector<std::vector<ShapeIndex>> products;
    for (const QueryCandidate& c : offered) {
      products.push_back(*ProductOf(c.query, tree()));
      for (const TappedShape& t : tapped) {
        EXPECT_THAT(products.back(), Contains(t.shape)) << TextOf(c.query);  // (1)
      }
      EXPECT_EQ(c.count, products.back().size()) << TextOf(c.query);                // (2)
      EXPECT_EQ(std::count(products.begin(), products.end(), products.back()), 1);  // once
      EXPECT_EQ(*ParseQuery(TextOf(c.query)), c.query) << "it can be kept in a document";
    }
    std::reverse(tapped.begin(), tapped.end());
    const auto reversed = Generalise(trees_, tapped);  // (3)
    ASSERT_EQ(reversed.size(), offered.size());
    for (size_t i = 0; i < offered.size(); ++i) EXPECT_EQ(reversed[i].query, offered[i].query);
  }
}

TEST_F(GeneraliseTest, CandidatesComeCheapestFirstAndNoMoreThanAsked) {
  GeneraliseParameters few;
  few.most = 3;
  const TappedShape window{0, *tree().AtId(IdOf(".Glass", 5))};
  const auto offered = Generalise(trees_, std::vector{window}, few);
  ASSERT_EQ(offered.size(), 3u);
  EXPECT_LE(offered[0].cost, offered[1].cost);
  EXPECT_LE(offered[1].cost, offered[2].cost);
}

TEST_F(GeneraliseTest, TapsOnTwoLotsAreAnsweredForBoth) {
  const std::vector<const ShapeTree*> two = {&house_.tree, &house_.tree};
  const ShapeIndex door = *tree().AtId(IdOf(".Door:west", 0));
  const auto offered = Generalise(two, std::vector<TappedShape>{{0, door}, {1, door}});
  ASSERT_THAT(offered, Not(IsEmpty()));
  for (const QueryCandidate& c : offered) {
    EXPECT_EQ(c.count, 2 * ProductOf(c.query, tree())->size()) << TextOf(c.query);
  }
}

}  // namespace
}  // namespace parti::grammar
