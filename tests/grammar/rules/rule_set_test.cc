// Rule files as values: equality, and finding rules and places in them.
#include "grammar/rules/rule_set.h"

#include <gtest/gtest.h>

#include "grammar/operation.h"

namespace parti::grammar {
namespace {

Expression Constant(Value value) {
  Expression expression;
  expression.type = TypeOf(value);
  expression.constant = std::move(value);
  return expression;
}

/// "Lot --> case true: extrude(HEIGHT) Mass else: NIL" without text.
RuleSet Extrusion(double height) {
  Statement extrude;
  extrude.operation = FindOperation("extrude");
  extrude.arguments = {{Constant(height)}};
  Statement symbol;
  symbol.kind = Statement::Kind::kSymbol;
  symbol.symbol = "Mass";
  symbol.index = kNoRule;
  Body body;
  body.statements = {extrude, symbol};
  Rule lot;
  lot.symbol = "Lot";
  lot.body.kind = Body::Kind::kCase;
  lot.body.alternatives = {{Constant(true), std::make_shared<const Body>(body)},
                           {std::nullopt, std::make_shared<const Body>()}};
  RuleSet set;
  set.rules = {lot};
  return set;
}

TEST(RuleSet, EqualsByValueNotByPlace) {
  RuleSet a = Extrusion(12);
  RuleSet b = Extrusion(12);
  b.files = {{"other.cga", "Lot --> extrude(12)"}};
  b.rules[0].range = {0, 4, 7};
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a == Extrusion(13));
  b.rules[0].start = true;
  EXPECT_FALSE(a == b);
}

TEST(RuleSet, FindsTheRuleWithoutParameters) {
  RuleSet set = Extrusion(12);
  Rule tower;
  tower.symbol = "Tower";
  tower.parameters = {{"h", ValueType::kNumber}};
  set.rules.push_back(tower);
  EXPECT_EQ(RuleFor(set, "Lot"), 0u);
  EXPECT_EQ(RuleFor(set, "Tower"), kNoRule);
  EXPECT_EQ(RuleFor(set, "Lott"), kNoRule);
}

TEST(RuleSet, NamesThePlaceOfARange) {
  RuleSet set;
  set.files = {{"a.cga", "A --> B"}, {"b.cga", "// first\nLot --> extrude(12)"}};
  const SourcePlace place = PlaceOf(set, {1, 17, 24});
  EXPECT_EQ(place.file, "b.cga");
  EXPECT_EQ(place.line, 2);
  EXPECT_EQ(place.column, 9);
  EXPECT_EQ(place.length, 7);
}

}  // namespace
}  // namespace parti::grammar
