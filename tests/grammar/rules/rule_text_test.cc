// What rule files mean: each form of the language, read and written.
#include "grammar/rules/rule_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text_file.h"
#include "grammar/operation.h"
#include "grammar/rules/built_ins.h"
#include "grammar/rules/rule_settings.h"
#include "tests/grammar/rules/rule_text_support.h"
#include "tests/support/data.h"

namespace parti::grammar::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(RuleText, ReadsPlainCga) {
  const RuleSet rules = RulesFrom(R"(version "2019.0"
/* a building */
attr height = 12  // metres
# a comment, too
Lot --> extrude(height) Mass
Mass --> comp(f) { side : Facade | top : Roof }
Facade --> split(y) { 4 : Ground | { ~3 : Floor }* }
)");
  EXPECT_EQ(rules.version, "2019.0");
  ASSERT_EQ(rules.attributes.size(), 1u);
  EXPECT_EQ(rules.attributes[0].name, "height");
  ASSERT_EQ(rules.rules.size(), 3u);
  const auto& lot = rules.rules[0].body.statements;
  ASSERT_EQ(lot.size(), 2u);
  EXPECT_EQ(lot[0].operation, FindOperation("extrude"));
  EXPECT_EQ(lot[0].arguments[0].value.kind, Expression::Kind::kAttribute);
  EXPECT_EQ(lot[1].symbol, "Mass");
  EXPECT_EQ(lot[1].index, 1u);
  const auto& facade = rules.rules[2].body.statements.at(0);
  ASSERT_EQ(facade.successors.size(), 2u);
  EXPECT_EQ(std::get<Size>(facade.successors[0].key), (Size{Size::Kind::kAbsolute, 4}));
  EXPECT_EQ(facade.successors[0].body.statements.at(0).index, kNoRule);
  ASSERT_EQ(facade.successors[1].repeat.size(), 1u);
  EXPECT_EQ(std::get<Size>(facade.successors[1].repeat[0].key).kind, Size::Kind::kFloating);
}

