#include "app/timeline.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace parti::app {
namespace {

/// A hundred shapes and more.
SessionState StateWith(const std::string& lot, int number) {
  SessionState state;
  const auto rules =
      fmt::format("tree t {{ .Lot --> split(x) {{ {{ ~{}: A }}* }} }}", 0.01 + 1e-5 * number);
  state.model = *BuiltOn(*ParseLots(lot), *grammar::ParseTrees(rules));
  return state;
}

TEST(TimelineTest, AChangeEndsWhatCouldBeRedone) {
  Timeline timeline(StateWith("rect(1,1)", 1), {});
  timeline.Change(StateWith("rect(1,1)", 2));
  timeline.Change(StateWith("rect(1,1)", 3));
  timeline.GoTo(1, *timeline.step(1).state);
  EXPECT_EQ(timeline.span(), (Timeline::Span{0, 1, 2}));
  timeline.Change(StateWith("rect(1,1)", 4));
  EXPECT_EQ(timeline.span(), (Timeline::Span{0, 2, 2}));
}

TEST(TimelineTest, LookingIsNoStep) {
  Timeline timeline(StateWith("rect(1,1)", 1), {});
  timeline.Change(StateWith("rect(1,1)", 2));
  SessionState looked = timeline.present();
  looked.in_hand = {0, 0};
  timeline.Look(std::move(looked));
  EXPECT_EQ(timeline.span(), (Timeline::Span{0, 1, 1}));
  EXPECT_EQ(timeline.step(1).record.in_hand, (std::vector<int>{0, 0}));
}

TEST(TimelineTest, AStateLikeThePresentOneIsNoStep) {
  Timeline timeline(StateWith("rect(1,1)", 1), {});
  timeline.Change(StateWith("rect(1,1)", 2));
  timeline.GoTo(0, *timeline.step(0).state);
  SessionState same = timeline.present();
  same.model.rules = std::make_shared<const grammar::Trees>(same.model.trees());
  timeline.Change(same);
  EXPECT_EQ(timeline.span(), (Timeline::Span{0, 0, 1})) << "equal rules, made anew";
  same.selection.shapes = {{0, 0}};
  timeline.Change(same);
  EXPECT_EQ(timeline.span(), (Timeline::Span{0, 1, 1}));
}

TEST(TimelineTest, TheOldestStepsAreForgottenPastTheLimit) {
  Timeline timeline(StateWith("rect(1,1)", 1), {.steps = 3});
  for (int i = 0; i < 10; ++i) timeline.Change(StateWith("rect(1,1)", 2 + i));
  EXPECT_EQ(timeline.span(), (Timeline::Span{7, 10, 10}));
}

TEST(TimelineTest, DistantStepsKeepOnlyTheirRecordsWhenMemoryIsShort) {
  Timeline timeline(StateWith("rect(1,1)", 1), {.steps = 100, .bytes = 1'000'000});
  for (int i = 0; i < 90; ++i) timeline.Change(StateWith("rect(1,1)", 2 + i));
  EXPECT_EQ(timeline.span().first, 0u) << "records are small";
  EXPECT_FALSE(timeline.step(0).state);
  EXPECT_TRUE(timeline.step(89).state) << "near ones are at hand";
  EXPECT_EQ(timeline.step(0).record.rules->size(), 1u);
}

TEST(TimelineTest, WhereNotEvenRecordsFitTheOldestGo) {
  Timeline timeline(StateWith("rect(1,1)", 1), {.steps = 1000, .bytes = 20'000});
  for (int i = 0; i < 90; ++i) timeline.Change(StateWith("rect(1,1)", 2 + i));
  EXPECT_GT(timeline.span().first, 70u);
  EXPECT_EQ(timeline.span().now, 90u);
}

TEST(TimelineTest, OneStepIsKeptHoweverLargeItIs) {
  Timeline timeline(StateWith("rect(1,1)", 1), {.steps = 1, .bytes = 1});
  timeline.Change(StateWith("rect(1,1)", 2));
  EXPECT_EQ(timeline.span().now, timeline.span().last);
  EXPECT_EQ(timeline.present().model.lots().size(), 1u);
}

TEST(TimelineTest, ADocumentsStepsGoOnWithTheirNumbers) {
  const SessionState a = StateWith("rect(1,1)", 1), b = StateWith("rect(1,1)", 2);
  Timeline timeline({RecordOf(a), RecordOf(b), RecordOf(a)}, 40, 41, b, {});
  EXPECT_EQ(timeline.span(), (Timeline::Span{40, 41, 42}));
  EXPECT_FALSE(timeline.step(40).state) << "derived when undo comes to it";
  timeline.Change(a);
  EXPECT_EQ(timeline.span(), (Timeline::Span{40, 42, 42}));
}

}  // namespace
}  // namespace parti::app
