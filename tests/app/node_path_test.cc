#include "app/node_path.h"

#include <gtest/gtest.h>

namespace parti::app {
namespace {

NodePath P(std::string_view text) { return *ParseNodePath(text); }

TEST(NodePathTest, PathsReadBackAsWritten) {
  for (const char* text : {"0", "0/1", "12/0/345"}) EXPECT_EQ(PathText(P(text)), text);
}

TEST(NodePathTest, ANodeIsBelowItselfItsParentsAndItsTree) {
  EXPECT_TRUE(IsAtOrBelow(P("0/1/2"), P("0/1/2")));
  EXPECT_TRUE(IsAtOrBelow(P("0/1/2"), P("0/1")));
  EXPECT_TRUE(IsAtOrBelow(P("0/1/2"), P("0")));
  EXPECT_FALSE(IsAtOrBelow(P("0/1"), P("0/1/2")));
  EXPECT_FALSE(IsAtOrBelow(P("0/1/2"), P("0/2")));
}

TEST(NodePathTest, ARemovedNodeTakesWhatIsBelowItAndPullsUpWhatFollows) {
  EXPECT_EQ(PathAfterRemoval(P("0/1"), P("0/1")), std::nullopt);
  EXPECT_EQ(PathAfterRemoval(P("0/1/3"), P("0/1")), std::nullopt);
  EXPECT_EQ(PathAfterRemoval(P("0/2/3"), P("0/1")), P("0/1/3"));
  EXPECT_EQ(PathAfterRemoval(P("0/0"), P("0/1")), P("0/0"));
  EXPECT_EQ(PathAfterRemoval(P("1/2"), P("0/1")), P("1/2"));
  EXPECT_EQ(PathAfterRemoval(P("1/2"), P("0")), P("0/2"));
  EXPECT_EQ(PathAfterRemoval(P("0"), P("0/1")), P("0"));
}

TEST(NodePathTest, AnInsertedNodePushesDownWhatFollows) {
  EXPECT_EQ(PathAfterInsertion(P("0/1/4"), P("0/1")), P("0/2/4"));
  EXPECT_EQ(PathAfterInsertion(P("0/0"), P("0/1")), P("0/0"));
  EXPECT_EQ(PathAfterInsertion(P("0/1"), P("0/1/0")), P("0/1"));
  EXPECT_EQ(PathAfterInsertion(P("0/1"), P("0")), P("1/1"));
}

}  // namespace
}  // namespace parti::app