TEST(RuleText, WritesCga) {
  EXPECT_EQ(Written(R"(Lot→extrude(12)Mass;Mass->comp(face,side){Facade}
Facade --> split("Y",4,'0.5,~1){A|B|ε}   B-->color(1,0,0) X)"),
            R"(Lot --> extrude(12) Mass
Mass --> comp(f) { side: Facade }
Facade --> split(y) { 4: A | '0.5: B | ~1: NIL }
B --> color(1, 0, 0) X
)");
}

TEST(RuleText, AStarAfterASplitIsARepeat) {
  const RuleSet rules = RulesFrom("A --> split(x) { ~3: Tile }*\nB --> segment(x) { ~3: Tile }*");
  EXPECT_EQ(rules.rules[0].body.statements[0].operation, FindOperation("repeat"));
  const Statement& segment = rules.rules[1].body.statements[0];
  EXPECT_EQ(segment.operation, FindOperation("segment"));
  ASSERT_EQ(segment.successors.size(), 1u);
  EXPECT_EQ(segment.successors[0].repeat.size(), 1u);
  EXPECT_EQ(TextOf(rules), "A --> split(x) { ~3: Tile }*\nB --> segment(x) { ~3: Tile }*\n");
}

TEST(RuleText, GroupsRepeatWithinGroups) {
  const RuleSet rules = RulesFrom("A --> split(x) { 1: B | { ~1: C | { 2: D }* }* | '0.1: E }");
  const auto& successors = rules.rules[0].body.statements[0].successors;
  ASSERT_EQ(successors.size(), 3u);
  ASSERT_EQ(successors[1].repeat.size(), 2u);
  EXPECT_EQ(successors[1].repeat[1].repeat.size(), 1u);
}

TEST(RuleText, LayersTakeTheirNamesFromTheParentheses) {
  const RuleSet rules = RulesFrom(R"(F --> layers("floors", "door") { @Floors | Door })");
  const auto& successors = rules.rules[0].body.statements[0].successors;
  ASSERT_EQ(successors.size(), 2u);
  EXPECT_EQ(std::get<std::string>(successors[0].key), "floors");
  EXPECT_TRUE(successors[0].body.statements[0].deferred);
  EXPECT_EQ(TextOf(rules), "F --> layers(\"floors\", \"door\") { @Floors | Door }\n");
}

TEST(RuleText, OperationsNestInBracesAndLongOnesBreak) {
  EXPECT_EQ(
      Written("F --> split(y) { 4: split(x) { ~1: A | 2: extrude(0.1) color(\"#ff0000\") Balcony } "
              "| ~1: Wall(1, 2) }\nWall(a, b) --> case a > 1 && b < 1: extrude(a) LongName else: "
              "extrude(b) color(\"#00ff00\") LongerName"),
      "F -->\n"
      "  split(y) {\n"
      "    4: split(x) { ~1: A | 2: extrude(0.1) color(\"#ff0000\") Balcony } |\n"
      "    ~1: Wall(1, 2)\n"
      "  }\n"
      "Wall(a, b) -->\n"
      "  case a > 1 && b < 1: extrude(a) LongName\n"
      "  else: extrude(b) color(\"#00ff00\") LongerName\n");
}

TEST(RuleText, PushAndPop) {
  EXPECT_EQ(Written("A --> [ extrude(1) B ] C"), "A --> [ extrude(1) B ] C\n");
}

TEST(RuleText, AnEmptyBodyLeavesTheShape) {
  const RuleSet rules = RulesFrom("A -->\nB --> split(x) { 1: | ~1: C }");
  EXPECT_THAT(rules.rules[0].body.statements, IsEmpty());
  EXPECT_THAT(rules.rules[1].body.statements[0].successors[0].body.statements, IsEmpty());
  EXPECT_EQ(TextOf(rules), "A -->\nB --> split(x) { 1: [ ] | ~1: C }\n");
}

TEST(RuleText, ACaseThatChangesNothingIsAnEmptyPair) {
  const RuleSet rules = RulesFrom("A --> case split.index > 0: [ [ ] ] else: B");
  EXPECT_THAT(rules.rules[0].body.alternatives[0].body->statements, IsEmpty());
  EXPECT_EQ(TextOf(rules), "A --> case split.index > 0: [ ] else: B\n");
}

TEST(RuleText, CasesAndChancesNest) {
  EXPECT_EQ(Written(R"(attr h = 3
A --> case h > 2 && h != 4: case h == 3: X else: Y
      case h < 1: 50%: P 30%: Q else: R
      else: Z)"),
            "attr h = 3\n\n"
            "A -->\n"
            "  case h > 2 && h != 4: case h == 3: X else: Y\n"
            "  case h < 1: 50%: P 30%: Q else: R\n"
            "  else: Z\n");
}

TEST(RuleText, ChancesOfAHundredPercentNeedNoElse) {
  const RuleSet rules = RulesFrom("A --> 70%: B 30%: C\nf = 70%: 1 30%: 2\nx --> extrude(f)");
  const Body& body = rules.rules[0].body;
  ASSERT_EQ(body.alternatives.size(), 2u);
  EXPECT_TRUE(body.alternatives[0].condition);
  EXPECT_FALSE(body.alternatives[1].condition);
  EXPECT_EQ(rules.functions[0].value.operands.size(), 3u);
  EXPECT_EQ(TextOf(rules), "f = 70%: 1 else: 2\n\nA --> 70%: B else: C\nx --> extrude(f)\n");
}

TEST(RuleText, WeightsMayBeNamed) {
  EXPECT_EQ(Written("attr p = 30\nA --> p%: B else: C"), "attr p = 30\n\nA --> p%: B else: C\n");
}

TEST(RuleText, RulesOfOneSymbolDifferInTheirParameters) {
  const RuleSet rules =
      RulesFrom("A --> A(3)\nA(h) --> extrude(h) A(h, \"x\")\nA(h, t) --> tag(t) B");
  EXPECT_EQ(rules.rules[0].body.statements[0].index, 1u);
  EXPECT_EQ(rules.rules[1].body.statements[1].index, 2u);
  EXPECT_EQ(rules.rules[2].parameters[0].type, ValueType::kNumber);
  EXPECT_EQ(rules.rules[2].parameters[1].type, ValueType::kText);
  EXPECT_EQ(RuleFor(rules, "A"), 0u);
}

TEST(RuleText, ADotAfterASymbolLooksForNoRule) {
  const RuleSet rules = RulesFrom("Lot --> case scope.sx > 3: Lot. else: Low.\nLow --> Lot");
  const auto& cases = rules.rules[0].body.alternatives;
  EXPECT_EQ(cases[0].body->statements.at(0).symbol, "Lot");
  EXPECT_EQ(cases[0].body->statements.at(0).index, kNoRule);
  EXPECT_EQ(cases[1].body->statements.at(0).index, kNoRule);
  EXPECT_EQ(Written("A --> Wall. B.\nB --> Roof.\n"), "A --> Wall B.\nB --> Roof\n");
}

TEST(RuleText, ArgumentsMayBeCasesAndChances) {
  EXPECT_EQ(Written("Lot --> extrude(case scope.sx > 3: 2 else: 4) Mass(30%: 1 else: 2)\n"
                    "Mass(h) --> s('1, max(30%: h else: 2, 3), '1)\n"),
            "Lot --> extrude((case scope.sx > 3: 2 else: 4)) Mass((30%: 1 else: 2))\n"
            "Mass(h) --> s('1, max((30%: h else: 2), 3), '1)\n");
}

TEST(RuleText, ReadsAndWritesOffsetAsCgaDoes) {
  EXPECT_EQ(Written("A --> [ offset(-1, border) extrude(1) Rim ] offset(-2, inside) B"),
            "A --> [ offset(-1) comp(f) { border: extrude(1) Rim } ] "
            "offset(-2) comp(f) { inside: B }\n");
  EXPECT_EQ(Written("A --> offset(-2, inside) offset(1) X"),
            "A --> offset(-2) comp(f) { inside: offset(1) comp(f) { inside: X | border: X } }\n");
  EXPECT_EQ(Written("A --> offset(-1) { border: Rim | inside: Inner }"),
            "A --> offset(-1) comp(f) { border: Rim | inside: Inner }\n");
  EXPECT_EQ(Written("A --> offset(-1) comp(f) { border: Rim | all: Inner } B"),
            "A --> [ offset(-1) comp(f) { border: Rim | inside: Inner } ] B\n")
      << "CityEngine would make B of what the offset left";
  EXPECT_EQ(Written("A --> [ offset(-1) comp(f) { inside: B } ] C"),
            "A --> [ offset(-1) comp(f) { inside: B } ] C\n");
  EXPECT_EQ(Written("A --> [ t(1, 0, 0) offset(-1) comp(f) { inside: B } ] C"),
            "A --> [ t(1, 0, 0) offset(-1) comp(f) { inside: B } ] C\n");
  EXPECT_EQ(Written("A --> offset(-1) { inside: B | inside: C }"),
            "A --> offset(-1) { inside: B | inside: C }\n")
      << "CGA has no such thing";
  EXPECT_EQ(Written("A --> innerRect [ t(1, 0, 0) B ] C"),
            "A --> innerRectangle(scope) { shape: [ t(1, 0, 0) B ] C }\n");
  EXPECT_EQ(Written("A --> offset(-1, all)"),
            "A --> offset(-1) comp(f) { inside: [ ] | border: [ ] }\n");
}

TEST(RuleText, ACaseInBracketsBecomesARule) {
  EXPECT_EQ(Written("A(h) --> [ case h > 3: t(0, 1, 0) B else: [ C ] D ] E"),
            "A_branch1(h) --> case h > 3: t(0, 1, 0) B else: [ C ] D\n"
            "A(h) --> [ A_branch1(h) ] E\n");
  EXPECT_THAT(WrongWith("A --> [ 30%: B else: C"), SizeIs(2));
}

TEST(RuleText, ReadsAndWritesScatterAsCgaDoes) {
  EXPECT_EQ(
      Written("A --> [ scatter(surface, 9, gaussian, center, '0.16, rand(999999999)) Tree ] B"),
      "A --> scatter(surface, 9, gaussian) { Tree } B\n");
  EXPECT_EQ(Written("A --> scatter(surface, 9, gaussian, center, '0.1) { t(0, 1, 0) [ i(\"a\") A ] "
                    "scatter(scope, 2, uniform) { B } } C"),
            "A --> scatter(surface, 9, gaussian, center, '0.1) { t(0, 1, 0) [ i(\"a\") A ] "
            "scatter(scope, 2, uniform) { B } } C\n");
  EXPECT_EQ(Written("A --> scatter(surface, 9, uniform, center, 0.5, 3) Tree"),
            "A --> scatter(surface, 9, uniform, 0.5, 3) Tree\n")
      << "a seed of its own is ours";
}

TEST(RuleText, ReadsWordsOfFunctionsAndSelectorsOfObjects) {
  EXPECT_EQ(Written("A --> case geometry.angle(maxSlope) > 2: B else: C"),
            "A --> case geometry.angle(maxSlope) > 2: B else: C\n");
  EXPECT_EQ(Written("A(top) --> extrude(geometry.area(top)) B(geometry.area(\"top\"))\nB(x) --> C"),
            "A(top) --> extrude(geometry.area(top)) B(geometry.area(\"top\"))\nB(x) --> C\n");
  EXPECT_EQ(Written("A --> comp(f) { object.front = B | all = C }"),
            "A --> comp(f) { world.south: B | all: C }\n");
}

TEST(RuleText, SetsTheMaterialAndDoesWithoutParentheses) {
  EXPECT_EQ(Written("A --> set(material.opacity, 0.5) reverseNormals alignScopeToAxes B"),
            "A --> set(material.opacity, 0.5) reverseNormals() alignScopeToAxes() B\n");
}

TEST(RuleText, SplitsAlongUInMetresGoAlongX) {
  EXPECT_EQ(Written("A --> split(u, unitSpace, 0) { 2: B | ~1: C }"),
            "A --> split(x) { 2: B | ~1: C }\n");
  EXPECT_EQ(Written("A --> split(v, unitSpace, 0) { ~2: B }*"), "A --> split(y) { ~2: B }*\n");
  EXPECT_THAT(WrongWith("A --> split(u, uvSpace, 0) { 2: B }"), SizeIs(1));
}

TEST(RuleText, PartsMayBeNumbersOrWords) {
  EXPECT_EQ(Written("A --> alignScopeToGeometry(yUp, 0, longest) B(2)\n"
                    "B(i) --> alignScopeToGeometry(zUp, any, i + 1) C"),
            "A --> alignScopeToGeometry(yUp, 0, longest) B(2)\n"
            "B(i) --> alignScopeToGeometry(zUp, any, i + 1) C\n");
}

TEST(RuleText, ExtrudeTakesADirection) {
  const RuleSet rules = RulesFrom("A --> extrude(world.up, 3) B");
  EXPECT_EQ(rules.rules[0].body.statements[0].operation, FindOperation("extrudeAlong"));
  EXPECT_EQ(Written("A --> extrude(world.up.flatTop, 3) B"),
            "A --> extrude(world.up.flatTop, 3) B\n");
}

TEST(RuleText, OperatorsBindAsInCga) {
  const auto shown = [](const char* text) {
    const RuleSet rules = RulesFrom(std::string("attr a = 1 attr b = 2 attr c = ") + text);
    return rules.attributes.size() == 3 ? TextOf(rules, rules.attributes[2].value) : "";
  };
  EXPECT_EQ(shown("a+b*2-(3-a)"), "a + b * 2 - (3 - a)");
  EXPECT_EQ(shown("(a+b)+2"), "a + b + 2");
  EXPECT_EQ(shown("a+(b+2)"), "a + (b + 2)");
  EXPECT_EQ(shown("-a*-3 % 2"), "-a * -3 % 2");
  EXPECT_EQ(shown("-(a+b)"), "-(a + b)");
  EXPECT_EQ(shown("!(a<b)||a==b&&b>=1"), "!(a < b) || a == b && b >= 1");
  EXPECT_EQ(shown("(a<b||true)&&false"), "(a < b || true) && false");
  EXPECT_EQ(shown("\"h\" + a + \"m\""), "\"h\" + a + \"m\"");
  EXPECT_EQ(shown("min(a, max(b, 3)) / sqrt(2)"), "min(a, max(b, 3)) / sqrt(2)");
  EXPECT_EQ(shown("2 * (case a > 1: 3 else: 4)"), "2 * (case a > 1: 3 else: 4)");
  EXPECT_EQ(shown("a - -b"), "a - -b");
  EXPECT_EQ(shown("rand() + rand(2,3)"), "rand() + rand(2, 3)");
}

TEST(RuleText, TypesAreInferredAcrossRulesAndFunctions) {
  const RuleSet rules = RulesFrom(R"(
Lot --> Wall("brick", true)
Wall(kind, wet) --> Paint(kind, wet)
Paint(kind, wet) --> case wet: tag(name(kind)) X else: NIL
name(k) = prefix(k) + "-wall"
prefix(p) = p)");
  for (size_t i = 1; i <= 2; ++i) {
    EXPECT_EQ(rules.rules[i].parameters[0].type, ValueType::kText);
    EXPECT_EQ(rules.rules[i].parameters[1].type, ValueType::kBool);
  }
  EXPECT_EQ(rules.functions[1].parameters[0].type, ValueType::kText);
  EXPECT_EQ(rules.functions[1].value.type, ValueType::kText);
}

TEST(RuleText, NamesOfTheShapeAreBuiltIns) {
  const RuleSet rules = RulesFrom("A --> case split.index == 0 && scope.sx > 2: B else: NIL");
  const Expression& both = *rules.rules[0].body.alternatives[0].condition;
  EXPECT_EQ(both.operands[0].operands[0].built_in, FindBuiltIn("split.index", 0));
  EXPECT_EQ(both.operands[1].operands[0].built_in, FindBuiltIn("scope.sx", 0));
}

TEST(RuleText, SetNamesAnAttribute) {
  const RuleSet rules = RulesFrom("attr h = 1\nA --> set(h, h + 1) B");
  const Statement& set = rules.rules[0].body.statements[0];
  EXPECT_EQ(set.kind, Statement::Kind::kSet);
  EXPECT_EQ(set.index, 0u);
  EXPECT_EQ(TextOf(rules), "attr h = 1\n\nA --> set(h, h + 1) B\n");
}

TEST(RuleText, AnnotationsOfAttributes) {
  const char* text =
      "@Group(\"Size\") @Order(2) @Description(\"of a floor\") @Range(2.4, 6) @Distance\n"
      "attr floor_height = 3\n"
      "@Range(min=0, max=1, stepsize=0.1) @Hidden\n"
      "attr part = 0.5\n"
      "@Color @Enum(\"#ff0000\", \"#00ff00\")\n"
      "attr paint = \"#ff0000\"\n";
  const RuleSet rules = RulesFrom(text);
  EXPECT_EQ(rules.attributes[0].group, "Size");
  EXPECT_EQ(rules.attributes[0].low, 2.4);
  EXPECT_EQ(rules.attributes[0].high, 6);
  EXPECT_EQ(rules.attributes[1].step, 0.1);
  EXPECT_TRUE(rules.attributes[1].hidden);
  EXPECT_EQ(rules.attributes[2].use, Attribute::Use::kColor);
  EXPECT_EQ(rules.attributes[2].choices.size(), 2u);
  EXPECT_EQ(TextOf(rules), text);
}

TEST(RuleText, ARangeMayBeAProposal) {
  EXPECT_EQ(Written("@Range(min=1, max=4, restricted=false)\nattr h = 2\nA --> X"),
            "@Range(min=1, max=4, restricted=false)\nattr h = 2\n\nA --> X\n");
  EXPECT_EQ(Written("@Range(min=1, max=4, restricted=true)\nattr h = 2\nA --> X"),
            "@Range(1, 4)\nattr h = 2\n\nA --> X\n");
}

TEST(RuleSettings, WhatAPersonGivesIsHeldToRangeAndEnum) {
  const RuleSet rules = RulesFrom(
      "@Range(1, 4)\nattr a = 2\n@Range(min=1, max=4, restricted=false)\nattr b = 2\n"
      "@Enum(\"gable\", \"hip\")\nattr c = \"hip\"\n@Range(min=0)\nattr d = 1\nattr e = 1\nA --> "
      "X");
  const auto says = [&](size_t i, const Value& value) {
    const auto allowed = CheckAllowed(rules.attributes[i], value);
    return allowed ? std::string() : allowed.error().message + "; " + allowed.error().hint;
  };
  EXPECT_EQ(says(0, 4.0), "");
  EXPECT_EQ(says(0, 4.5), "a is 4.5; give a number from 1 to 4");
  EXPECT_EQ(says(1, 99.0), "");
  EXPECT_EQ(says(2, std::string("gabel")), "c can't be 'gabel'; did you mean 'gable'?");
  EXPECT_EQ(says(2, std::string("flat")), "c can't be 'flat'; it is one of gable, hip");
  EXPECT_EQ(says(3, -1.0), "d is -1; give a number from 0 on");
  EXPECT_EQ(says(4, -1e9), "");
}

TEST(RuleText, ARangeOfNamedValuesIsAChoice) {
  const RuleSet rules = RulesFrom("@Range(Low=0, High=2)\nattr lod = 0\nA --> X");
  EXPECT_THAT(rules.attributes[0].choices, ElementsAre(Value(0.0), Value(2.0)));
  EXPECT_FALSE(rules.attributes[0].low);
  EXPECT_THAT(WrongWith("@Range(mim=0, max=2)\nattr lod = 0\nA --> X"), SizeIs(1));
}

TEST(RuleText, AnAtSignAnnotatesAtTheStartOfALineAndDefersElsewhere) {
  const RuleSet rules = RulesFrom("A --> @B\n@StartRule\nB --> extrude(1) @Handle(axis=x)\nC --> D",
                                  {.skip_unknown = true});
  ASSERT_EQ(rules.rules.size(), 3u);
  EXPECT_TRUE(rules.rules[0].body.statements.at(0).deferred);
  EXPECT_TRUE(rules.rules[1].start);
  EXPECT_EQ(rules.rules[1].body.statements.size(), 1u);
}

TEST(RuleText, StylesRedefineWhatTheyName) {
  const char* text = R"(attr h = 3
Lot --> extrude(h) Shape
Shape --> color("#ff0000")

style High
attr h = 30

style Blue extends High
Shape --> color("#0000ff") Tip
)";
  const RuleSet plain = RulesFrom(text);
  ASSERT_EQ(plain.styles.size(), 2u);
  EXPECT_EQ(plain.styles[1].base, "High");
  EXPECT_EQ(plain.attributes[0].value.constant, Value(3.0));
  const RuleSet blue = RulesFrom(text, {.style = "Blue"});
  EXPECT_EQ(blue.style, "Blue");
  EXPECT_EQ(blue.attributes[0].value.constant, Value(30.0));
  EXPECT_EQ(blue.rules[1].body.statements.size(), 2u);
  EXPECT_TRUE(RulesFrom(TextOf(plain)) == plain);
  EXPECT_TRUE(RulesFrom(TextOf(blue)) == blue);
  EXPECT_THAT(WrongWith(text, {.style = "Bleu"}),
              ElementsAre("there is no style 'Bleu'; did you mean 'Blue'?"));
}

TEST(RuleText, ImportsHavePrefixes) {
  const RuleOptions options{.importer = From({{"roof.cga", R"(
attr slope = 30
attr height = 1
const k = 2
pitch(x) = x * k
Roof --> extrude(pitch(slope)) Tiles
Tiles --> color("#ff0000")
)"}})};
  const char* text =
      "import low : \"roof.cga\" (slope = 10 + base)\n"
      "import high : \"roof.cga\" ()\n"
      "attr base = 5\n"
      "attr height = 12\n"
      "Lot --> low.Roof high.Roof extrude(low.pitch(3))\n";
  const RuleSet rules = RulesFrom(text, options);
  ASSERT_EQ(rules.files.size(), 3u);
  ASSERT_EQ(rules.rules.size(), 5u);
  EXPECT_EQ(rules.rules[1].symbol, "low.Roof");
  EXPECT_EQ(rules.rules[0].body.statements[0].index, 1u);
  EXPECT_EQ(rules.rules[1].body.statements[1].symbol, "low.Tiles");
  const auto value = [&](std::string_view name) {
    for (const Attribute& a : rules.attributes) {
      if (a.name == name) return TextOf(rules, a.value);
    }
    return std::string("none");
  };
  EXPECT_EQ(value("low.slope"), "10 + base");
  EXPECT_EQ(value("low.height"), "height");
  EXPECT_EQ(value("high.slope"), "30");
  EXPECT_EQ(value("high.height"), "1");
  EXPECT_TRUE(RulesFrom(TextOf(rules), options) == rules) << TextOf(rules);
}

TEST(RuleText, HoldsTreesBesidesRules) {
  const RuleSet rules = RulesFrom(R"(Lot --> extrude(3) Mass
tree ornaments { .Mass#x --> color("#ff0000") }
Mass --> comp(f) { all: Face })");
  EXPECT_EQ(rules.rules.size(), 2u);
  ASSERT_EQ(rules.trees.size(), 1u);
  EXPECT_EQ(rules.trees[0].nodes.size(), 1u);
  EXPECT_TRUE(RulesFrom(TextOf(rules)) == rules);
}

TEST(RuleText, SkipsWhatIsUnknownWhenAsked) {
  const RuleSet rules = RulesFrom(
      "@Wobbly(3) attr a = 1\nA --> envelope(world.up, 3) { side: extrude(a) } "
      "insertAlongUV(\"x\") B\n"
      "B --> insertAlongUV(\"y\") C",
      {.skip_unknown = true});
  EXPECT_THAT(rules.skipped, ElementsAre("annotation '@Wobbly'", "operation 'envelope'",
                                         "operation 'insertAlongUV', 2 places"));
  EXPECT_EQ(rules.rules[0].body.statements.size(), 1u);
}

TEST(RuleText, NothingIsAnEmptySet) {
  for (const char* text : {"", " \n", "// nothing", "\xef\xbb\xbf"}) {
    EXPECT_EQ(TextOf(RulesFrom(text)), "");
  }
}

TEST(RuleText, ReadsTheScenes) {
  for (const char* name : {"scenes/houses.cga", "scenes/facade.cga"}) {
    PARTI_NEED_DATA(path, std::string("../") + name);
    const auto text = ReadFile(path);
    ASSERT_TRUE(text);
    Written(*text);
  }
}

}  // namespace
}  // namespace parti::grammar::tests
