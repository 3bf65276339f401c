#include "grammar/rules/rule_derivation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/info.h>

#include <set>

#include "grammar/operation.h"
#include "grammar/rules/rule_workers.h"
#include "tests/grammar/rules/derived_by_rules.h"

namespace parti::grammar {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

size_t CountOf(const ShapeTree& tree, std::string_view symbol) {
  size_t count = 0;
  for (const std::string& name : Visible(tree)) count += name == symbol ? 1 : 0;
  return count;
}

TEST(RuleDerivation, OperationsOfOneBodyMakeOneLevel) {
  const ShapeTree tree = ByRules(R"(
    Lot --> extrude(6) Mass
    Mass --> comp(f) { side: Facade | top: Roof }
    Facade --> split(y) { ~3: Floor }*
  )");
  EXPECT_THAT(Outline(tree), HasSubstr(". Lot, 0 Mass, 0/0 Roof, 0/1 Facade, 0/1/0 Floor"));
  EXPECT_EQ(CountOf(tree, "Floor"), 8u);
}

TEST(RuleDerivation, ASuccessorMayBeASequenceAndItsChildBecomesTheResult) {
  const ShapeTree tree = ByRules(R"(
    Lot --> split(x) { 5: extrude(2) color("#ff0000") Box | ~1: NIL | 5: Flat }
  )");
  EXPECT_EQ(Outline(tree), ". Lot, 0 Box, 1 Flat");
  EXPECT_EQ(tree[1].item.type, ItemType::kVolume);
  EXPECT_EQ(tree[1].item.color_rgb, 0xff0000u);
  EXPECT_EQ(tree[1].operation->name, "extrude");
}

TEST(RuleDerivation, ASuccessorThatMakesSeveralHasAShapeOfItsOwn) {
  const ShapeTree tree = ByRules(R"(
    Lot --> split(x) { ~1: split(y) { ~1: A | ~1: B } | ~1: C }
  )");
  EXPECT_EQ(Outline(tree), ". Lot, 0 -, 0/0 A, 0/1 B, 1 C");
}

TEST(RuleDerivation, ABodyThatMakesNoChildLeavesOneWithoutSymbol) {
  EXPECT_EQ(Outline(ByRules("Lot --> extrude(3)")), ". Lot, 0 -");
  const ShapeTree colored = ByRules("Lot --> color(\"#00ff00\") tag(\"ground\")");
  EXPECT_EQ(Outline(colored), ". Lot");
  EXPECT_EQ(colored[0].item.color_rgb, 0x00ff00u);
  EXPECT_THAT(colored[0].tags, SizeIs(1));
}

TEST(RuleDerivation, BracketsBringBackWhatWasInHand) {
  const ShapeTree tree = ByRules(R"(
    Lot --> [ extrude(3) Mass ] Ground
  )");
  EXPECT_EQ(Outline(tree), ". Lot, 0 Mass, 1 Ground");
  EXPECT_EQ(tree[2].item.type, ItemType::kPlanar);
}

TEST(RuleDerivation, NilHidesTheShape) {
  const ShapeTree tree = ByRules(R"(
    Lot --> split(x) { ~1: A | ~1: B }
    A --> NIL
    B --> extrude(1) comp(f) { top: Top }
  )");
  EXPECT_THAT(Visible(tree), ElementsAre("Top"));
}

TEST(RuleDerivation, AShapeOfWhichNoSelectorTakesAnythingIsHidden) {
  const ShapeTree tree = ByRules(R"(
    Lot --> split(x) { ~1: A | ~1: B }
    A --> extrude(1) comp(f) { 99: Never }
  )");
  EXPECT_THAT(Visible(tree), ElementsAre("B"));
}

TEST(RuleDerivation, CasesLookAtTheShape) {
  const ShapeTree tree = ByRules(R"(
    Lot --> split(x) { ~1: Part | ~3: Part }
    Part --> case scope.sx > 6: extrude(2) Wide else: Narrow
  )");
  EXPECT_THAT(Visible(tree), ElementsAre("Narrow", "Wide"));
}

TEST(RuleDerivation, ParametersAttributesAndSetAreHandedDown) {
  const ShapeTree tree = ByRules(R"(
    attr height = 2
    Lot --> split(x) { ~1: set(height, 5) Part(1) | ~1: Part(2) }
    Part(factor) --> extrude(height * factor) Mass
  )");
  EXPECT_EQ(tree[tree.Leaves()[0]].item.scope.size.y, 5);
  EXPECT_EQ(tree[tree.Leaves()[1]].item.scope.size.y, 4);
}

TEST(RuleDerivation, SplitIndexCountsPieces) {
  const ShapeTree tree = ByRules(R"(
    Lot --> split(x) { 5: Part }*
    Part --> case split.index == split.total - 1: Last case split.index == 0: First else: Inner
  )");
  EXPECT_THAT(Visible(tree), ElementsAre("First", "Inner", "Inner", "Last"));
}

TEST(RuleDerivation, SettingsGiveAttributesAndTheStart) {
  RuleSettings settings;
  settings.start = "Tower";
  settings.attributes = {{"height", "7"}};
  const ShapeTree tree = ByRules("attr height = 2\nTower --> extrude(height) Mass", settings);
  EXPECT_EQ(tree.Name(tree[0].symbol), "Tower");
  EXPECT_EQ(tree[1].item.scope.size.y, 7);
}

TEST(RuleDerivation, WrongSettingsAreNamed) {
  constexpr std::string_view kRules = "attr height = 2\nconst top = 3\nLot --> extrude(height) M";
  RuleSettings settings;
  settings.start = "Lott";
  EXPECT_THAT(TryRules(kRules, settings).error().hint, HasSubstr("Lot"));
  settings.start = "";
  settings.attributes = {{"heigth", "7"}};
  EXPECT_THAT(TryRules(kRules, settings).error().hint, HasSubstr("height"));
  settings.attributes = {{"top", "7"}};
  EXPECT_THAT(TryRules(kRules, settings).error().message, HasSubstr("constant"));
  settings.attributes = {{"height", "seven"}};
  EXPECT_THAT(TryRules(kRules, settings).error().message, HasSubstr("seven"));
}

constexpr std::string_view kChance = R"(
  Lot --> split(x) { 1: Part }*
  Part --> 50%: extrude(rand(1, 3)) A 30%: B else: NIL
)";

