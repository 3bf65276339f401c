// What is wrong with rule files: all of it at once, each with its place and the remedy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/rules/rule_text_support.h"

namespace parti::grammar::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

/// The only thing that is wrong.
std::string ErrorOf(std::string_view text, const RuleOptions& options = {}) {
  const auto wrong = WrongWith(text, options);
  return wrong.size() == 1 ? wrong[0]
                           : fmt::format("{} errors: {}", wrong.size(), fmt::join(wrong, "\n"));
}

TEST(RuleErrors, HaveTheFormOfTheHouse) {
  const auto rules =
      ParseRules("Lot --> extrude(12) Mass\nMass --> extrude(3.0, 2.0) Roof\n", "h.cga");
  ASSERT_FALSE(rules.has_value());
  ASSERT_EQ(rules.error().size(), 1u);
  EXPECT_EQ(FormatError(rules.error()[0]),
            "h.cga:2:23: error: extrude takes 1 argument, got 2\n"
            "    2 | Mass --> extrude(3.0, 2.0) Roof\n"
            "      |                       ^~~  hint: write extrude(distance)");
}

TEST(RuleErrors, AllOfATextAtOnce) {
  EXPECT_THAT(WrongWith(R"(attr h = 3 +
Lot --> extrude(h) Mass
Mass --> comp(f) { sid: Facade | top: }
Facade --> split(w) { 1: A }
A --> extrude(
B --> tag("x" C
C --> color("redd") D
)"),
              ElementsAre(StartsWith("2:1 "),
                          StartsWith("3:20 comp has no selector 'sid'; did you mean 'side'?"),
                          StartsWith("4:18 expected an axis"), StartsWith("6:1 "),
                          StartsWith("6:15 "), StartsWith("7:13 color: color is 'redd'")));
}

TEST(RuleErrors, ReadingGoesOnAtTheNextAlternative) {
  EXPECT_THAT(
      WrongWith("A --> split(y) { 1 A | 2: extrude(,) | ~: C | 3: nope(2) }\nB --> frob(1)"),
      ElementsAre(StartsWith("1:20 expected ':' after the size"),
                  StartsWith("1:35 expected a value"), StartsWith("1:41 expected a value"),
                  StartsWith("1:50 there is no operation 'nope'"),
                  StartsWith("2:7 there is no operation 'frob'")));
}

TEST(RuleErrors, AForgottenBraceEndsAtTheNextRule) {
  EXPECT_EQ(ErrorOf("A --> split(y) { 1: B | ~1: C\nB --> split(x) { 1: D }\n"),
            "2:1 expected '|' or '}', got 'B'");
}

TEST(RuleErrors, BracketsThatStandAlone) {
  EXPECT_THAT(
      WrongWith("A --> X ] Y\nB --> split(x) { ~1: [ X | ~1: [ X ] ] Y }\n"),
      ElementsAre(StartsWith("1:9 ']' closes nothing"), StartsWith("2:22 '[' is never closed"),
                  StartsWith("2:38 ']' closes nothing")));
}

TEST(RuleErrors, SuggestWhatWasMeant) {
  EXPECT_THAT(ErrorOf("A --> extrud(3)"), HasSubstr("did you mean 'extrude'?"));
  EXPECT_THAT(ErrorOf("Lot --> Mas\nMass --> extrude(3)"), HasSubstr("did you mean 'Mass'?"));
  EXPECT_THAT(ErrorOf("Lot --> Towr(3)\nTower(h) --> extrude(h)"),
              HasSubstr("did you mean 'Tower'?"));
  EXPECT_THAT(ErrorOf("attr height = 3\nLot --> extrude(heigth)"),
              HasSubstr("did you mean 'height'?"));
  EXPECT_THAT(ErrorOf("Lot --> extrude(sqr(3))"), HasSubstr("did you mean 'sqrt'?"));
  EXPECT_THAT(ErrorOf("A --> comp(f) { frnt: B }"), HasSubstr("did you mean 'front'?"));
  EXPECT_THAT(ErrorOf("A --> set(hight, 3)\nattr height = 1"), HasSubstr("did you mean 'height'?"));
}

TEST(RuleErrors, ATerminalThatLooksLikeAUsedRuleIsATerminal) {
  EXPECT_THAT(WrongWith("Lot --> split(x) { 1: Wall | 1: Walls | 2: Hall }\nHall --> extrude(1)"),
              IsEmpty());
  EXPECT_THAT(WrongWith("Lot --> Window1\nWindow2 --> extrude(1)"), IsEmpty());
  EXPECT_THAT(WrongWith("Floors --> split(y) { ~3: Floor }*\nFloor --> Tile\nLot --> Floors"),
              IsEmpty());
}

TEST(RuleErrors, ANameLikeThatOfARuleIsLeftAloneWhenSkipping) {
  const std::string text = "M --> trim() { Wall }\nWall --> Wal";
  RuleOptions skip;
  skip.skip_unknown = true;
  const auto rules = ParseRules(text, "a.cga", skip);
  ASSERT_TRUE(rules.has_value());
  // What used Wall is gone from what is written, so that Wal could be meant to be Wall.
  const std::string written = TextOf(*rules);
  EXPECT_THAT(ErrorOf(written), HasSubstr("did you mean 'Wall'?"));
  const auto again = ParseRules(written, "b.cga", skip);
  ASSERT_TRUE(again.has_value());
  EXPECT_TRUE(*again == *rules);
}

TEST(RuleErrors, ArgumentsAreHeldAgainstTheOperationTable) {
  EXPECT_THAT(ErrorOf("A --> extrude(1e9)"), HasSubstr("distance is 1e+09"));
  EXPECT_THAT(ErrorOf("A --> extrude(\"high\")"),
              HasSubstr("the distance of extrude is a number, got a text"));
  EXPECT_THAT(ErrorOf("A --> extrude()"), HasSubstr("extrude lacks its distance"));
  EXPECT_THAT(ErrorOf("A --> extrude"), HasSubstr("extrude is an operation"));
  EXPECT_THAT(ErrorOf("A --> tag(3)"), HasSubstr("is a text, got a number"));
  EXPECT_THAT(ErrorOf("A --> split(x)"), HasSubstr("split needs alternatives in braces"));
  EXPECT_THAT(ErrorOf("A --> extrude(1) { B }"), HasSubstr("extrude takes no alternatives"));
  EXPECT_THAT(ErrorOf("A --> comp(f) { all: B }*"), HasSubstr("comp can't be repeated"));
  EXPECT_THAT(ErrorOf("A --> split(x, 1, 2) { B }"), HasSubstr("1 alternatives in braces for 2"));
  EXPECT_THAT(ErrorOf("A --> split(x, 1) { 2: B }"), HasSubstr("in parentheses already"));
  EXPECT_THAT(ErrorOf("A --> comp(f) { 1.5: B }"), HasSubstr("a whole number"));
  EXPECT_THAT(ErrorOf("A --> split(x) { 1e300: B }"), HasSubstr("a size is"));
  EXPECT_THAT(ErrorOf("A --> split(x) { A, B }"), HasSubstr("alternatives are separated by |"));
}

TEST(RuleErrors, TypesAreHeldAgainstUse) {
  EXPECT_THAT(ErrorOf("attr a = sin(\"x\")"),
              HasSubstr("the operand of sin is a number, got a text"));
  EXPECT_THAT(ErrorOf("attr a = case 3: 1 else: 2"), HasSubstr("the condition is a boolean"));
  EXPECT_THAT(ErrorOf("attr a = case true: 1 else: \"x\""),
              HasSubstr("alternative is a number, got a text"));
  EXPECT_THAT(ErrorOf("A --> B(\"x\")\nB(h) --> extrude(h)"),
              HasSubstr("the h of B is a number, got a text"));
  EXPECT_THAT(ErrorOf("attr t = \"x\"\nA --> set(t, 3)"), HasSubstr("the value of t is a text"));
  EXPECT_THAT(ErrorOf("attr a = true + 1"), HasSubstr("got a boolean"));
  EXPECT_THAT(ErrorOf("attr a = 1 == \"x\""), HasSubstr("operand of =="));
  EXPECT_THAT(ErrorOf("attr a = true < false"), HasSubstr("compares numbers or texts"));
}

TEST(RuleErrors, DeclarationsThatContradict) {
  EXPECT_THAT(ErrorOf("A --> B\nA --> C"), StartsWith("2:1 'A' is declared twice"));
  EXPECT_THAT(ErrorOf("attr a = 1\na = 2"), StartsWith("2:1 'a' is declared twice"));
  EXPECT_THAT(ErrorOf("extrude(x) --> B"), HasSubstr("is an operation, and no name for a rule"));
  EXPECT_THAT(ErrorOf("A(x, x) --> B"), HasSubstr("two parameters have the name 'x'"));
  EXPECT_THAT(ErrorOf("case --> B"), HasSubstr("a word of the language"));
  EXPECT_THAT(ErrorOf("const c = 1\nA --> set(c, 2)"), HasSubstr("c is a const"));
  EXPECT_THAT(ErrorOf("A(h) --> extrude(h)\nB --> A"), HasSubstr("A takes 1 argument, got 0"));
}

TEST(RuleErrors, ValuesThatNeedThemselves) {
  EXPECT_THAT(WrongWith("attr a = b + 1\nattr b = f(2)\nf(x) = x * a\nattr c = a"),
              ElementsAre("1:6 the value of 'a' depends on itself",
                          "2:6 the value of 'b' depends on itself"));
  EXPECT_THAT(WrongWith("f(n) = case n > 1: n * f(n - 1) else: 1\nattr a = f(5)"), IsEmpty());
}

TEST(RuleErrors, ChancesAndCasesHaveAnElse) {
  EXPECT_THAT(ErrorOf("A --> case true: B"), HasSubstr("expected 'else:'"));
  EXPECT_THAT(ErrorOf("A --> 50%: B 20%: C"), HasSubstr("lack an else"));
  EXPECT_THAT(ErrorOf("A --> case true: else: B"), HasSubstr("[ ] changes nothing"));
  EXPECT_THAT(ErrorOf("A --> 70%: B 60%: C else: D"), HasSubstr("sum up to 130 %"));
  EXPECT_THAT(ErrorOf("attr a = 101%: 1 else: 2"), HasSubstr("a weight of 101 %"));
}

TEST(RuleErrors, AConditionThatBreaksOffIsToldOnce) {
  for (const char* condition :
       {"!true || ", "a + ", "(case", "(case true: 1", "f(", "-", "1 <", "\"a\" + (50%:"}) {
    EXPECT_THAT(WrongWith(fmt::format("A --> case {}: B else: C", condition)), SizeIs(1))
        << condition;
    EXPECT_THAT(WrongWith(fmt::format("attr v = {}", condition)), SizeIs(1)) << condition;
    EXPECT_THAT(WrongWith(fmt::format("A --> extrude({}", condition)), SizeIs(1)) << condition;
  }
}

TEST(RuleErrors, UnknownThingsOnceEachWithTheCountOfTheirPlaces) {
  const char* text =
      "@Wobbly attr a = 1\nA --> envelope(a) B envelope(a) trim() C\nB --> envelope(2) "
      "frobnicate(x)";
  EXPECT_THAT(WrongWith(text),
              ElementsAre(StartsWith("1:1 there is no annotation '@Wobbly'"),
                          StartsWith("2:7 there is no operation 'envelope', 3 places"),
                          StartsWith("2:33 there is no operation 'trim'"),
                          StartsWith("3:19 there is no operation 'frobnicate'")));
  RuleOptions skip;
  skip.skip_unknown = true;
  EXPECT_THAT(WrongWith(text, skip), IsEmpty());
  EXPECT_THAT(WrongWith("A --> extrude(tall) trim()", skip),
              ElementsAre(StartsWith("1:15 there is no value 'tall'")));
}

TEST(RuleErrors, ImportsThatLeadNowhere) {
  RuleOptions options;
  options.importer = From({{"a.cga", "import b : \"b.cga\"\nA --> b.B"},
                           {"b.cga", "import a : \"a.cga\"\nB --> a.A"},
                           {"bad.cga", "B --> extrude(\n"}});
  EXPECT_THAT(ErrorOf("import x : \"none.cga\"", options), StartsWith("1:12 there is no file"));
  EXPECT_THAT(ErrorOf("import a : \"a.cga\"\nLot --> a.A", options), HasSubstr("imports itself"));
  EXPECT_THAT(ErrorOf("import x : \"none.cga\"\nA --> x.B x.C(x.d)", options),
              StartsWith("1:12 there is no file"));
  EXPECT_THAT(ErrorOf("import x : \"none.cga\""), HasSubstr("can't be imported here"));
  EXPECT_THAT(ErrorOf("import b : \"bad.cga\"", options), StartsWith("2:1 expected a value"));
  options.importer = From({{"c.cga", "attr height = 1"}});
  EXPECT_THAT(ErrorOf("import c : \"c.cga\" (heigth = 3)", options),
              HasSubstr("did you mean 'height'?"));
  EXPECT_THAT(ErrorOf("import c : \"c.cga\"\nimport c : \"c.cga\"", options),
              HasSubstr("two imports"));
  EXPECT_THAT(ErrorOf("import c (Blue) : \"c.cga\"", options), HasSubstr("has no style 'Blue'"));
  EXPECT_THAT(ErrorOf("import c : \"c.cga\"\nA --> c.Rof", options),
              HasSubstr("there is no rule 'c.Rof'"));
}

TEST(RuleErrors, ManyImportsOfManyAreRefused) {
  std::map<std::string, std::string> files;
  for (int i = 0; i < 20; ++i) {
    files[fmt::format("{}.cga", i)] =
        fmt::format("import a : \"{0}.cga\"\nimport b : \"{0}.cga\"\n", i + 1);
  }
  files["20.cga"] = "A --> NIL";
  RuleOptions options;
  options.importer = From(files);
  EXPECT_THAT(WrongWith("import a : \"0.cga\"", options),
              testing::Contains(HasSubstr("too many files")));
}

TEST(RuleErrors, StylesAreCheckedThoughNobodyAsksForThem) {
  EXPECT_THAT(
      WrongWith(
          "attr h = 1\nA --> extrude(h)\nstyle S\nattr h = \"x\"\nstyle T extends U\nattr h = 2\n"
          "style V extends V"),
      ElementsAre(HasSubstr("2:15 the distance of extrude"),
                  HasSubstr("5:17 there is no style 'U'"),
                  HasSubstr("7:17 the style 'V' is based on itself")));
}

TEST(RuleErrors, TheStartIsARuleWithoutParameters) {
  RuleOptions options;
  options.start = "Lott";
  EXPECT_EQ(ErrorOf("Lot --> extrude(1)", options),
            "there is no rule 'Lott' to start with; did you mean 'Lot'?");
  options.start = "Lot";
  EXPECT_THAT(ErrorOf("Lot(h) --> extrude(h)", options), HasSubstr("has parameters"));
  EXPECT_THAT(WrongWith("Lot --> extrude(1)", options), IsEmpty());
}

TEST(RuleErrors, OfTreesStandAmongThoseOfRules) {
  EXPECT_THAT(WrongWith("A --> extrud(1)\ntree t {\n  .A:nroth --> extrude(1)\n}\nB --> extrude()"),
              ElementsAre(StartsWith("1:7 "), StartsWith("3:6 there is no filter 'nroth'"),
                          StartsWith("5:7 ")));
}

TEST(RuleErrors, TheFirstFiftyAreTold) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += fmt::format("A{} --> extrude()\n", i);
  EXPECT_THAT(WrongWith(text), SizeIs(50));
}

TEST(RuleErrors, NestingHasItsLimits) {
  const auto repeated = [](std::string_view part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
  };
  const int many = 100'000;
  for (const std::string& text :
       {"attr a = " + repeated("(", many), "attr a = " + repeated("-", many),
        "attr a = " + repeated("sin(", many), "attr a = 1" + repeated(" + 1", many),
        "attr a = " + repeated("case true: 1 else: ", many),
        "attr a = " + repeated("50%: 1 else: ", many), "A --> " + repeated("split(x) { 1: ", many),
        "A --> " + repeated("case true: B else: ", many), "A --> split(x) " + repeated("{ ", many),
        "A --> B(" + repeated("!", many)}) {
    const auto wrong = WrongWith(text);
    ASSERT_FALSE(wrong.empty()) << text.substr(0, 40);
    EXPECT_THAT(wrong[0], HasSubstr("nested more than")) << text.substr(0, 40);
  }
}

TEST(RuleErrors, ManyMistakesAreNoTrouble) {
  std::string text;
  for (int i = 0; i < 20'000; ++i) {
    text += fmt::format("R{} --> frob{}(x{}) extrude(f{}(1)) set(a{}, 1) T{} @S{}\n", i, i, i, i, i,
                        i, i);
  }
  EXPECT_THAT(WrongWith(text), SizeIs(50));
  std::string styles;
  for (int i = 0; i < 20'000; ++i)
    styles += fmt::format("style S{} extends S{}\nattr a = {}\n", i + 1, i, i);
  EXPECT_THAT(WrongWith(styles), testing::Contains(HasSubstr("64 styles at most")));
}

TEST(RuleErrors, ArraysAreNamedWhereTheyStand) {
  const std::string list =
      "arrays are not read; write a list, \"3;4;5\": float(listItem(list, 0)) is its first number";
  EXPECT_THAT(
      WrongWith("attr a = [1, 2, 3]\n"
                "const b = float[]\n"
                "f(x) = a[x] + 1\n"
                "Lot --> extrude(f(1)[0]) A(b)\n"
                "B --> set(a[1], 3) C\n"),
      ElementsAre("1:10 " + list, "2:11 " + list, "3:8 " + list, "4:17 " + list, "5:11 " + list));
  EXPECT_THAT(
      WrongWith("attr a = \"1;2\"\nLot --> extrude(sum(a)) A"),
      ElementsAre("2:17 there is no function 'sum'; arrays are not read; functions of lists "
                  "are listSize, listItem …"));
}

TEST(RuleErrors, SwitchingOffWhatIsNeverDoneMeansNothing) {
  EXPECT_EQ(Written("A --> set(trim.vertical, false) set(trim.horizontal, false) B"), "A --> B\n");
  EXPECT_THAT(WrongWith("A --> set(trim.vertical, true) B"), SizeIs(1));
}

TEST(RuleErrors, LongTextsAreNoTrouble) {
  std::string rules, alternatives = "A --> split(x) { ", statements = "B --> ", cases = "C --> ";
  for (int i = 0; i < 20'000; ++i) {
    rules += fmt::format("R{} --> extrude({}) R{}\n", i, i % 7 + 1, i + 1);
    alternatives += fmt::format("{}: S{} | ", i + 1, i);
    statements += "[ extrude(1) T ] ";
    cases += fmt::format("case split.index == {}: U{} ", i, i);
  }
  const std::string text =
      rules + alternatives + "~1: Z }\n" + statements + "\n" + cases + "else: V\n";
  EXPECT_THAT(WrongWith(text), IsEmpty());
}

}  // namespace
}  // namespace parti::grammar::tests
