#include "grammar/shape_tree.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

namespace parti::grammar {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

ShapeTree Lot() { return ShapeTree(Item{}); }

TEST(ShapeTree, StartsWithItsLot) {
  const ShapeTree tree = Lot();
  EXPECT_EQ(tree.size(), 1u);
  EXPECT_EQ(tree.Name(tree[0].symbol), "Lot");
  EXPECT_TRUE(tree.IsLeaf(0));
  EXPECT_THAT(tree.Leaves(), ElementsAre(0u));
}

TEST(ShapeTree, LeavesAreDepthFirst) {
  ShapeTree tree = Lot();
  const ShapeIndex a = tree.Append(0, {}, tree.Intern("A"), nullptr);
  const ShapeIndex b = tree.Append(0, {}, tree.Intern("B"), nullptr);
  const ShapeIndex b0 = tree.Append(b, {}, kNoName, nullptr);
  const ShapeIndex a0 = tree.Append(a, {}, kNoName, nullptr);
  const ShapeIndex a1 = tree.Append(a, {}, kNoName, nullptr);
  EXPECT_THAT(tree.Leaves(), ElementsAre(a0, a1, b0));
}

/// `count` shapes below its root, each the child of the one at half its number.
ShapeTree Grown(uint32_t count, std::string_view symbol) {
  ShapeTree tree(Item{}, symbol);
  for (uint32_t i = 0; i < count; ++i) {
    tree.Append(i / 2, {}, tree.Intern(fmt::format("{}{}", symbol, i)), nullptr);
  }
  return tree;
}

/// All of a tree below shape i, in order, with names.
std::string Told(const ShapeTree& tree, ShapeIndex i) {
  std::string text(tree.Name(tree[i].symbol));
  for (ShapeIndex c = tree.node(i).first_child; c != kNoShape; c = tree.node(c).next_sibling) {
    EXPECT_EQ(tree.node(c).parent, i);
    text += "(" + Told(tree, c) + ")";
  }
  return text;
}

TEST(ShapeTree, PartsTakeTheirPlacesWhateverTheirSizes) {
  ShapeTree tree = Grown(200, "tree");
  const ShapeTree before = tree;
  std::vector<ShapeTree::Part> parts;
  std::vector<std::string> told;
  const std::vector<uint32_t> sizes = {0, 3, 500, 1, 47, 48, 128, 129, 2, 1000};
  uint32_t all = tree.size();
  for (size_t i = 0; i < sizes.size(); ++i) {
    ShapeTree part = Grown(sizes[i], "part");
    told.push_back(Told(part, 0));
    all += sizes[i];
    parts.push_back({static_cast<ShapeIndex>(150 + 3 * i), std::move(part)});
  }
  tree.Splice(std::move(parts));
  EXPECT_EQ(tree.size(), all);
  for (size_t i = 0; i < sizes.size(); ++i) {
    const auto at = static_cast<ShapeIndex>(150 + 3 * i);
    EXPECT_EQ(Told(tree, at), told[i]) << sizes[i];
    EXPECT_EQ(tree.node(at).parent, before.node(at).parent);
    EXPECT_EQ(tree.node(at).next_sibling, before.node(at).next_sibling);
  }
  for (ShapeIndex i = 1; i < all; ++i) EXPECT_LT(tree.node(i).parent, i);
  EXPECT_EQ(Told(before, 0), Told(Grown(200, "tree"), 0)) << "a copy stays as it was";
  const ShapeIndex last = tree.Append(180, {}, tree.Intern("after"), nullptr);
  EXPECT_EQ(tree.Name(tree[last].symbol), "after");
  EXPECT_EQ(tree.node(last).parent, 180u);
}

TEST(ShapeTree, IdsArePathsOfChildNumbers) {
  ShapeTree tree = Lot();
  tree.Append(0, {}, kNoName, nullptr);
  const ShapeIndex b = tree.Append(0, {}, kNoName, nullptr);
  const ShapeIndex c = tree.Append(b, {}, kNoName, nullptr);
  EXPECT_EQ(tree.IdOf(0), ".");
  EXPECT_EQ(tree.IdOf(c), "1/0");
  EXPECT_EQ(tree.AtId("."), 0u);
  EXPECT_EQ(tree.AtId("1/0"), c);
}

TEST(ShapeTree, BadIdsAreExplained) {
  const ShapeTree tree = Lot();
  for (const char* id : {"", "/", "0/", "a", "-1", "0//1", "99999999999999999999", "0 "}) {
    ASSERT_FALSE(tree.AtId(id)) << id;
    EXPECT_EQ(tree.AtId(id).error().code, ErrorCode::kBadText) << id;
  }
  EXPECT_EQ(tree.AtId("0/2").error().code, ErrorCode::kUnknownName);
  EXPECT_THAT(tree.AtId("0/2").error().message, HasSubstr("'.' has no child 0"));
}

TEST(ShapeTree, NamesAreInternedOnce) {
  ShapeTree tree = Lot();
  const NameId wall = tree.Intern("Wall");
  EXPECT_EQ(tree.Intern("Wall"), wall);
  EXPECT_EQ(tree.Find("Wall"), wall);
  EXPECT_EQ(tree.Find("Door"), kNoName);
  EXPECT_EQ(tree.Intern(""), kNoName);
  EXPECT_EQ(tree.Name(kNoName), "");
}

TEST(ShapeTree, TagsAreSortedAndOnce) {
  ShapeTree tree = Lot();
  const NameId a = tree.Intern("a");
  const NameId b = tree.Intern("b");
  tree.AddTag(0, b);
  tree.AddTag(0, a);
  tree.AddTag(0, b);
  EXPECT_THAT(tree[0].tags, ElementsAre(a, b));
  const ShapeIndex child = tree.Append(0, {}, kNoName, nullptr, {b, a, b});
  EXPECT_THAT(tree[child].tags, ElementsAre(a, b));
}

TEST(ShapeTree, ACopyIsAValueOfItsOwn) {
  ShapeTree tree = Lot();
  for (int i = 0; i < 1000; ++i) tree.Append(0, {}, kNoName, nullptr);
  const ShapeTree before = tree;
  EXPECT_TRUE(before.SharesAllWith(tree));
  tree.SetSymbol(500, tree.Intern("Changed"));
  tree.Append(700, {}, kNoName, nullptr);
  EXPECT_FALSE(before.SharesAllWith(tree));
  EXPECT_EQ(before[500].symbol, kNoName);
  EXPECT_TRUE(before.IsLeaf(700));
  EXPECT_EQ(before.size(), 1001u);
  EXPECT_EQ(before.Find("Changed"), kNoName);
  EXPECT_EQ(&before[300], &tree[300]);  // what nobody wrote to is shared
}

/// A tree in which shape i + 1 hangs below parents[i] mod (i + 1).
ShapeTree TreeFrom(const std::vector<uint32_t>& parents) {
  ShapeTree tree = Lot();
  for (const uint32_t p : parents) tree.Append(p % tree.size(), {}, kNoName, nullptr);
  return tree;
}

RC_GTEST_PROP(ShapeTree, EveryIdLeadsBackToItsShape, (const std::vector<uint32_t>& parents)) {
  const ShapeTree tree = TreeFrom(parents);
  for (ShapeIndex i = 0; i < tree.size(); ++i) RC_ASSERT(*tree.AtId(tree.IdOf(i)) == i);
}

RC_GTEST_PROP(ShapeTree, AncestorsAreTheParentsUpToTheLot, (const std::vector<uint32_t>& parents)) {
  const ShapeTree tree = TreeFrom(parents);
  for (ShapeIndex i = 0; i < tree.size(); ++i) {
    std::vector<bool> above(tree.size());
    for (ShapeIndex p = tree.node(i).parent; p != kNoShape; p = tree.node(p).parent)
      above[p] = true;
    for (ShapeIndex a = 0; a < tree.size(); ++a) RC_ASSERT(tree.IsAncestor(a, i) == above[a]);
  }
}

RC_GTEST_PROP(ShapeTree, LeavesAreAllShapesWithoutChildren,
              (const std::vector<uint32_t>& parents)) {
  const ShapeTree tree = TreeFrom(parents);
  std::vector<ShapeIndex> leaves = tree.Leaves();
  std::sort(leaves.begin(), leaves.end());
  std::vector<ShapeIndex> expected;
  for (ShapeIndex i = 0; i < tree.size(); ++i) {
    if (tree.IsLeaf(i)) expected.push_back(i);
  }
  RC_ASSERT(leaves == expected);
}

}  // namespace
}  // namespace parti::grammar
