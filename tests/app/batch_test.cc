#include "app/batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace parti::app {
namespace {

Result<BatchAnswer> Double(const Json& task) {
  const auto n = NumberFrom(task.value("n", Json()), "n");
  if (!n) return Fail(n);
  return BatchAnswer{{"twice", 2 * *n}};
}

std::string Answers(const std::string& text, BatchTally* tally = nullptr) {
  std::istringstream in(text);
  std::ostringstream out;
  const BatchTally counted = AnswerLines(in, out, Double);
  if (tally) *tally = counted;
  return out.str();
}

TEST(Batch, AnswersInOrderWithTheIdInFront) {
  EXPECT_EQ(Answers("{\"n\":1,\"id\":\"a\"}\n{\"n\":2.5,\"id\":7}\n"),
            "{\"id\":\"a\",\"twice\":2.0}\n{\"id\":7,\"twice\":5.0}\n");
}

TEST(Batch, ABadLineIsAnsweredInItsPlaceAndCostsNoOther) {
  BatchTally tally;
  EXPECT_EQ(Answers("{\"id\":1,\"n\":1}\n{\"id\":2,\"n\":\"x\"}\n{\"id\":3,\"n\":3}", &tally),
            "{\"id\":1,\"twice\":2.0}\n{\"id\":2,\"error\":\"line 2: n is not a number\"}\n"
            "{\"id\":3,\"twice\":6.0}\n");
  EXPECT_EQ(tally.answered, 2);
  EXPECT_EQ(tally.failed, 1);
}

TEST(Batch, ALineThatIsNotJsonNamesItsPlace) {
  const std::string answer = Answers("\n{\"id\":1,\"n\":oops}\n");
  EXPECT_THAT(answer, testing::StartsWith("{\"id\":null,\"error\":\"line 2, column 1"));
  EXPECT_THAT(answer, testing::HasSubstr("not JSON"));
}

TEST(Batch, ANumberThatIsNotFiniteIsCalledSo) {
  EXPECT_THAT(Answers("{\"id\":1,\"n\":NaN}"), testing::HasSubstr("NaN is not a finite number"));
}

TEST(Batch, WhatIsNoTaskIsRefused) {
  EXPECT_THAT(Answers("[1]"), testing::HasSubstr("not a JSON object"));
  EXPECT_THAT(Answers("{\"n\":1}"), testing::HasSubstr("\\\"id\\\" is missing"));
  EXPECT_THAT(Answers("{\"n\":1,\"id\":[]}"), testing::HasSubstr("\\\"id\\\" is missing"));
  EXPECT_THAT(Answers("{\"id\":1,\"n\":1e999}"), testing::HasSubstr("out of range"));
}

TEST(Batch, EmptyLinesAndCarriageReturnsArePassedOver) {
  BatchTally tally;
  EXPECT_EQ(Answers("\r\n \n{\"id\":1,\"n\":1}\r\n\n", &tally), "{\"id\":1,\"twice\":2.0}\n");
  EXPECT_EQ(tally.answered, 1);
  EXPECT_EQ(tally.failed, 0);
}

TEST(RunBatch, AFileThatCantBeReadFails) {
  EXPECT_NE(RunBatch("/nowhere/strokes.jsonl", Double), 0);
  EXPECT_NE(RunBatch("/tmp", Double), 0);
  EXPECT_NE(RunBatch("/dev/null", Double), 0) << "a batch without a task made nothing";
}

}  // namespace
}  // namespace parti::app
