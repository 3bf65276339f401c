#include "grammar/action_text.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "tests/grammar/random_trees.h"

namespace parti::grammar {
namespace {

using ::testing::HasSubstr;

std::string ReadBack(std::string_view text) {
  const auto action = ParseAction(text);
  return action ? TextOf(*action) : FormatError(action.error());
}

std::string ErrorOf(std::string_view text) {
  const auto action = ParseAction(text, "a.cga");
  return action ? "no error: " + TextOf(*action) : FormatError(action.error());
}

TEST(ActionText, ReadsBackWhatItPrints) {
  for (const char* text : {
           "extrude(12) Mass",
           "extrude(-0.1)",
           "comp(f) { side: Facade | top: Roof | 0: NIL }",
           "split(y) { 4: Ground | { ~3: Floor }* }",
           "split(y) { ~3: Floor }*",
           "split(x) { '0.25: A | { ~1: B | { 0.5: C }* }* | ~1: NIL }",
           "split(y) { 4: tag(\"x\") Ground | ~1: color(\"#ff0000\") tag(\"y\") Top }",
           "offset(-0.5) { inside: Court | border: Wall }",
           "tag(\"festive\")",
           "tag(\"two words\")",
           "symbol(\"Wall\")",
           "color(\"#ad7859\") Painted",
           "layers(\"floors\", \"door\") { Floors | @Door }",
           "layers(\"a\") { tag(\"x\") NIL }",
           "segment(x) { ~1: NIL | 1.2: Window | ~1: NIL }*",
           "segment(y) { 4: Ground | { ~3: @Floor }* }",
           "segment(y) { { ~3: Floor }* }*",
           "set_property(\"fixed_geometry\", true)",
           "vectorial(\"M0,0 L0,1 L1,0Z\") Gable",
           "vectorial(\"M0,0 A1,1 0 0 1 1,0Z\", 12)",
       }) {
    EXPECT_EQ(ReadBack(text), text);
  }
}

TEST(ActionText, AcceptsTheVariantsOfThePapers) {
  EXPECT_EQ(ReadBack("split(\"y\") { 4: A | ~1: ε }"), "split(y) { 4: A | ~1: NIL }");
  EXPECT_EQ(ReadBack("split(x, ~1, 3, ~1) { NIL | DoorTile | NIL }"),
            "split(x) { ~1: NIL | 3: DoorTile | ~1: NIL }");
  EXPECT_EQ(ReadBack("comp(face, side){Facade}"), "comp(f) { side: Facade }");
  EXPECT_EQ(ReadBack("split(y, ~3){Floor}*"), "split(y) { ~3: Floor }*");
}

TEST(ActionText, RepeatIsARowOfItsOwn) {
  EXPECT_EQ(ParseAction("split(y) { ~3: Floor }*")->operation->word, "Repeat");
  EXPECT_EQ(ParseAction("split(y) { { ~3: Floor }* }")->operation->word, "Split");
}

TEST(ActionText, ASegmentRepeatsAsOneGroup) {
  const auto repeated = ParseAction("segment(x) { ~3: A }*");
  EXPECT_EQ(*repeated, *ParseAction("segment(x) { { ~3: A }* }"));
  EXPECT_EQ(*repeated, *ParseAction("segment(x, ~3) { A }*"));
  ASSERT_EQ(repeated->successors.size(), 1u);
  EXPECT_EQ(repeated->successors[0].repeat.size(), 1u);
}

TEST(ActionText, LayersKeepTheirNames) {
  const auto layers = ParseAction("layers(\"floors\", \"door\") { Floors | @Door }");
  ASSERT_EQ(layers->successors.size(), 2u);
  EXPECT_EQ(std::get<std::string>(layers->successors[1].key), "door");
  EXPECT_FALSE(layers->successors[0].deferred);
  EXPECT_TRUE(layers->successors[1].deferred);
}

TEST(ActionText, LayersNeedANameForEachAlternative) {
  EXPECT_THAT(ErrorOf("layers() { A }"), HasSubstr("layers lacks the names of what it makes"));
  EXPECT_THAT(ErrorOf("layers(\"a\") { A | B }"),
              HasSubstr("layers has 2 alternatives in braces for 1 in parentheses"));
  EXPECT_THAT(ErrorOf("layers(\"a\", \"a\") { A | B }"),
              HasSubstr("layers: two successors are named 'a'"));
  EXPECT_THAT(ErrorOf("layers(\"a\") { { A }* }"), HasSubstr("layers: "));
  EXPECT_THAT(ErrorOf("layers(\"a\") { A }*"), HasSubstr("layers can't be repeated"));
  EXPECT_THAT(ErrorOf("layers(\"a\") { @NIL }"), HasSubstr("write @Symbol"));
  EXPECT_THAT(ErrorOf("layers(\"a\") { @ }"), HasSubstr("write @Symbol"));
}

TEST(ActionText, PropertiesAreChecked) {
  EXPECT_THAT(ErrorOf("set_property(\"fixed\", false)"), HasSubstr("give fixed_geometry"));
  EXPECT_THAT(ErrorOf("set_property(\"fixed_geometry\", 0)"), HasSubstr("true or false"));
}

TEST(ActionText, ErrorsSayWhereAndWhatIsMeant) {
  EXPECT_EQ(ErrorOf("extrud(3)"),
            "a.cga:1:1: error: there is no operation 'extrud'\n"
            "    1 | extrud(3)\n"
            "      | ^~~~~~  hint: did you mean 'extrude'?");
  EXPECT_EQ(ErrorOf("extrude(3, 2) Roof"),
            "a.cga:1:12: error: extrude takes 1 argument, got 2\n"
            "    1 | extrude(3, 2) Roof\n"
            "      |            ^  hint: write extrude(distance)");
  EXPECT_EQ(ErrorOf("comp(f) { sid: A }"),
            "a.cga:1:11: error: there is no selector 'sid'\n"
            "    1 | comp(f) { sid: A }\n"
            "      |           ^~~  hint: did you mean 'side'?");
}

TEST(ActionText, EveryKindOfMistakeHasItsMessage) {
  EXPECT_THAT(ErrorOf(""), HasSubstr("expected an operation, got the end of the text"));
  EXPECT_THAT(ErrorOf("extrude"), HasSubstr("'(' and the operation's arguments"));
  EXPECT_THAT(ErrorOf("extrude()"), HasSubstr("extrude lacks its distance"));
  EXPECT_THAT(ErrorOf("extrude(~3)"), HasSubstr("expected a length in metres"));
  EXPECT_THAT(ErrorOf("extrude(nan)"), HasSubstr("expected a length in metres"));
  EXPECT_THAT(ErrorOf("extrude(1e999)"), HasSubstr("too large"));
  EXPECT_THAT(ErrorOf("extrude(1e9)"), HasSubstr("give a number from"));
  EXPECT_THAT(ErrorOf("extrude(3"), HasSubstr("expected ',' or ')'"));
  EXPECT_THAT(ErrorOf("split(w) { 1: A }"), HasSubstr("an axis: x, y or z"));
  EXPECT_THAT(ErrorOf("split(y)"), HasSubstr("'{' and what split makes"));
  EXPECT_THAT(ErrorOf("split(y) { A }"), HasSubstr("a size: 3, '0.5 or ~1"));
  EXPECT_THAT(ErrorOf("split(y) { 4 A }"), HasSubstr("':' after the size"));
  EXPECT_THAT(ErrorOf("split(y) { 4: A , 3: B }"), HasSubstr("expected '|' or '}'"));
  EXPECT_THAT(ErrorOf("split(y) { { 4: A } }"), HasSubstr("'*' after braces in braces"));
  EXPECT_THAT(ErrorOf("split(y, 4) { A | B }"), HasSubstr("2 alternatives in braces for 1"));
  EXPECT_THAT(ErrorOf("split(y) { 4: extrude(1) A }"), HasSubstr("can't stand before a symbol"));
  EXPECT_THAT(ErrorOf("comp(f) { side: A }*"), HasSubstr("comp can't be repeated"));
  EXPECT_THAT(ErrorOf("comp(f) { 1.5: A }"), HasSubstr("whole number"));
  EXPECT_THAT(ErrorOf("repeat(y) { 1: A }"), HasSubstr("split(y) { ~3: Floor }*"));
  EXPECT_THAT(ErrorOf("Wall"), HasSubstr("write symbol(\"Wall\")"));
  EXPECT_THAT(ErrorOf("NIL"), HasSubstr("in the place of a symbol"));
  EXPECT_THAT(ErrorOf("tag(\"x\") NIL"), HasSubstr("NIL makes nothing"));
  EXPECT_THAT(ErrorOf("tag(\"x"), HasSubstr("not closed"));
  EXPECT_THAT(ErrorOf("color(\"#12345g\")"), HasSubstr("#rrggbb"));
  EXPECT_THAT(ErrorOf("extrude(3) A B"), HasSubstr("expected the end of the action"));
}

TEST(ActionText, DeepBracesAreRefusedNotFollowed) {
  std::string text = "split(y) ";
  for (int i = 0; i < 100'000; ++i) text += "{ ";
  EXPECT_THAT(ErrorOf(text), HasSubstr("nested more than 32 deep"));
}

RC_GTEST_PROP(ActionText, EveryValidActionReadsBack, ()) {
  const Action action = RandomAction();
  RC_PRE(Check(action).has_value());
  const std::string text = TextOf(action);
  RC_LOG() << text;
  const auto read = ParseAction(text);
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == action);
}

}  // namespace
}  // namespace parti::grammar