TEST(RuleDerivation, ChanceFollowsTheSeedAndNothingElse) {
  RuleSettings settings;
  const std::string first = Bytes(ByRules(kChance, settings));
  EXPECT_EQ(Bytes(ByRules(kChance, settings)), first);
  settings.seed = 1;
  EXPECT_NE(Bytes(ByRules(kChance, settings)), first);
}

TEST(RuleDerivation, ChancesComeUpAsOftenAsTheySay) {
  RuleSettings settings;
  size_t a = 0, b = 0, all = 0;
  for (settings.seed = 0; settings.seed < 100; ++settings.seed) {
    const ShapeTree tree = ByRules(kChance, settings);
    a += CountOf(tree, "A");
    b += CountOf(tree, "B");
    all += 20;
  }
  EXPECT_NEAR(static_cast<double>(a) / static_cast<double>(all), 0.5, 0.05);
  EXPECT_NEAR(static_cast<double>(b) / static_cast<double>(all), 0.3, 0.05);
}

TEST(RuleDerivation, AnEditElsewhereNeverChangesADraw) {
  const std::string rest = "\nPart --> extrude(rand(1, 9)) A";
  const ShapeTree before = ByRules("Lot --> split(x) { ~1: Part | ~1: Part }" + rest);
  const ShapeTree after =
      ByRules("Lot --> split(x) { ~1: Part | ~1: split(y) { ~1: Part | ~1: Part } }" + rest);
  EXPECT_EQ(before[before.Leaves()[0]].item.scope.size.y,
            after[after.Leaves()[0]].item.scope.size.y);
}

