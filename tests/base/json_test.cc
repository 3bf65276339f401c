#include "base/json.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace parti {
namespace {

Error ErrorOf(std::string_view text) {
  const auto parsed = ParseJson(text, "in.jsonl");
  return parsed ? Error{ErrorCode::kNoFit, "it parsed"} : parsed.error();
}

Result<Stroke> StrokeIn(std::string_view text) { return StrokeFrom(*ParseJson(text), "points"); }

TEST(ParseJson, ReadsAValue) { EXPECT_EQ(ParseJson(R"({"a": [1, 2]})").value()["a"][1], 2); }

TEST(ParseJson, SaysWhereATextStopsBeingJson) {
  const Error error = ErrorOf("{\"a\": 1,\n \"b\": oops}");
  EXPECT_EQ(error.code, ErrorCode::kBadText);
  ASSERT_TRUE(error.place);
  EXPECT_EQ(error.place->line, 2);
  EXPECT_EQ(error.place->column, 7);
  EXPECT_EQ(error.place->file, "in.jsonl");
}

TEST(ParseJson, RefusesHalfValuesAndTrailingOnes) {
  for (const char* text : {"", " ", "{", "[1,", "\"abc", "{} {}", "1 2", "[1,]", "{\"a\"}", "'a'",
                           "\xff\xfe", "\"\xc3\"", "nul"}) {
    EXPECT_EQ(ErrorOf(text).code, ErrorCode::kBadText) << text;
    EXPECT_TRUE(ErrorOf(text).place) << text;
  }
}

TEST(ParseJson, NumbersThatAreNotFiniteAreNamed) {
  for (const char* text : {"[0, NaN]", "[0, Infinity]", "[0, -Infinity]", "[0, nan]", "[0, inf]"}) {
    const Error error = ErrorOf(text);
    EXPECT_EQ(error.code, ErrorCode::kBadNumber) << text;
    ASSERT_TRUE(error.place) << text;
    EXPECT_NEAR(error.place->column, 5, 1) << text;
  }
  EXPECT_EQ(ErrorOf("[0, NaN]").message, "NaN is not a finite number");
}

TEST(ParseJson, ANumberThatNoDoubleHoldsIsOutOfRange) {
  const Error error = ErrorOf("[1, -1e999]");
  EXPECT_EQ(error.code, ErrorCode::kBadNumber);
  EXPECT_EQ(error.message, "-1e999 is out of range");
  ASSERT_TRUE(error.place);
  EXPECT_EQ(error.place->column, 5);
}

TEST(ParseJson, DeepNestingIsRefusedNotFollowed) {
  for (const size_t depth : {65u, 1000u, 5'000'000u}) {
    EXPECT_EQ(ErrorOf(std::string(depth, '[')).message, "nested deeper than 64 levels");
  }
  EXPECT_TRUE(ParseJson(std::string(64, '[') + std::string(64, ']')));
  EXPECT_TRUE(ParseJson('"' + std::string(1000, '[') + "\\\"[[\""));
}

RC_GTEST_PROP(ParseJson, WhatWasWrittenIsReadBack, (const std::vector<int>& numbers)) {
  RC_ASSERT(ParseJson(Json(numbers).dump()).value().get<std::vector<int>>() == numbers);
}

RC_GTEST_PROP(ParseJson, AnyTextGivesAValueOrAnError, (const std::string& text)) {
  const auto parsed = ParseJson(text);
  RC_ASSERT(parsed || !parsed.error().message.empty());
}

TEST(NumberFrom, NamesWhatIsWrong) {
  EXPECT_EQ(NumberFrom(Json(1.5), "x").value(), 1.5);
  EXPECT_EQ(NumberFrom(Json("a"), "camera.fov").error().message, "camera.fov is not a number");
  EXPECT_EQ(NumberFrom(Json(true), "x").error().code, ErrorCode::kBadText);
  EXPECT_EQ(NumberFrom(Json(nullptr), "x").error().code, ErrorCode::kBadText);
  EXPECT_EQ(NumberFrom(Json(1e13), "x").error().code, ErrorCode::kBadNumber);
  EXPECT_EQ(NumberFrom(Json(-1e300), "x").error().code, ErrorCode::kBadNumber);
}

TEST(Vec3From, WantsThreeNumbers) {
  EXPECT_EQ(Vec3From(Json({1, 2, 3}), "eye").value(), Vec3(1, 2, 3));
  EXPECT_EQ(Vec3From(Json({1, 2}), "eye").error().message, "eye is not a list of 3 numbers");
  EXPECT_EQ(Vec3From(Json(1), "eye").error().code, ErrorCode::kBadText);
  EXPECT_EQ(Vec3From(Json({1, "a", 3}), "eye").error().message, "eye[1] is not a number");
}

TEST(StrokeFromJson, ReadsMillisecondsAndPressure) {
  const Stroke stroke = StrokeIn("[[1, 2, 10], [3, 4, 20, 0.5]]").value();
  ASSERT_EQ(stroke.size(), 2u);
  EXPECT_EQ(stroke[0], (StrokeSample{Vec2(1, 2), 0.01}));
  EXPECT_EQ(stroke[1], (StrokeSample{Vec2(3, 4), 0.02, 0.5}));
}

TEST(StrokeFromJson, TimeNeverRunsBackwardsAndPressureStaysInRange) {
  const Stroke stroke = StrokeIn("[[0,0,10], [1,0,5], [2,0,20,7], [3,0,20,-1]]").value();
  EXPECT_EQ(stroke[1].t_s, 0.01);
  EXPECT_EQ(stroke[2].pressure, 1.0);
  EXPECT_EQ(stroke[3].pressure, 0.0);
}

TEST(StrokeFromJson, ClocksThatCountFrom1970AreFine) {
  EXPECT_EQ(StrokeIn("[[0,0,1763790000000]]").value()[0].t_s, 1763790000.0);
}

TEST(StrokeFromJson, RefusesWithTheNameOfThePoint) {
  EXPECT_EQ(StrokeIn("[]").error().code, ErrorCode::kTooShort);
  EXPECT_EQ(StrokeIn("{}").error().message, "points is not a list of points");
  EXPECT_EQ(StrokeIn("[[0,0,0], [0,0]]").error().message,
            "points[1] is not [x, y, t] or [x, y, t, pressure]");
  EXPECT_EQ(StrokeIn("[[0,0,0], [0,null,0]]").error().message, "points[1][1] is not a number");
  EXPECT_EQ(StrokeIn("[[0,1e200,0]]").error().code, ErrorCode::kBadNumber);
  EXPECT_EQ(StrokeIn("[7]").error().code, ErrorCode::kBadText);
}

}  // namespace
}  // namespace parti
