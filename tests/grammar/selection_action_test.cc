#include "grammar/selection_action.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "grammar/action_text.h"
#include "tests/grammar/derived.h"
#include "tests/grammar/random_trees.h"

namespace parti::grammar {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The messages of all errors, each with line and column: "2:5: there is no …".
std::vector<std::string> ErrorsOf(std::string_view text) {
  std::vector<std::string> messages;
  const auto trees = ParseTrees(text, "t.cga");
  if (trees) return messages;
  for (const Error& e : trees.error()) {
    EXPECT_TRUE(e.place) << e.message;
    messages.push_back(std::to_string(e.place->line) + ":" + std::to_string(e.place->column) +
                       ": " + e.message);
  }
  return messages;
}

constexpr std::string_view kTwoTrees = R"(tree structure {
  .Lot --> extrude(12) Mass {
    .Mass --> comp(f) { side: Facade | top: Roof }
  }
  .Facade:north --> split(y) { 4: Ground | { ~3: Floor }* }
}
tree ornaments off {
  off .Floor:even > #Window --> tag("festive")
}
)";

TEST(TreesText, ReadsBackWhatItPrints) {
  EXPECT_EQ(TextOf(TreesFrom(kTwoTrees)), kTwoTrees);
  EXPECT_EQ(TextOf(TreesFrom("")), "");
  EXPECT_EQ(TextOf(TreesFrom("tree empty { }")), "tree empty {\n}\n");
}

TEST(TreesText, AcceptsTheVariantsOfThePapers) {
  const Trees trees = TreesFrom(R"(
    version "2023.0"  # a comment, as everywhere outside of trees
    tree a { // one line
      .Lot → extrude(12) Mass;
      #tag -> split("y") { 4: A | ~1: ε };
      /* both */ * --> tag("x") { * --> tag("y") }
    })");
  EXPECT_EQ(TextOf(trees), R"(tree a {
  .Lot --> extrude(12) Mass
  #tag --> split(y) { 4: A | ~1: NIL }
  * --> tag("x") {
    * --> tag("y")
  }
}
)");
}

TEST(TreesText, ANodeMayBeginWithAnOperationOrAStar) {
  const char* text = R"(tree a {
  .Lot --> extrude(12)
  Extrude --> split(y) { ~3: Floor }*
  * > .Floor --> tag("x") Slab
  Repeat.Floor --> split(x) { ~3: Tile }*
  *:leaf --> tag("y")
  :leaf --> tag("z")
}
)";
  const Trees trees = TreesFrom(text);
  ASSERT_EQ(trees.size(), 1u);
  ASSERT_EQ(trees[0].nodes.size(), 6u);
  EXPECT_EQ(trees[0].nodes[0].action.symbol, "");
  EXPECT_EQ(trees[0].nodes[2].action.symbol, "Slab");
  EXPECT_EQ(trees[0].nodes[3].query.selectors[0].operation, "Repeat");
  EXPECT_EQ(TreesFrom(TextOf(trees)), trees);
}

TEST(TreesText, AllErrorsOfATextComeInOneGo) {
  EXPECT_THAT(ErrorsOf(R"(tree a {
  .Lot --> extrud(12) Mass {
    .Mass --> comp(f) { sid: Facade }
    .Fine --> tag("x")
  }
  .Floor:evn --> splt(y) { 4: A | ~1: B }
  .Facade split(y) { 4: A }
  .Roof --> extrude(2, 3)
  .Wall --> split(y) { 4 A | ~1: B }
}
tree b {
  .X --> Ground
}
)"),
              ElementsAre("2:12: there is no operation 'extrud'",  //
                          "3:25: there is no selector 'sid'",      //
                          "6:10: there is no filter 'evn'",        //
                          "6:18: there is no operation 'splt'",    //
                          "7:11: expected '-->' and an operation, got 'split'",
                          "8:24: extrude takes 1 argument, got 2",  //
                          "9:26: expected ':' after the size, got 'A'",
                          "12:10: there is no operation 'Ground'"));
}

