#include "base/error.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace parti {
namespace {

std::string Formatted(std::string_view text, size_t offset, size_t length, std::string hint = {}) {
  return FormatError(
      {ErrorCode::kBadText, "no", std::move(hint), PlaceIn(text, "a.cga", offset, length)});
}

TEST(FormatError, WithoutAPlaceNamesTheProgramAndTheRemedy) {
  EXPECT_EQ(FormatError({ErrorCode::kFile, "no such file", "check the name"}),
            "parti: error: no such file\n  hint: check the name");
  EXPECT_EQ(FormatError({ErrorCode::kFile, "no such file"}), "parti: error: no such file");
}

TEST(FormatError, MarksTheWordInItsLine) {
  EXPECT_EQ(Formatted("A --> B\nF --> extrude(3, 2) Roof", 14, 7, "say taper"),
            "a.cga:2:7: error: no\n"
            "    2 | F --> extrude(3, 2) Roof\n"
            "      |       ^~~~~~~  hint: say taper");
}

TEST(FormatError, ATextWithoutAFileSaysSo) {
  EXPECT_EQ(FormatError({ErrorCode::kBadText, "no", {}, PlaceIn("x", {}, 0)}),
            "<text>:1:1: error: no\n    1 | x\n      | ^");
}

TEST(FormatError, ATabStaysATabAboveTheCaret) {
  EXPECT_EQ(Formatted("\ta\tb", 3, 1), "a.cga:1:4: error: no\n    1 | \ta\tb\n      | \t \t^");
}

TEST(FormatError, TheCaretCountsCharactersNotBytes) {
  EXPECT_EQ(Formatted("é→ ñandú x", 6, 7),  // é and → are 2 and 3 bytes, ñandú 7
            "a.cga:1:7: error: no\n    1 | é→ ñandú x\n      |    ^~~~~");
}

TEST(FormatError, ALongLineIsCutAroundTheCaret) {
  const std::string text = std::string(5000, 'a') + "!" + std::string(5000, 'b');
  const std::string shown = Formatted(text, 5000, 1);
  EXPECT_LT(shown.size(), 300u);
  EXPECT_NE(shown.find("…aaa"), std::string::npos);
  EXPECT_NE(shown.find("bbb…"), std::string::npos);
  const size_t line = shown.find("| "), below = shown.rfind("| ");
  // "…" is three bytes and one character.
  EXPECT_EQ(shown.find('!') - line - 2, shown.find('^') - below);
}

TEST(FormatError, ControlCharactersDoNotReachTheTerminal) {
  const std::string shown = Formatted("a\x1b[31m\x07z", 0, 1);
  EXPECT_EQ(shown.find('\x1b'), std::string::npos);
  EXPECT_NE(shown.find("a?[31m?z"), std::string::npos);
}

TEST(FormatError, APlaceOutsideItsLineIsClamped) {
  const SourcePlace beyond{"a.cga", 1, 1000, 1000, "short"};
  EXPECT_EQ(FormatError({ErrorCode::kBadText, "no", {}, beyond}),
            "a.cga:1:1000: error: no\n    1 | short\n      |      ^");
  const SourcePlace before{"a.cga", 0, -5, -5, ""};
  EXPECT_EQ(FormatError({ErrorCode::kBadText, "no", {}, before}),
            "a.cga:0:-5: error: no\n    0 | \n      | ^");
}

TEST(PlaceIn, CountsFromOneAndKeepsTheLine) {
  const SourcePlace place = PlaceIn("one\r\ntwo three\r\n", "f", 9, 5);
  EXPECT_EQ(place.line, 2);
  EXPECT_EQ(place.column, 5);
  EXPECT_EQ(place.length, 5);
  EXPECT_EQ(place.line_text, "two three");
}

TEST(PlaceIn, AnEmptyTextAndAnOffsetPastTheEndAreTheEnd) {
  EXPECT_EQ(PlaceIn("", "f", 7).line_text, "");
  const SourcePlace end = PlaceIn("ab\ncd", "f", 100, 100);
  EXPECT_EQ(end.line, 2);
  EXPECT_EQ(end.column, 3);
  EXPECT_EQ(end.length, 1);
}

RC_GTEST_PROP(PlaceIn, LineAndColumnLeadBackToTheOffset, (const std::string& text)) {
  const size_t offset = *rc::gen::inRange<size_t>(0, text.size() + 1);
  const SourcePlace place = PlaceIn(text, "f", offset, 3);
  size_t start = 0;
  for (int line = 1; line < place.line; ++line) start = text.find('\n', start) + 1;
  RC_ASSERT(start + static_cast<size_t>(place.column) - 1 == offset);
}

RC_GTEST_PROP(FormatError, NoPlaceBreaksIt, (const std::string& text, int column, int length)) {
  const std::string shown =
      FormatError({ErrorCode::kBadText, "no", {}, SourcePlace{"f", 1, column, length, text}});
  RC_ASSERT(shown.find('^') != std::string::npos);
}

TEST(DidYouMean, FindsTheNearestWord) {
  const std::vector<std::string> words = {"extrude", "offset", "split", "comp"};
  EXPECT_EQ(DidYouMean("extrud", words), "extrude");
  EXPECT_EQ(DidYouMean("Ofset", words), "offset");
  EXPECT_EQ(DidYouMean("SPLIT", words), "split");
  EXPECT_EQ(DidYouMean("comp", {"cmop"}), "cmop") << "swapped letters are one slip";
  EXPECT_EQ(DidYouMean("", words), std::nullopt);
  EXPECT_EQ(DidYouMean("roof", words), std::nullopt);
  EXPECT_EQ(DidYouMean("extrude", {}), std::nullopt);
}

TEST(DidYouMean, TakesTheFirstOfEquallyNearWords) {
  EXPECT_EQ(DidYouMean("cat", {"car", "bat"}), "car");
}

TEST(DidYouMean, OneOtherLetterIsNoMisspelling) { EXPECT_EQ(DidYouMean("y", {"x"}), std::nullopt); }

TEST(DidYouMean, AHugeWordIsAnsweredAtOnce) {
  EXPECT_EQ(DidYouMean(std::string(8'000'000, 'a'), {"extrude"}), std::nullopt);
}

}  // namespace
}  // namespace parti
