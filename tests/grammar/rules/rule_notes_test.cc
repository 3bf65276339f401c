// report() and print(): what is kept of them, in which order, and what it comes to.
#include "grammar/rules/rule_notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "grammar/rules/report_table.h"
#include "tests/grammar/rules/derived_by_rules.h"
#include "tests/grammar/rules/rule_text_support.h"

namespace parti::grammar {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using tests::WrongWith;

/// Of so many lots of 20 by 10 that derive well; as in `threads`, or of the usual number.
std::vector<LotNotes> NotesOf(std::string_view text, size_t lots = 1, int threads = 1) {
  const std::vector<Item> items(lots, LotOf(20, 10)[0].item);
  std::vector<LotNotes> notes;
  RuleThreads watched;
  watched.count = threads;
  watched.notes = &notes;
  const auto trees = DeriveRules(RulesFrom(text), {}, items, watched);
  EXPECT_TRUE(trees.has_value()) << FormatError(trees.error());
  return notes;
}

std::vector<ReportRow> TableOf(std::string_view text) { return ReportTable(NotesOf(text)); }

/// A façade with reports of all types, and with draws by chance.
constexpr std::string_view kCity = R"(
Lot --> report("lots", 1) extrude(60) comp(f) { side: Facade | top: Roof }
Roof --> report("roof", geometry.area) X
Facade --> report("facades", 1) split(y) { ~1: Floor }*
Floor --> print("floor " + split.index) split(x) { ~0.5: Tile }*
Tile --> report("glass", geometry.area * rand(0.1, 0.9)) Kind
Kind --> 40%: report("windows.open", true) NIL
         else: report("windows.kind", "closed") color("#aaffaa")
)";

TEST(Reports, AreMadeOnceWhereTheyStandAndAlsoByWhatComesToNothing) {
  const auto rows = TableOf(R"(
    Lot --> report("lots", 1) split(x) { ~1: Part }*
    Part --> case split.index % 2 == 0: report("area", geometry.area) NIL
             else: report("area", geometry.area) report("kept", 1) A B
  )");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].key, "area");
  EXPECT_EQ(rows[0].count, 20u);
  EXPECT_NEAR(rows[0].sum, 200, 1e-9);
  EXPECT_NEAR(rows[0].average, 10, 1e-9);
  EXPECT_EQ(rows[1].key, "kept");
  EXPECT_EQ(rows[1].sum, 10) << "not by A and B, which come of it";
  EXPECT_EQ(rows[2].count, 1u);
}

TEST(Reports, OfEachTypeHaveARowOfTheirOwn) {
  const auto rows = TableOf(R"(
    Lot --> split(x) { 4: report("a", 4) A | 5: report("a", 5) A | 1: report("a", "x") A
                     | 2: report("a", "y") A | 2: report("a", "x") A | 1: report("a", true) A }
  )");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].type, ValueType::kNumber);
  EXPECT_EQ(rows[0].count, 2u);
  EXPECT_EQ(rows[0].sum, 9);
  EXPECT_EQ(rows[0].average, 4.5);
  EXPECT_EQ(rows[0].least, 4);
  EXPECT_EQ(rows[0].most, 5);
  EXPECT_TRUE(rows[0].values.empty());
  EXPECT_THAT(rows[1].values, ElementsAre(Pair("true", 1)));
  EXPECT_THAT(rows[2].values, ElementsAre(Pair("x", 2), Pair("y", 1)));
}

TEST(Reports, WhatIsNoNumberIsCountedAndNotAdded) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<RuleReport> reports = {{"a", none}, {"a", -3.0}, {"a", -1.0}, {"b", none}};
  const auto rows = ReportTable(reports);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].count, 3u);
  EXPECT_EQ(rows[0].no_numbers, 1u);
  EXPECT_EQ(rows[0].average, -2);
  EXPECT_EQ(rows[0].least, -3);
  EXPECT_EQ(rows[0].most, -1);
  EXPECT_EQ(rows[1].average, 0) << "of none";
}

TEST(Reports, AndLinesAreTheSameOnAnyNumberOfThreads) {
  const auto alone = NotesOf(kCity, 3, 1);
  ASSERT_EQ(alone.size(), 3u);
  EXPECT_GT(alone[0].reports.size(), 2000u);
  EXPECT_EQ(alone[0].prints.size(), 240u);
  EXPECT_NE(alone[0].reports, alone[1].reports) << "chance";
  for (int i = 0; i < 3; ++i) EXPECT_EQ(NotesOf(kCity, 3, 4), alone);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(NotesOf(kCity, 1, 4)[0], alone[0]);
}

TEST(Reports, ChangeNothingOfTheShapesKeptOrNot) {
  const Item lot = LotOf(20, 10)[0].item;
  std::vector<LotNotes> notes;
  RuleThreads keeping;
  keeping.notes = &notes;
  const auto kept = DeriveRules(RulesFrom(kCity), {}, {&lot, 1}, keeping);
  ASSERT_TRUE(kept.has_value());
  EXPECT_EQ(Bytes(kept->front()), Bytes(ByRules(kCity)));
}