TEST(TreesText, EveryKindOfMistakeHasItsMessage) {
  const auto first = [](std::string_view text) {
    const auto errors = ErrorsOf(text);
    return errors.empty() ? "no error" : errors[0];
  };
  EXPECT_THAT(first("tree { }"), HasSubstr("expected tree NAME { … }"));
  EXPECT_THAT(first("tree a }"), HasSubstr("'{' and the tree's nodes"));
  EXPECT_THAT(first("tree a { .Lot --> extrude(3)"), HasSubstr("1:1: this tree is not closed"));
  EXPECT_THAT(first("tree a { .Lot --> extrude(3) { .B --> tag(\"x\") "),
              HasSubstr("1:10: the children of this node are not closed"));
  EXPECT_THAT(first("tree a { } }"), HasSubstr("expected tree NAME { … }, got '}'"));
  EXPECT_THAT(first("Lot --> extrude(3) Mass"), HasSubstr("rules are not read yet, only trees"));
  EXPECT_THAT(first("attr height = 3"), HasSubstr("rules are not read yet, only trees"));
  EXPECT_THAT(first("tree a { .A --> }"), HasSubstr("expected an operation, got '}'"));
  EXPECT_THAT(first("tree a { .A --> tag(\"x\") tag(\"y\") }"), HasSubstr("has one operation"));
  EXPECT_THAT(first("tree a { --> tag(\"x\") }"), HasSubstr("expected a selector"));
  EXPECT_THAT(first("tree a { .A --> tag(\"x\" }"), HasSubstr("expected ',' or ')'"));
  EXPECT_THAT(first("\xff"), HasSubstr("UTF-8"));
  EXPECT_THAT(first("tree a { .A --> tag(\"x) }\n}"), HasSubstr("not closed"));
}

TEST(TreesText, ARuleIsRefusedAndTheTreesAfterItAreStillRead) {
  EXPECT_THAT(
      ErrorsOf("Lot --> extrude(3)\n  tree(1)\ntree a {\n .A --> tagg(\"x\")\n}"),
      ElementsAre("1:1: rules are not read yet, only trees", "4:9: there is no operation 'tagg'"));
}

TEST(TreesText, ErrorsAreFew) {
  std::string text = "tree a {\n";
  for (int i = 0; i < 1000; ++i) text += ".A --> nonsense(1)\n";
  EXPECT_EQ(ErrorsOf(text).size(), 50u);
}

TEST(TreesText, DeepNodesAreRefusedNotFollowed) {
  std::string text = "tree a {";
  for (int i = 0; i < 100'000; ++i) text += " .A --> tag(\"x\") {";
  EXPECT_THAT(ErrorsOf(text).at(0), HasSubstr("nested more than 200 deep"));
}

RC_GTEST_PROP(TreesText, AllTreesReadBack, ()) {
  const Trees trees = RandomTrees();
  const std::string text = TextOf(trees);
  RC_LOG() << text;
  const auto read = ParseTrees(text);
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == trees);
  RC_ASSERT(TextOf(*read) == text);
}

TEST(Derive, Listing5_7_DepthFirstTopToBottom) {
  const Derivation d = Derived(R"(
    .Lot --> extrude(9) Mass {
      .Mass --> comp(f) { side: Facade | top: Roof } {
        .Facade --> split(y) { ~3: Floor }*
      }
      .Floor --> split(x) { ~5: Tile }*
    }
    .Roof --> offset(-1) { inside: Terrace | border: Parapet }
  )");
  std::vector<std::vector<int>> paths;
  for (const NodeResult& node : d.nodes) paths.push_back(node.path);
  EXPECT_THAT(paths, ElementsAre(ElementsAre(0, 0), ElementsAre(0, 0, 0), ElementsAre(0, 0, 0, 0),
                                 ElementsAre(0, 0, 1), ElementsAre(0, 1)));
  EXPECT_EQ(Selected(".Tile", d.tree).size(), 3u * (4 + 2 + 4 + 2));
  EXPECT_EQ(Selected(".Terrace", d.tree).size(), 1u);
  EXPECT_THAT(d.hints, IsEmpty());
}

TEST(Derive, ChildrenSeeOnlyWhatTheirNodeSelected) {
  const Derivation d = Derived(R"(
    .Lot --> extrude(9) Mass
    .Mass --> comp(f) { side: Facade }
    .Facade:north --> split(y) { ~3: Floor }* {
      .Floor --> tag("north")
      .Facade --> tag("never")
    }
    .Facade:south --> split(y) { ~3: Floor }*
  )");
  EXPECT_EQ(Selected(".Floor", d.tree).size(), 6u);
  EXPECT_EQ(Selected("#north", d.tree).size(), 3u);
  EXPECT_THAT(Selected("#never", d.tree), IsEmpty());
}