TEST(RuleDerivation, RecursionWithoutEndIsAnErrorThatSaysSo) {
  const auto tree = TryRules("Lot --> Again\nAgain --> Other\nOther --> Again");
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().code, ErrorCode::kLimitReached);
  EXPECT_THAT(tree.error().message, HasSubstr("without end"));
  ASSERT_TRUE(tree.error().place);
  EXPECT_NE(tree.error().place->line_text.find("-->"), std::string::npos);
}

TEST(RuleDerivation, TooManyShapesAreAnErrorAndNoHang) {
  RuleSettings settings;
  settings.limits.shapes = 1000;
  const auto tree = TryRules("Lot --> split(x) { ~1: Lot | ~1: Lot }", settings);
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().code, ErrorCode::kLimitReached);
  EXPECT_THAT(tree.error().message, HasSubstr("1000 shapes"));
}

TEST(RuleDerivation, FunctionsWithoutEndAreAnError) {
  const auto tree = TryRules("f(x) = f(x + 1)\nLot --> extrude(f(1)) Mass");
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().code, ErrorCode::kLimitReached);
}

TEST(RuleDerivation, FunctionsThatTakeForeverAreAnErrorAndNoHang) {
  const auto tree = TryRules(
      "fib(n) = case n < 2: n else: fib(n - 1) + fib(n - 2)\nLot --> extrude(fib(80)) Mass");
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().code, ErrorCode::kLimitReached);
  EXPECT_THAT(tree.error().message, HasSubstr("steps of computing"));
  ASSERT_TRUE(tree.error().place);
  EXPECT_EQ(tree.error().place->line, 2);
}

TEST(RuleDerivation, ManyValuesMayTakeMoreStepsTogetherThanOneMay) {
  const auto tree = TryRules(
      "fib(n) = case n < 2: n else: fib(n - 1) + fib(n - 2)\n"
      "Lot --> split(x) { { ~0.1: extrude(fib(10)) Part }* }");
  ASSERT_TRUE(tree) << tree.error().message;
}

TEST(RuleDerivation, TextsThatGrowWithoutBoundsAreAnErrorThatFillsNoMemory) {
  for (const char* longer : {"s + s", "replace(s, \"a\", s)", "listAdd(s, s)"}) {
    const auto tree = TryRules(std::string("grow(s, n) = case n <= 0: s else: grow(") + longer +
                               ", n - 1)\nLot --> extrude(len(grow(\"aa\", 60))) Mass");
    ASSERT_FALSE(tree) << longer;
    EXPECT_EQ(tree.error().code, ErrorCode::kLimitReached) << longer;
    EXPECT_THAT(tree.error().message, HasSubstr("a text is longer than 1048576 bytes")) << longer;
  }
}

TEST(RuleDerivation, AFailureNamesRuleOperationShapeAndPlace) {
  const auto tree = TryRules("Lot --> split(x) { ~1: A | ~1: Part }\nPart --> extrude(0 * 3) Mass");
  ASSERT_FALSE(tree);
  EXPECT_THAT(tree.error().message, HasSubstr("rule Part: extrude"));
  EXPECT_THAT(tree.error().message, HasSubstr("(shape 1)"));
  ASSERT_TRUE(tree.error().place);
  EXPECT_EQ(tree.error().place->line, 2);
  EXPECT_EQ(tree.error().place->column, 10);
}

TEST(RuleDerivation, AnOperationThatATypeCantTakeStopsBeforeTheRuleRuns) {
  const auto tree = TryRules("Lot --> extrude(3) Mass\nMass --> color(\"#ffffff\") extrude(2) X");
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().code, ErrorCode::kWrongItemType);
  EXPECT_THAT(tree.error().message, HasSubstr("rule Mass: extrude can't be applied to a Volum"));
}

TEST(RuleDerivation, NothingVisibleIsAnError) {
  const auto tree = TryRules("Lot --> NIL");
  ASSERT_FALSE(tree);
  EXPECT_EQ(tree.error().code, ErrorCode::kNothingMade);
}

