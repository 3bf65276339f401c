#include "grammar/query_reading.h"

#include <gtest/gtest.h>

#include "grammar/query_filter.h"

namespace parti::grammar {
namespace {

std::string Reading(std::string_view text) {
  const auto query = ParseQuery(text);
  EXPECT_TRUE(query) << text;
  return query ? ReadingOf(*query) : "";
}

TEST(QueryReadingTest, QueriesAreReadFromWhatTheySelectOutward) {
  EXPECT_EQ(Reading(".Window"), "every Window");
  EXPECT_EQ(Reading(".Floor:even > .Window:north"),
            "every Window facing north in every even Floor");
  EXPECT_EQ(Reading(".Facade / .Ground ~ .Floor"),
            "every Floor beside every Ground directly in every Facade");
}

TEST(QueryReadingTest, PlacesAreCounted) {
  EXPECT_EQ(Reading(".Bay:first"), "every first Bay");
  EXPECT_EQ(Reading(".Bay:nth(2)"), "every 2nd Bay");
  EXPECT_EQ(Reading(".Bay:nth(11)"), "every 11th Bay");
  EXPECT_EQ(Reading(".Bay:nth(23)"), "every 23rd Bay");
  EXPECT_EQ(Reading(".Bay:nth(101,3)"), "every 101st and each 3rd following Bay");
  EXPECT_EQ(Reading(".Bay:ends:up"), "every Bay at either end facing up");
}

TEST(QueryReadingTest, NamelessShapesAreShapes) {
  EXPECT_EQ(Reading("*"), "every shape");
  EXPECT_EQ(Reading("Split:leaf"), "every visible shape made by split");
  EXPECT_EQ(Reading("#wide#red"), "every shape tagged wide and red");
}

TEST(QueryReadingTest, RegionsAndOtherShapesAreNamed) {
  EXPECT_EQ(Reading(".A:inside(sphere(3,1,5,5))"), "every A inside sphere(3, 1, 5, 5)");
  EXPECT_EQ(Reading(".A:intersects((.Road))"), "every A touching every Road");
  EXPECT_EQ(Reading(".A:facing(#Road)"), "every A looking at every shape tagged Road");
  EXPECT_EQ(Reading(".A:within(.Door, 5)"), "every A at most 5 m from every Door");
  EXPECT_EQ(Reading(".A:larger(2.5)"), "every A larger than 2.5 m²");
}

TEST(QueryReadingTest, EveryFilterHasWordsOfItsOwn) {
  std::vector<std::string> readings;
  for (const FilterRow& row : Filters()) {
    Filter filter{std::string(row.name), {}, {}, {}};
    if (row.arguments != FilterArguments::kNone) filter.numbers = {2};
    if (row.arguments == FilterArguments::kVolume || row.arguments == FilterArguments::kQuery ||
        row.arguments == FilterArguments::kQueryAndMetres) {
      filter.queries = {*ParseQuery(".B")};
    }
    QuerySelector selector;
    selector.filters = {filter};
    readings.push_back(ReadingOf(Query{{selector}, {}}));
    EXPECT_NE(readings.back(), "every shape") << row.name;
  }
  std::sort(readings.begin(), readings.end());
  EXPECT_EQ(std::unique(readings.begin(), readings.end()), readings.end());
}

}  // namespace
}  // namespace parti::grammar