TEST(Derive, ASelectionIsKeptFromWhenItsNodeRan) {
  // The first child changes the symbol that the parent selected by.
  const Derivation d = Derived(R"(
    .Lot --> split(x) { ~1: House | ~1: House }
    .House --> extrude(3) Mass {
      .Mass --> symbol("Block")
      .Block --> tag("seen")
    }
    .House --> symbol("Home")
  )");
  EXPECT_EQ(Selected(".Block#seen", d.tree).size(), 2u);
  EXPECT_EQ(Selected(".Home", d.tree).size(), 2u);
}

TEST(Derive, AProductIsTakenOnceBeforeItsActionChangesTheTree) {
  // Each half is a Part too; if the query were taken again there would be no end.
  const Derivation d = Derived(R"(
    .Lot --> symbol("Part")
    .Part --> split(x) { ~1: Part | ~1: Part }
  )");
  EXPECT_EQ(d.tree.size(), 3u);
}

TEST(Derive, OperationsInPlaceChangeTheShapeItself) {
  const Derivation d = Derived(R"(
    .Lot --> tag("a") Plot
    .Plot --> color("#ff8000")
    .Plot --> symbol("Site")
  )");
  EXPECT_EQ(d.tree.size(), 1u);
  EXPECT_THAT(Selected(".Site#a", d.tree), ElementsAre("."));
  EXPECT_EQ(d.tree[0].item.color_rgb, 0xff8000u);
  EXPECT_EQ(d.tree[0].operation, nullptr);
}

TEST(Derive, ASuccessorsOperationsActOnTheChild) {
  const Derivation d = Derived(R"(
    .Lot --> split(x) { 4: tag("x") color("#0000ff") Ground | ~1: symbol("Rest") | 2: NIL }
  )");
  EXPECT_EQ(d.tree.size(), 3u);
  EXPECT_THAT(Selected("Split.Ground#x", d.tree), ElementsAre("0"));
  EXPECT_THAT(Selected(".Rest", d.tree), ElementsAre("1"));
  EXPECT_EQ(d.tree[1].item.color_rgb, 0x0000ffu);
  EXPECT_EQ(d.tree[2].item.color_rgb, 0u);
  EXPECT_DOUBLE_EQ(d.tree[2].item.scope.size.x, 14);
}

TEST(Derive, SuccessorsOfRepeatGroupsAreToldApart) {
  const Derivation d = Derived(R"(
    .Lot --> split(x) { 2: Start | { ~1: tag("l") Left | ~1: Right }* | 2: tag("e") End }
  )");
  EXPECT_EQ(Selected("#l", d.tree), Selected(".Left", d.tree));
  EXPECT_THAT(Selected(".Left", d.tree).size(), 8u);
  EXPECT_THAT(Selected(".Right", d.tree).size(), 8u);
  EXPECT_THAT(Selected(".End#e", d.tree), ElementsAre("17"));
}

TEST(Derive, TreesAndNodesThatAreOffDoNotRun) {
  const Trees trees = TreesFrom(R"(
    tree a { off .Lot --> extrude(3) Mass { .Mass --> tag("x") } .Lot --> tag("a") }
    tree b off { .Lot --> tag("b") }
    tree c { .Lot --> tag("c") }
  )");
  const auto d = Derive(trees, LotOf(5, 5));
  ASSERT_TRUE(d);
  EXPECT_EQ(d->tree.size(), 1u);
  EXPECT_THAT(Selected("#a#c", d->tree), ElementsAre("."));
  EXPECT_THAT(Selected("#b", d->tree), IsEmpty());
  EXPECT_THAT(d->nodes[0].path, ElementsAre(0, 1));
  EXPECT_THAT(d->nodes[1].path, ElementsAre(2, 0));
}

TEST(Derive, HintsSayWhatASelectionMissed) {
  const Derivation d = Derived(R"(
    .Lot --> extrude(3) Mass
    .Lot --> extrude(4) Second
    .Nothing --> tag("x") { .Below --> tag("y") }
    .Lot --> offset(-9) { inside: Vanished }
  )");
  std::vector<std::string> hints;
  for (const DerivationHint& h : d.hints) hints.push_back(h.node + ": " + h.message);
  EXPECT_THAT(hints,
              ElementsAre(".Lot --> extrude(4) Second: acted on 1 shape that already had children: "
                          "only leaves are visible",
                          ".Nothing --> tag(\"x\"): selected nothing",
                          ".Lot --> offset(-9) { inside: Vanished }: acted on 1 shape that already "
                          "had children: only leaves are visible",
                          ".Lot --> offset(-9) { inside: Vanished }: made nothing"));
  EXPECT_EQ(d.tree.size(), 3u);  // appended, as errata 15 allows
}

