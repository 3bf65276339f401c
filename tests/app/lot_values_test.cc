#include "app/lot_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/document_record.h"
#include "grammar/rules/rule_text.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;

grammar::RuleSet RulesFrom(const std::string& text) {
  auto rules = grammar::ParseRules(text, "house.cga", {});
  EXPECT_TRUE(rules);
  return rules ? std::move(*rules) : grammar::RuleSet();
}

const std::string kRules = R"(@Range(1, 9) attr floors = 2
attr flat = false
@Enum("brick", "wood") attr wall = "brick"
const height = 3
Lot --> extrude(floors * height) Mass
)";

Lot LotWith(const std::string& properties) {
  Lot lot = ParseLots("rect(9,6)")->at(0);
  lot.name = "b";
  lot.properties = PropertiesIn(*ParseJson(properties));
  return lot;
}

std::string ErrorOf(const std::string& properties) {
  const auto values = ValuesOf(LotWith(properties), RulesFrom(kRules), {});
  return values ? "no error" : FormatError(values.error());
}

TEST(LotValues, PropertiesBecomeValuesOfAttributesOfTheSameName) {
  const auto values = ValuesOf(LotWith(R"({"wall":"wood","flat":true,"floors":4,"a":1,"z":[]})"),
                               RulesFrom(kRules), {});
  ASSERT_TRUE(values);
  ASSERT_EQ(values->size(), 3u);
  EXPECT_EQ(values->at(0).value, grammar::Value(4.0));
  EXPECT_EQ(values->at(1).value, grammar::Value(true));
  EXPECT_EQ(values->at(2).value, grammar::Value("wood"));
}

TEST(LotValues, NumbersAndTruthsMayStandInQuotes) {
  const auto values =
      ValuesOf(LotWith(R"({"floors":"4","flat":"true","wall":"wood"})"), RulesFrom(kRules), {});
  ASSERT_TRUE(values);
  EXPECT_EQ(values->at(0).value, grammar::Value(4.0));
  EXPECT_EQ(values->at(1).value, grammar::Value(true));
}

TEST(LotValues, ConstantsNullAndOtherCapitalsArePassedOver) {
  const auto values =
      ValuesOf(LotWith(R"({"height":9,"floors":null,"Floors":99})"), RulesFrom(kRules), {});
  ASSERT_TRUE(values);
  EXPECT_TRUE(values->empty());
}

TEST(LotValues, WhatAnAttributeDoesNotTakeIsAnErrorThatNamesLotAndProperty) {
  for (const char* properties : {R"({"floors":"4 m"})", R"({"floors":""})", R"({"floors":true})",
                                 R"({"floors":[4]})", R"({"floors":{"a":4}})"}) {
    EXPECT_THAT(ErrorOf(properties), HasSubstr("lot 'b': property 'floors' is ")) << properties;
    EXPECT_THAT(ErrorOf(properties), HasSubstr("not a number")) << properties;
  }
  EXPECT_THAT(ErrorOf(R"({"flat":1})"), HasSubstr("property 'flat' is 1, not a boolean"));
  EXPECT_THAT(ErrorOf(R"({"wall":7})"), HasSubstr("property 'wall' is 7, not a text"));
  EXPECT_THAT(ErrorOf(R"({"floors":99})"), HasSubstr("property 'floors': floors is 99"));
  EXPECT_THAT(ErrorOf(R"({"floors":99})"), HasSubstr("give a number from 1 to 9"));
  EXPECT_THAT(ErrorOf(R"({"wall":"brik"})"), HasSubstr("did you mean 'brick'?"));
}

TEST(LotValues, WhatIsSetOutsideIsNotAskedOfTheLot) {
  grammar::RuleSettings settings;
  settings.attributes = {{"floors", "5"}};
  const auto values =
      ValuesOf(LotWith(R"({"floors":"many","flat":true})"), RulesFrom(kRules), settings);
  ASSERT_TRUE(values);
  ASSERT_EQ(values->size(), 1u);
  EXPECT_EQ(values->at(0).index, 1u);
}

TEST(LotValues, DocumentsKeepThemAsTheyWere) {
  const Lot lot = LotWith(
      R"({"floors":0.1,"flat":false,"wall":"\"Höhe\"\n","list":[1,2],"object":{},"none":null})");
  EXPECT_EQ(lot.properties.size(), 5u);
  const auto back = LotsFrom(LotsText({lot, ParseLots("rect(3,3)")->at(0)}));
  ASSERT_TRUE(back) << FormatError(back.error());
  EXPECT_EQ(back->at(0).properties, lot.properties);
  EXPECT_TRUE(back->at(1).properties.empty());
}

}  // namespace
}  // namespace parti::app
