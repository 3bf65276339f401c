#include "grammar/lexer.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "base/utf8.h"

namespace parti::grammar {
namespace {

using Kind = Token::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Tokens as short texts: names and marks as they are, numbers in <>, texts in "", arrows "-->".
std::vector<std::string> Tokens(std::string_view text, Lexer::Hash hash = Lexer::Hash::kTag) {
  Lexer lexer(text, "", hash);
  std::vector<std::string> tokens;
  while (!lexer.At(Kind::kEnd)) {
    const Token t = lexer.Next();
    tokens.push_back(t.kind == Kind::kName     ? t.text
                     : t.kind == Kind::kNumber ? "<" + NumberText(t.number) + ">"
                     : t.kind == Kind::kText   ? QuotedText(t.text)
                     : t.kind == Kind::kArrow  ? "-->"
                     : t.kind == Kind::kMark   ? std::string(1, t.mark)
                                               : "bad: " + t.message);
  }
  return tokens;
}

TEST(Lexer, TellsSymbolsFromNumbersAfterADot) {
  EXPECT_THAT(Tokens(".Floor .5 0.25 1e3 12."),
              ElementsAre(".", "Floor", "<0.5>", "<0.25>", "<1000>", "<12>"));
}

TEST(Lexer, ReadsAllThreeArrowsAndTheEpsilonOfThePapers) {
  EXPECT_THAT(Tokens("A --> B -> C → ε"), ElementsAre("A", "-->", "B", "-->", "C", "-->", "NIL"));
  EXPECT_THAT(Tokens("x -1"), ElementsAre("x", "-", "<1>"));
}

TEST(Lexer, SkipsCommentsOfBothKinds) {
  EXPECT_THAT(Tokens("a // b\nc /* d\n e */ f"), ElementsAre("a", "c", "f"));
}

TEST(Lexer, HashIsATagInTreesAndACommentInRules) {
  EXPECT_THAT(Tokens("#small x", Lexer::Hash::kTag), ElementsAre("#", "small", "x"));
  EXPECT_THAT(Tokens("#small x\ny", Lexer::Hash::kComment), ElementsAre("y"));
}

TEST(Lexer, HashChangesItsMeaningFromTheTokenAtHandOn) {
  Lexer lexer("{ #tag }", "", Lexer::Hash::kComment);
  lexer.Next();
  EXPECT_TRUE(lexer.At(Kind::kEnd));
  lexer.SetHash(Lexer::Hash::kTag);
  EXPECT_TRUE(lexer.At('#'));
}

TEST(Lexer, LettersOfEveryLanguageMakeNames) {
  EXPECT_THAT(Tokens(".Střecha #窓 .Окно_2"),
              ElementsAre(".", "Střecha", "#", "窓", ".", "Окно_2"));
}

TEST(Lexer, BadTextIsABadTokenAndReadingGoesOn) {
  EXPECT_THAT(Tokens("a \xff b"), ElementsAre("a", HasSubstr("UTF-8"), "b"));
  EXPECT_THAT(Tokens("\"open\nb"), ElementsAre(HasSubstr("not closed"), "b"));
  EXPECT_THAT(Tokens("a /* b"), ElementsAre("a", HasSubstr("comment is not closed")));
  EXPECT_THAT(Tokens("1e999 b"), ElementsAre(HasSubstr("too large"), "b"));
  EXPECT_THAT(Tokens("4m b"), ElementsAre(HasSubstr("letter follows"), "b"));
  EXPECT_THAT(Tokens("a “b” c"),
              ElementsAre("a", HasSubstr("means nothing"), "b", HasSubstr("means nothing"), "c"));
}

TEST(Lexer, TextsKnowTheEscapesOfCga) {
  Lexer lexer(R"("\"\\\'\t\u00e9\u2192")");
  EXPECT_EQ(lexer.Next().text, "\"\\'\t\u00e9\u2192");
  EXPECT_THAT(Tokens(R"("\ud800" "\u12" "\x")"), ElementsAre(HasSubstr("means nothing")));
}

TEST(Lexer, CharactersThatMeanNothingHaveAHint) {
  const auto hint_of = [](std::string_view text) { return Lexer(text).Peek().hint; };
  EXPECT_THAT(hint_of("\xe2\x80\x98"), HasSubstr("straight quote"));
  EXPECT_THAT(hint_of("\xe2\x88\x92"), HasSubstr("minus"));
  EXPECT_THAT(hint_of("^"), HasSubstr("pow(base, exponent)"));
  EXPECT_THAT(hint_of("$"), HasSubstr("in \"\""));
  EXPECT_EQ(hint_of(std::string_view("\x07", 1)), "take byte 0x07 out");
  EXPECT_THAT(hint_of("\xe2\x82\xac"), HasSubstr("U+20AC"));
}

TEST(Lexer, AnEmptyTextAndAByteOrderMarkHoldNothing) {
  EXPECT_THAT(Tokens(""), ElementsAre());
  EXPECT_THAT(Tokens("\xef\xbb\xbf x"), ElementsAre("x"));
}

TEST(Lexer, KnowsWhatStartsALineAndWhatTouches) {
  Lexer lexer("a.b\n  /* c */ d e");
  EXPECT_TRUE(lexer.Next().starts_line);
  EXPECT_TRUE(lexer.Touching());
  EXPECT_FALSE(lexer.Next().starts_line);
  lexer.Next();
  EXPECT_FALSE(lexer.Touching());
  EXPECT_TRUE(lexer.Next().starts_line);
  EXPECT_FALSE(lexer.Next().starts_line);
}

TEST(Lexer, ErrorsStandUnderTheirToken) {
  Lexer lexer("ab cd", "x.cga");
  lexer.Next();
  const Error error = lexer.Unexpected("a number");
  EXPECT_EQ(FormatError(error),
            "x.cga:1:4: error: expected a number, got 'cd'\n    1 | ab cd\n      |    ^~");
}

RC_GTEST_PROP(Lexer, QuotedTextReadsBack, (const std::string& bytes)) {
  std::string text;
  for (const char c : bytes) text += static_cast<unsigned char>(c) < 0x80 ? std::string(1, c) : "é";
  const std::string quoted = QuotedText(text);
  Lexer lexer(quoted);
  RC_ASSERT(lexer.Next().text == text);
  RC_ASSERT(lexer.At(Kind::kEnd));
}

RC_GTEST_PROP(Lexer, NumbersReadBack, (double number)) {
  const double positive = std::abs(number);
  const std::string text = NumberText(positive);
  Lexer lexer(text);
  RC_ASSERT(lexer.Peek().number == positive);
}

RC_GTEST_PROP(Lexer, AnyBytesEnd, (const std::string& bytes)) {
  size_t last = 0;
  for (Lexer lexer(bytes); !lexer.At(Kind::kEnd);) {
    const Token token = lexer.Next();
    RC_ASSERT(token.offset >= last);
    RC_ASSERT(token.length > 0u);
    last = token.end();
    RC_ASSERT(last <= bytes.size());
  }
}

TEST(Utf8, RefusesWhatIsNotUtf8) {
  EXPECT_TRUE(IsUtf8("aé漢😀"));
  EXPECT_FALSE(IsUtf8("\xc0\x80"));          // overlong
  EXPECT_FALSE(IsUtf8("\xed\xa0\x80"));      // a surrogate
  EXPECT_FALSE(IsUtf8("\xf4\x90\x80\x80"));  // past U+10FFFF
  EXPECT_FALSE(IsUtf8("\xe2\x82"));          // cut off
}

TEST(Names, WhatIsNoNameIsQuoted) {
  EXPECT_EQ(NameText("Door_2"), "Door_2");
  EXPECT_EQ(NameText("left door"), "\"left door\"");
  EXPECT_EQ(NameText("2nd"), "\"2nd\"");
  EXPECT_EQ(NameText("off"), "\"off\"");
  EXPECT_EQ(NameText("ε"), "\"ε\"");
  EXPECT_EQ(NameText(""), "\"\"");
}

}  // namespace
}  // namespace parti::grammar
