#include "app/query_preview.h"

#include <gtest/gtest.h>

#include "tests/app/panels_driver.h"

namespace parti::app::tests {
namespace {

TEST(QueryPreviewTest, AllThatAQuerySelectsIsOutlined) {
  const auto state = HouseWithTaps(1)->state;
  ASSERT_FALSE(state->selection.candidates.empty());
  const auto& first = state->selection.candidates[0];
  const WorldMarks marks = OutlinesOf({state, first.query});
  EXPECT_GE(marks.segments.size(), 4 * first.count) << "a rectangle each, at least";
  EXPECT_TRUE(OutlinesOf({state, *grammar::ParseQuery(".Nothing")}).segments.empty());
}

TEST(QueryPreviewTest, WhatIsNotHoveredAnyMoreIsNotShown) {
  const auto state = HouseWithTaps(1)->state;
  QueryPreviews previews;
  const grammar::Query glass = *grammar::ParseQuery(".Glass");
  EXPECT_TRUE(previews.Set(glass, state));
  EXPECT_FALSE(previews.Set(glass, state));
  while (previews.busy()) std::this_thread::yield();
  ASSERT_NE(previews.marks(), nullptr);
  EXPECT_TRUE(previews.Set(std::nullopt, state));
  EXPECT_EQ(previews.marks(), nullptr);
}

TEST(QueryPreviewTest, WhatIsDrawnOnTheSameModelKeepsTheOutlines) {
  const auto state = HouseWithTaps(1)->state;
  const grammar::Query glass = *grammar::ParseQuery(".Glass");
  QueryPreviews previews;
  EXPECT_TRUE(previews.Set(glass, state));
  while (previews.busy()) std::this_thread::yield();
  auto drawn = std::make_shared<SessionState>(*state);
  drawn->selection = {};
  EXPECT_FALSE(previews.Set(glass, drawn));
  EXPECT_NE(previews.marks(), nullptr);
  EXPECT_TRUE(previews.Set(glass, HouseBeforePick(3)->state)) << "another model";
}

}  // namespace
}  // namespace parti::app::tests
