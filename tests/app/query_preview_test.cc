#include "app/query_preview.h"

#include <gtest/gtest.h>

#include "tests/app/panels_driver.h"

namespace parti::app::tests {
namespace {

TEST(QueryPreviewTest, AllThatAQuerySelectsIsOutlined) {
  const auto state = HouseWithTaps(1)->state;
  ASSERT_FALSE(state->selection.candidates.empty());
  const auto& first = state->selection.candidates[0];
  const WorldMarks marks = OutlinesOf({state, 0});
  EXPECT_GE(marks.segments.size(), 4 * first.count) << "a rectangle each, at least";
  EXPECT_TRUE(OutlinesOf({state, 99}).segments.empty());
}

TEST(QueryPreviewTest, WhatIsNotHoveredAnyMoreIsNotShown) {
  const auto state = HouseWithTaps(1)->state;
  QueryPreviews previews;
  EXPECT_TRUE(previews.Set(0, state));
  EXPECT_FALSE(previews.Set(0, state));
  while (previews.busy()) std::this_thread::yield();
  ASSERT_NE(previews.marks(), nullptr);
  EXPECT_TRUE(previews.Set(std::nullopt, state));
  EXPECT_EQ(previews.marks(), nullptr);
}

}  // namespace
}  // namespace parti::app::tests
