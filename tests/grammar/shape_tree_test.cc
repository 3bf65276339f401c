#include "grammar/shape_tree.h"

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
    for (ShapeIndex p = tree[i].parent; p != kNoShape; p = tree[p].parent) above[p] = true;
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