TEST(Derive, ErrorsNameNodeAndShape) {
  const auto failed =
      Derive(TreesFrom("tree t { .Lot --> extrude(3) Mass .Mass --> extrude(2) }"), LotOf(5, 5));
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kWrongItemType);
  EXPECT_THAT(failed.error().message, HasSubstr("node '.Mass --> extrude(2)': shape 0 'Mass': "));
}

TEST(Derive, TooManyShapesAreAnErrorThatNamesTheNode) {
  const auto trees = TreesFrom("tree t { .Lot --> split(x) { ~0.1: A }* }");
  EXPECT_TRUE(Derive(trees, LotOf(10, 5), {.shapes = 101}));
  const auto failed = Derive(trees, LotOf(10, 5), {.shapes = 100});
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kLimitReached);
  EXPECT_THAT(failed.error().message, HasSubstr("node '.Lot --> split(x) { ~0.1: A }*'"));
  EXPECT_THAT(failed.error().message, HasSubstr("more than 100 shapes"));
}

TEST(Derive, ACancelledDerivationEnds) {
  const std::atomic<bool> cancelled = true;
  const auto trees = TreesFrom("tree t { .Lot --> extrude(3) }");
  const auto failed = Derive(trees, LotOf(5, 5), {}, nullptr, &cancelled);
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("cancelled"));
}

TEST(Derive, AGivenTreeMayAlreadyBeDerived) {
  const Derivation first = Derived(".Lot --> extrude(9) Mass");
  const auto second = Derive(TreesFrom("tree t { .Mass --> comp(f) { all: Face } }"), first.tree);
  ASSERT_TRUE(second);
  EXPECT_EQ(Selected(".Face", second->tree).size(), 6u);
}

bool SameItem(const Item& a, const Item& b) {
  const auto same = [](const auto& x, const auto& y) {
    return x == y || (x != nullptr && y != nullptr && *x == *y);
  };
  return a.type == b.type && a.scope.origin == b.scope.origin && a.scope.size == b.scope.size &&
         a.scope.x == b.scope.x && a.scope.y == b.scope.y && same(a.polygon, b.polygon) &&
         same(a.mesh, b.mesh) && a.facing == b.facing && a.color_rgb == b.color_rgb;
}

void ExpectSameTrees(const ShapeTree& a, const ShapeTree& b) {
  ASSERT_EQ(a.size(), b.size());
  for (ShapeIndex i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.IdOf(i), b.IdOf(i));
    EXPECT_EQ(a.Name(a[i].symbol), b.Name(b[i].symbol));
    EXPECT_EQ(a[i].operation, b[i].operation);
    EXPECT_EQ(a[i].symbol, b[i].symbol);
    EXPECT_EQ(a[i].tags, b[i].tags);
    EXPECT_TRUE(SameItem(a[i].item, b[i].item)) << a.IdOf(i);
  }
}

constexpr std::string_view kHouse = R"(tree t {
  .Lot --> extrude(9) Mass {
    .Mass --> comp(f) { side: Facade | top: Roof }
  }
  .Facade --> split(y) { ~3: Floor }* {
    .Floor:odd --> split(x) { ~2: tag("t") Tile }*
  }
  .Nothing --> tag("none")
  .Roof --> extrude(1) Attic
})";

TEST(Derive, AnEqualPrefixIsSharedNotRunAgain) {
  const ShapeTree lot = LotOf(20, 10);
  Trees trees = TreesFrom(kHouse);
  const auto before = Derive(trees, lot);
  ASSERT_TRUE(before);
  std::get<double>(trees[0].nodes[3].action.arguments[0]) = 2;
  const auto after = Derive(trees, lot, {}, &*before);
  ASSERT_TRUE(after);
  ASSERT_EQ(after->nodes.size(), before->nodes.size());
  for (size_t i = 0; i + 1 < after->nodes.size(); ++i) {
    EXPECT_TRUE(after->nodes[i].after.SharesAllWith(before->nodes[i].after)) << i;
  }
  const auto scratch = Derive(trees, lot);
  ExpectSameTrees(after->tree, scratch->tree);
  EXPECT_EQ(after->hints.size(), scratch->hints.size());
}