constexpr std::string_view kTown = R"(
  attr floor = 3
  Lot --> extrude(rand(6, 20)) Mass
  Mass --> comp(f) { side: Facade | top: 50%: Flat else: extrude(1) Attic }
  Facade --> split(y) { ~floor: Floor }*
  Floor --> split(x) { ~2: Tile }*
  Tile --> 70%: split(x) { ~1: Wall | 1: Glass | ~1: Wall } 20%: extrude(0.3) Balcony else: Wall
)";

std::vector<Item> TownLots(size_t count) {
  std::vector<Item> lots;
  for (size_t i = 0; i < count; ++i) {
    lots.push_back(LotOf(8 + static_cast<double>(i % 5), 12)[0].item);
  }
  return lots;
}

std::string BytesOf(std::string_view rules, size_t lots, int threads,
                    const RuleSettings& settings = {}) {
  const auto items = TownLots(lots);
  AwaitRuleWorkers();
  const auto trees =
      DeriveRules(RulesFrom(rules), settings, items, {threads, nullptr, nullptr, nullptr, nullptr});
  EXPECT_TRUE(trees) << FormatError(trees.error());
  std::string bytes;
  for (const ShapeTree& tree : *trees) bytes += Bytes(tree);
  return bytes;
}

TEST(RuleDerivation, RulesWrittenOutMakeTheSameShapes) {
  const std::string text = R"(
    Lot --> [ offset(-1) comp(f) { border: extrude(0.2) Curb | inside: Yard } ]
            [ offset(2) { inside: Walk } ] t(0, 3, 0) Roof
    Yard --> scatter(surface, 9, gaussian) { s(1, rand(1, 3), 1) primitiveCube() Tree } Lawn
    Lawn --> offset(-2, inside) split(x) { ~1: | ~1: [ offset(-0.5, border) Bed ] }
  )";
  const std::string written = TextOf(RulesFrom(text));
  EXPECT_THAT(written, HasSubstr("[ offset(2) comp(f) { inside: Walk } ] t(0, 3, 0) Roof"));
  EXPECT_EQ(Bytes(ByRules(text)), Bytes(ByRules(written)));
}

