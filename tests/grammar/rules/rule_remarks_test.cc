#include "grammar/rules/rule_remarks.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grammar/rules/rule_text.h"

namespace parti::grammar {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// "3: color" for what is told of column 3.
std::vector<std::string> RemarksIn(const std::string& text) {
  const auto rules = ParseRules(text, "house.cga", {});
  EXPECT_TRUE(rules) << (rules ? "" : FormatError(rules.error().front()));
  std::vector<std::string> told;
  if (!rules) return told;
  for (const Error& remark : RemarksOn(*rules)) {
    const std::string& message = remark.message;
    told.push_back(
        fmt::format("{}: {}", remark.place->column, message.substr(0, message.find(' '))));
  }
  return told;
}

TEST(RuleRemarks, WhatComesAfterTheLastSymbolIsLost) {
  EXPECT_THAT(RemarksIn("A --> [ B ] color(\"blue\")"), ElementsAre("13: color"));
  EXPECT_THAT(RemarksIn("A --> B color(\"blue\")"), ElementsAre("9: color"));
  EXPECT_THAT(RemarksIn("A --> extrude(3) B t(0, 1, 0) color(\"blue\")"), ElementsAre("20: t"));
  EXPECT_THAT(RemarksIn("A --> comp(f) { top: B } color(\"blue\")"), ElementsAre("26: color"));
}

TEST(RuleRemarks, WhatABracketEndsOnIsLost) {
  EXPECT_THAT(RemarksIn("A --> [ extrude(3) ] B"), ElementsAre("9: extrude"));
  EXPECT_THAT(RemarksIn("A --> [ B [ t(1, 0, 0) s(1, 1, 1) ] color(\"blue\") ] C"),
              ElementsAre("13: t", "37: color"));
  EXPECT_THAT(RemarksIn("A --> [ extrude(3) ]"), ElementsAre("9: extrude")) << "A stays as it is";
}

TEST(RuleRemarks, BodiesInsideAreLookedAt) {
  EXPECT_THAT(RemarksIn("A --> split(x) { ~1: [ B ] color(\"blue\") | { 1: C }* }"),
              ElementsAre("28: color"));
  EXPECT_THAT(RemarksIn("A --> split(x) { { 1: C color(\"blue\") }* }"), ElementsAre("25: color"));
  EXPECT_THAT(RemarksIn("A --> case scope.sx > 1: B t(0, 0, 1) else: 50%: C t(0, 0, 1) else: D"),
              ElementsAre("28: t", "52: t"));
}

TEST(RuleRemarks, WhatIsKeptIsNotTold) {
  for (const char* text : {
           "A --> extrude(3) color(\"blue\")",
           "A --> extrude(3)",
           "A --> [ NIL ] color(\"blue\")",
           "A --> t(0, 0, 1) [ t(0, 1, 0) B ] t(1, 0, 0) C",
           "A --> t(0, 0, 1) [ t(0, 1, 0) [ B ] ] [ color(\"blue\") C ]",
           "A --> color(\"blue\") comp(f) { top: B | side: color(\"cyan\") }",
           "A --> offset(-1) comp(f) { inside: B | border: NIL }",
           "attr h = 3\nA --> B set(h, 4) report(\"n\", 1) print(h) tag(\"x\")",
           "A --> [ t(0, 0, 1) NIL ] [ B ]",
           "A --> B NIL color(\"blue\")",
       }) {
    EXPECT_THAT(RemarksIn(text), IsEmpty()) << text;
  }
}

TEST(RuleRemarks, TheyHaveAPlaceAndARemedyAndAreNotWithoutEnd) {
  const auto rules = ParseRules("A --> [ B ] color(\"blue\")", "house.cga", {});
  ASSERT_TRUE(rules);
  const Error remark = RemarksOn(*rules).at(0);
  EXPECT_EQ(remark.place->file, "house.cga");
  EXPECT_EQ(remark.place->line, 1);
  EXPECT_THAT(remark.hint, HasSubstr("a symbol behind it"));
  std::string many = "A --> B";
  for (int i = 0; i < 500; ++i) many += " [ t(0, 0, 1) ]";
  EXPECT_EQ(RemarksIn(many).size(), kMostRemarks);
}

}  // namespace
}  // namespace parti::grammar