TEST(Derive, NothingIsSharedOnAnotherLot) {
  const Trees trees = TreesFrom(kHouse);
  const auto before = Derive(trees, LotOf(20, 10));
  const auto after = Derive(trees, LotOf(30, 10), {}, &*before);
  ASSERT_TRUE(after);
  EXPECT_DOUBLE_EQ(after->tree[1].item.scope.size.x, 30);
}

/// All nodes of a tree, depth first.
void Collect(std::vector<SelectionActionNode>* nodes, std::vector<SelectionActionNode*>* all) {
  for (SelectionActionNode& node : *nodes) {
    all->push_back(&node);
    Collect(&node.children, all);
  }
}

RC_GTEST_PROP(Derive, SharingGivesWhatRunningGives, ()) {
  const ShapeTree lot = LotOf(20, 10);
  const Trees trees = TreesFrom(kHouse);
  const auto before = Derive(trees, lot);
  Trees edited = trees;
  std::vector<SelectionActionNode*> all;
  Collect(&edited[0].nodes, &all);
  SelectionActionNode& node = *all[*rc::gen::inRange<size_t>(0, all.size())];
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      node.enabled = false;
      break;
    case 1:
      node.action = *ParseAction("tag(\"changed\")");
      break;
    case 2:
      node.children.clear();
      break;
    default:
      node.children.push_back(
          {*ParseQuery("*:leaf"), *ParseAction("split(x) { ~1: L | ~1: R }"), true, {}});
  }
  const auto shared = Derive(edited, lot, {}, &*before);
  const auto scratch = Derive(edited, lot);
  RC_ASSERT(shared.has_value() == scratch.has_value());
  if (!shared) return;
  ExpectSameTrees(shared->tree, scratch->tree);
  RC_ASSERT(shared->hints.size() == scratch->hints.size());
  for (size_t i = 0; i < shared->nodes.size(); ++i) {
    RC_ASSERT(shared->nodes[i].path == scratch->nodes[i].path);
    RC_ASSERT(shared->nodes[i].selected == scratch->nodes[i].selected);
  }
}

TEST(InsertionPath, IsTheNodeThatMadeTheTarget) {
  const Trees trees = TreesFrom(kHouse);
  const auto d = Derive(trees, LotOf(20, 10));
  const auto path = [&](std::string_view query) {
    const auto shapes = *ProductOf(*ParseQuery(query), d->tree);
    return InsertionPath(*d, trees, shapes.at(0));
  };
  EXPECT_THAT(path(".Mass"), ElementsAre(0, 0));
  EXPECT_THAT(path(".Roof"), ElementsAre(0, 0, 0));
  EXPECT_THAT(path(".Floor"), ElementsAre(0, 1));
  EXPECT_THAT(path(".Tile"), ElementsAre(0, 1, 0));
  EXPECT_THAT(path(".Lot"), ElementsAre(0));
}

TEST(InsertionPath, ANodeInsertedThereSelectsTheTarget) {
  const Trees trees = TreesFrom(kHouse);
  const ShapeTree lot = LotOf(20, 10);
  const auto d = Derive(trees, lot);
  for (ShapeIndex target = 0; target < d->tree.size(); ++target) {
    Trees next = trees;
    const auto path = InsertionPath(*d, trees, target);
    auto* nodes = &next.at(path.at(0)).nodes;
    for (size_t i = 1; i < path.size(); ++i) nodes = &nodes->at(path[i]).children;
    Query query{{QuerySelector{"", std::string(d->tree.Name(d->tree[target].symbol)), {}, {}}}, {}};
    nodes->push_back({std::move(query), *ParseAction("tag(\"drawn\")"), true, {}});
    const auto after = Derive(next, lot, {}, &*d);
    ASSERT_TRUE(after);
    EXPECT_THAT(Selected("#drawn", after->tree), testing::Contains(d->tree.IdOf(target)));
  }
}

TEST(InsertionPath, IsATreeThatIsOn) {
  const Trees off = TreesFrom("tree a off { } tree b { }");
  const auto d = Derive(off, LotOf(5, 5));
  EXPECT_THAT(InsertionPath(*d, off, 0), ElementsAre(1));
  EXPECT_THAT(InsertionPath(*d, {}, 0), ElementsAre(0));
  EXPECT_THAT(InsertionPath(*d, TreesFrom("tree a off { }"), 0), ElementsAre(1));
}

}  // namespace
}  // namespace parti::grammar