TEST(RuleDerivation, AnyNumberOfThreadsGivesTheSameBytes) {
  for (const size_t lots : {1u, 3u, 60u}) {
    const std::string one = BytesOf(kTown, lots, 1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(BytesOf(kTown, lots, threads), one) << lots;
  }
}

TEST(RuleDerivation, GoesOnAloneUntilThereIsHelp) {
  // Whether the threads are there at once, after some shapes or never, is up to the machine; this
  // process has asked for none yet.
  const auto items = TownLots(20);
  const auto early =
      DeriveRules(RulesFrom(kTown), {}, items, {2, nullptr, nullptr, nullptr, nullptr});
  ASSERT_TRUE(early);
  std::string bytes;
  for (const ShapeTree& tree : *early) bytes += Bytes(tree);
  EXPECT_EQ(bytes, BytesOf(kTown, 20, 1));
  AwaitRuleWorkers();
  EXPECT_EQ(AreRuleWorkersReady(), tbb::info::default_concurrency() > 1);
}

TEST(RuleDerivation, ThreadsShareOutPartsOfPartsLargeAndSmall) {
  constexpr std::string_view kChain = R"(
    Lot     --> Stairs(200)
    Stairs(n) --> case n > 0: split(x) { '0.01: Row | '0.01: split(y) { ~1: Brick }* | ~1: Stairs(n - 1) }
                  else: Top
    Row     --> split(y) { ~0.4: 50%: Brick else: split(x) { ~1: Brick | ~1: tag("small") Stone } }*
    Brick   --> extrude(0.1) Body
  )";
  const std::string one = BytesOf(kChain, 1, 1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(BytesOf(kChain, 1, threads), one);
}

TEST(RuleDerivation, LimitsAreThoseOfAllPartsTogether) {
  const auto error = [](int threads) {
    RuleSettings settings;
    settings.limits.shapes = 3000;
    const Item lot = LotOf(300, 30)[0].item;
    AwaitRuleWorkers();
    const RuleSet rules = RulesFrom(
        "Lot --> split(x) { 1: Row }*  Row --> split(y) { 1: Tile }* "
        "Tile --> extrude(1) Stone");
    const auto trees =
        DeriveRules(rules, settings, {&lot, 1}, {threads, nullptr, nullptr, nullptr, nullptr});
    return trees ? std::string() : FormatError(trees.error());
  };
  EXPECT_THAT(error(1), HasSubstr("more than 3000 shapes"));
  EXPECT_EQ(error(2), error(1));
}

TEST(RuleDerivation, AnyNumberOfThreadsGivesTheSameError) {
  AwaitRuleWorkers();
  const RuleSet rules = RulesFrom(R"(
    Lot --> split(x) { 0.1: Part }*
    Part --> case split.index == 137: extrude(0 * 1) X else: split(y) { 0.1: Leaf }*
  )");
  const Item lot = LotOf(20, 10)[0].item;
  const auto one = DeriveRules(rules, {}, {&lot, 1}, {1, nullptr, nullptr, nullptr, nullptr});
  const auto two = DeriveRules(rules, {}, {&lot, 1}, {2, nullptr, nullptr, nullptr, nullptr});
  ASSERT_FALSE(one);
  ASSERT_FALSE(two);
  EXPECT_EQ(FormatError(one.error()), FormatError(two.error()));
  EXPECT_THAT(one.error().message, HasSubstr("(shape 137)"));
}

TEST(RuleDerivation, TheFirstOfSeveralLotsThatFailsIsTheOneNamed) {
  const RuleSet rules =
      RulesFrom("height = case scope.sx > 9: 0 else: 3\nLot --> extrude(height) Mass");
  const auto lots = TownLots(5);
  const auto trees = DeriveRules(rules, {}, lots, {});
  ASSERT_FALSE(trees);
  EXPECT_THAT(trees.error().message, HasSubstr("lot-2: "));
}

TEST(RuleDerivation, AllLotsThatFailAreToldWhereTheyAreWanted) {
  const RuleSet rules = RulesFrom("attr h = 3\nLot --> extrude(h) Mass");
  const auto items = TownLots(30);
  std::vector<std::vector<GivenValue>> given(items.size());
  for (const size_t bad : {4u, 11u, 29u}) given[bad] = {{0, -20000.0}};
  AwaitRuleWorkers();
  for (const bool wants_all : {false, true}) {
    for (const int count : {1, 2, 8}) {
      LotFailures failures{wants_all, {}};
      RuleThreads threads;
      threads.count = count;
      threads.failures = &failures;
      const auto trees = DeriveRules(rules, {}, items, threads, given);
      ASSERT_FALSE(trees);
      EXPECT_THAT(trees.error().message, HasSubstr("lot-4: "));
      std::vector<size_t> lots;
      for (const LotFailures::One& one : failures.found) lots.push_back(one.lot);
      EXPECT_EQ(lots, wants_all ? std::vector<size_t>({4, 11, 29}) : std::vector<size_t>({4}));
    }
  }
}

TEST(RuleDerivation, ValuesOfALotAreItsOwnAndGiveWayToSettings) {
  const RuleSet rules = RulesFrom("attr h = 3\nattr twice = 2 * h\nLot --> extrude(twice) Mass");
  const auto items = TownLots(3);
  const std::vector<std::vector<GivenValue>> given = {{}, {{0, 5.0}}, {{0, 7.0}, {1, 1.0}}};
  const auto heights = [&](const RuleSettings& settings) {
    std::vector<double> all;
    const auto trees = DeriveRules(rules, settings, items, {}, given);
    EXPECT_TRUE(trees);
    for (const ShapeTree& tree : *trees) all.push_back(tree[tree.Leaves().at(0)].item.scope.size.y);
    return all;
  };
  EXPECT_THAT(heights({}), ElementsAre(6, 10, 1));
  RuleSettings settings;
  settings.attributes = {{"h", "4"}};
  EXPECT_THAT(heights(settings), ElementsAre(8, 8, 1));
}

}  // namespace
}  // namespace parti::grammar
