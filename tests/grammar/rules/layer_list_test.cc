// Layers as a list, and single changes of them: what the edits make of the rules agrees with it.
#include "grammar/rules/layer_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grammar/rules/rule_text.h"

namespace parti::grammar {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::string_view kRules = R"(
Lot --> extrude(9) comp(f) { front: Facade | side: Wall }
Facade --> layers("floors", "door", "sign") { Floors | Door | color("#ff0000") Sign }
Wall --> case scope.sx > 4: layers("floors") { Floors } else: layers("bare") { Door }
Floors --> segment(y) { ~3: Floor }*
Floor --> extrude(0.2)
Door --> segment(x, ~1, 2, ~1) { NIL | Leaf | NIL }
Leaf --> extrude(0.1)
Tall(h) --> extrude(h)
)";

RuleSet Rules() {
  auto rules = ParseRules(kRules, "house.cga");
  EXPECT_TRUE(rules) << FormatError(rules.error().front());
  return std::move(*rules);
}

std::vector<std::string> Names(const LayeredRule& rule) {
  std::vector<std::string> names;
  for (const ListedLayer& layer : rule.layers) names.push_back(layer.name);
  return names;
}

/// The list of what is left when the edits have been made: those that are on.
std::vector<LayeredRule> LeftBy(const RuleSet& rules, const LayerEdits& edits) {
  const auto edited = WithLayers(rules, edits);
  EXPECT_TRUE(edited) << FormatError(edited.error());
  return ListLayers(*edited, {});
}

TEST(LayerList, HasEachRulesLayersFromTheTopmostDown) {
  const auto list = ListLayers(Rules(), {});
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].rule, "Facade");
  EXPECT_THAT(list[0].layers, ElementsAre(ListedLayer{"sign", "", "", true},
                                          ListedLayer{"door", "Door", "Door", true},
                                          ListedLayer{"floors", "Floors", "Floors", true}));
  EXPECT_THAT(Names(list[1]), ElementsAre("bare", "floors")) << "those of all cases";
}

TEST(LayerList, RulesWithoutLayersAreNotInIt) {
  const auto rules = ParseRules("Lot --> extrude(3)", "plain.cga");
  ASSERT_TRUE(rules);
  EXPECT_THAT(ListLayers(*rules, {}), IsEmpty());
}

TEST(LayerList, ALayerThatIsOffStaysInItsPlace) {
  const LayerEdits off = Switched({}, "Facade", "door", false);
  const auto list = ListLayers(Rules(), off);
  EXPECT_THAT(Names(list[0]), ElementsAre("sign", "door", "floors"));
  EXPECT_FALSE(list[0].layers[1].on);
  EXPECT_THAT(Names(LeftBy(Rules(), off)[0]), ElementsAre("sign", "floors"));
  EXPECT_EQ(Switched(off, "Facade", "door", false), off) << "once";
  EXPECT_EQ(Switched(off, "Facade", "door", true), LayerEdits());
}

TEST(LayerList, AGivenRuleIsTakenBackByTheOneOfTheText) {
  const LayerEdits given = Given({}, "Facade", "door", "Leaf");
  EXPECT_EQ(ListLayers(Rules(), given)[0].layers[1], (ListedLayer{"door", "Door", "Leaf", true}));
  EXPECT_EQ(LeftBy(Rules(), given)[0].layers[1].symbol, "Leaf");
  EXPECT_EQ(ListLayers(Rules(), given)[1].layers[1].symbol, "Floors") << "of that rule alone";
  EXPECT_EQ(Given(given, "Facade", "door", ""), LayerEdits());
}

TEST(LayerList, RulesWithParametersAndThoseThatComeToTheRuleAgainAreNotOffered) {
  EXPECT_THAT(SymbolsForLayers(Rules(), "Facade"),
              ElementsAre("Wall", "Floors", "Floor", "Door", "Leaf"));
}

TEST(LayerList, MovedBackNothingIsLeftOfIt) {
  const RuleSet rules = Rules();
  const LayerEdits up = Moved({}, rules, ListLayers(rules, {})[0], 2, 0);
  EXPECT_THAT(Names(ListLayers(rules, up)[0]), ElementsAre("floors", "sign", "door"));
  EXPECT_EQ(Moved(up, rules, ListLayers(rules, up)[0], 0, 2), LayerEdits());
}

TEST(LayerList, LayersWithinRepeatedPartsAreListedAndEdited) {
  const auto rules = ParseRules(
      "Lot --> split(x) { { ~2: layers(\"a\", \"b\") { A | B } | { ~1: C }* }* }", "parts.cga");
  ASSERT_TRUE(rules) << FormatError(rules.error().front());
  const auto list = ListLayers(*rules, {});
  ASSERT_EQ(list.size(), 1u);
  EXPECT_THAT(Names(list[0]), ElementsAre("b", "a"));
  EXPECT_THAT(LayerNames(*rules), ElementsAre("Lot.a", "Lot.b"));
  EXPECT_THAT(Names(LeftBy(*rules, Switched({}, "Lot", "a", false))[0]), ElementsAre("b"));
}

RC_GTEST_PROP(LayerListProperty, WhatIsListedIsWhatTheEditsMake, ()) {
  static const RuleSet kParsed = Rules();
  LayerEdits edits;
  for (int i = *rc::gen::inRange(0, 12); i > 0; --i) {
    const LayeredRule rule = *rc::gen::elementOf(ListLayers(kParsed, edits));
    const auto count = rule.layers.size();
    const std::string layer = rule.layers[*rc::gen::inRange<size_t>(0, count)].name;
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        edits = Switched(edits, rule.rule, layer, *rc::gen::arbitrary<bool>());
        break;
      case 1: {
        auto symbols = SymbolsForLayers(kParsed, rule.rule);
        symbols.emplace_back();
        edits = Given(edits, rule.rule, layer, *rc::gen::elementOf(symbols));
        break;
      }
      default:
        edits = Moved(edits, kParsed, rule, *rc::gen::inRange<size_t>(0, count),
                      *rc::gen::inRange<size_t>(0, count));
    }
  }
  const auto edited = WithLayers(kParsed, edits);
  RC_ASSERT(edited.has_value());
  const auto left = ListLayers(*edited, {});
  for (const LayeredRule& rule : ListLayers(kParsed, edits)) {
    if (rule.rule != "Facade") continue;  // cases of one rule are laid out apart
    std::vector<ListedLayer> on;
    for (const ListedLayer& layer : rule.layers) {
      if (layer.on) on.push_back({layer.name, layer.symbol, layer.symbol, true});
    }
    const bool there = !left.empty() && left.front().rule == "Facade";
    RC_ASSERT((there ? left.front().layers : std::vector<ListedLayer>()) == on);
  }
}

}  // namespace
}  // namespace parti::grammar
