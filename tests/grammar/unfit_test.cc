// Derivation that leaves alone what it can't do (Unfit::kSkip).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/derived.h"

namespace parti::grammar {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Derivation Skipping(std::string_view nodes, const Derivation* previous = nullptr,
                    const Limits& limits = {}) {
  const ShapeTree lot = previous != nullptr ? previous->lot : LotOf(20, 10);
  auto derivation = Derive(TreesFrom("tree t {\n" + std::string(nodes) + "\n}"), lot, limits,
                           previous, nullptr, Unfit::kSkip);
  EXPECT_TRUE(derivation) << FormatError(derivation.error());
  return std::move(*derivation);
}

/// A volume and four planar shapes, all of them leaves; only these can be extruded.
constexpr std::string_view kMixed = R"(
  .Lot --> split(x) { 5: Pad | 5: Pad | 5: Pad | 5: Pad }
  .Pad:first --> extrude(2) Mass
  *:leaf --> extrude(1) Top
  .Top --> color("#888888")
)";

TEST(UnfitTest, WhatCanTheActionTakeIsActedOnAndTheRestStays) {
  const Derivation d = Skipping(kMixed);
  EXPECT_THAT(Selected(".Top", d.tree), SizeIs(3));
  EXPECT_THAT(Selected(".Mass:leaf", d.tree), SizeIs(1));
  ASSERT_THAT(d.problems, SizeIs(1));
  EXPECT_EQ(d.problems[0].shapes, 1u);
  EXPECT_EQ(d.problems[0].error.code, ErrorCode::kWrongItemType);
  EXPECT_THAT(d.problems[0].error.message, HasSubstr("shape 0/0 'Mass'"));
  EXPECT_THAT(d.nodes.at(d.problems[0].result).path, ::testing::ElementsAre(0, 2));
  EXPECT_THAT(d.nodes.at(2).selected, SizeIs(3));
}

TEST(UnfitTest, WithoutItTheSameFailsTheDerivation) {
  const auto derivation = Derive(TreesFrom("tree t {" + std::string(kMixed) + "}"), LotOf(20, 10));
  ASSERT_FALSE(derivation);
  EXPECT_EQ(derivation.error().code, ErrorCode::kWrongItemType);
}

TEST(UnfitTest, ANodeThatWouldMakeTooMuchDoesNothing) {
  const Derivation d = Skipping(R"(
    .Lot --> split(x) { { ~1: Strip }* }
    .Strip --> split(z) { { ~0.01: Grain }* }
    .Strip --> color("#888888")
  )",
                                nullptr, {.shapes = 500});
  EXPECT_THAT(Selected(".Strip:leaf", d.tree), SizeIs(20));
  ASSERT_THAT(d.problems, SizeIs(1));
  EXPECT_EQ(d.problems[0].error.code, ErrorCode::kLimitReached);
  EXPECT_EQ(d.problems[0].shapes, 20u);
}

TEST(UnfitTest, SharedNodesKeepTheirProblems) {
  const Derivation before = Skipping(kMixed);
  const Derivation after = Skipping(std::string(kMixed) + ".Top --> tag(\"x\")", &before);
  ASSERT_THAT(after.problems, SizeIs(1));
  EXPECT_TRUE(after.nodes[2].after.SharesAllWith(before.nodes[2].after));
  EXPECT_THAT(Skipping(".Lot --> extrude(1) A", &before).problems, IsEmpty());
}

TEST(UnfitTest, NodesBelowOneThatCanDoNothingSelectNothingInSilence) {
  const Derivation d = Skipping(R"(
    .Lot --> extrude(6) Mass
    .Mass --> extrude(1) Top { .Top --> color("#888888") }
  )");
  EXPECT_THAT(d.problems, SizeIs(1));
  EXPECT_THAT(d.hints, IsEmpty());
}

}  // namespace
}  // namespace parti::grammar