TEST(Reports, OfALotHaveALimitThatSaysWhere) {
  std::string body;
  for (int i = 0; i < 250; ++i) body += " report(\"a\", 1)";
  const std::string text = "Lot --> split(x) { 0.002: A }*\nA -->" + body + " B\n";
  const Item lot = LotOf(20, 10)[0].item;
  for (const int threads : {1, 4}) {
    std::vector<LotNotes> notes;
    RuleThreads watched;
    watched.count = threads;
    watched.notes = &notes;
    const auto trees = DeriveRules(RulesFrom(text), {}, {&lot, 1}, watched);
    ASSERT_FALSE(trees.has_value());
    EXPECT_EQ(trees.error().code, ErrorCode::kLimitReached);
    EXPECT_THAT(trees.error().message, HasSubstr("rule A: more than 2000000 reports (shape 8000)"));
    EXPECT_EQ(trees.error().place->line, 2);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].reports.size(), kMostReports);
  }
}

TEST(Prints, NameRuleAndPlaceInTheOrderOfTheShapes) {
  const auto notes = NotesOf(R"(Lot --> split(x) { 10: print("west") A | 10: A }
A --> print(scope.sx) B
B --> print(split.index > 0) C
)");
  EXPECT_THAT(notes[0].prints,
              ElementsAre("test.cga:1:24: rule Lot: west", "test.cga:2:7: rule A: 10",
                          "test.cga:3:7: rule B: false", "test.cga:2:7: rule A: 10",
                          "test.cga:3:7: rule B: true"));
}

TEST(Prints, AsFunctionsGiveWhatTheyPrintOfItsOwnType) {
  const auto notes = NotesOf(R"(attr height = print(3)
half(x) = print(x) / 2
Lot --> case print(height > 2): extrude(half(height)) A(print("a" + 1), "a1") else: B
A(name, wanted) --> case name == wanted: t(print(4), 0, 0) C else: D
)");
  EXPECT_THAT(notes[0].prints,
              ElementsAre("test.cga:1:15: attribute height: 3", "test.cga:3:14: rule Lot: true",
                          "test.cga:2:11: function half: 3", "test.cga:3:57: rule Lot: a1",
                          "test.cga:4:44: rule A: 4"));
  EXPECT_THAT(WrongWith("Lot --> extrude(print(\"high\")) A"),
              ElementsAre("1:17 the distance of extrude is a number, got a text; float(…) reads a "
                          "number from a text"));
}

TEST(Prints, AreBoundedAndAreLinesThatATerminalShowsAsTheyAre) {
  const auto notes =
      NotesOf(R"(Lot --> print("a\nb" + "é") split(x) { 0.01: print(split.index) A }*)");
  EXPECT_EQ(notes[0].prints.size(), kMostPrints);
  EXPECT_EQ(notes[0].prints[0], "test.cga:1:9: rule Lot: a bé");
  EXPECT_EQ(notes[0].more_prints, 2001 - kMostPrints);
  NoteBook book;
  const RuleSet rules = RulesFrom("Lot --> A");
  book.Print({}, "\x1b[2J\xff" + std::string(2 * kLongestPrint, 'x'));
  const LotNotes long_line = std::move(book).Take(rules);
  EXPECT_THAT(long_line.prints[0], HasSubstr(" [2J xxx"));
  EXPECT_LT(long_line.prints[0].size(), kLongestPrint + 100);
}

TEST(Prints, AreThereUpToWhatFails) {
  const std::vector<Item> lots(3, LotOf(20, 10)[0].item);
  for (const int threads : {1, 4}) {
    std::vector<LotNotes> notes;
    RuleThreads watched;
    watched.count = threads;
    watched.notes = &notes;
    const RuleSet rules = RulesFrom("Lot --> print(1) extrude(print(0 / 0)) A");
    ASSERT_FALSE(DeriveRules(rules, {}, lots, watched).has_value());
    ASSERT_EQ(notes.size(), 1u) << "the first lot fails";
    EXPECT_EQ(notes[0].prints.size(), 2u);
    EXPECT_THAT(notes[0].prints[1], HasSubstr("1:26: rule Lot: "));
  }
}

TEST(Notes, AreWrittenBackAsTheyAre) {
  const std::string text = "Lot --> report(\"a.b\", geometry.area) print(print(3) + \"m\") A\n";
  EXPECT_EQ(tests::Written(text), text);
}

TEST(Notes, StandInRulesAndNotInTrees) {
  EXPECT_THAT(WrongWith("tree a { .Lot --> report(\"a\", 1) }"),
              ElementsAre("1:19 report stands in rules only; what a tree selects is told by parti "
                          "query"));
}

TEST(Notes, WantAKeyAndAValue) {
  EXPECT_THAT(WrongWith("Lot --> report(\"a\") A"),
              ElementsAre("1:9 report lacks its value; write report(key, value)"));
  EXPECT_THAT(WrongWith("Lot --> report(3, 1) A"),
              ElementsAre("1:16 the key of report is a text, got a number; str(…) makes a text of "
                          "it"));
  EXPECT_THAT(WrongWith("Lot --> report(\"\", 1) A"),
              ElementsAre("1:16 report: key is ''; give a name"));
}

}  // namespace
}  // namespace parti::grammar
