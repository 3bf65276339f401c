// Assets, edges and corners in rules.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text_file.h"
#include "grammar/asset_library.h"
#include "tests/grammar/geometry_support.h"
#include "tests/grammar/rules/derived_by_rules.h"

namespace parti::grammar::tests {
namespace {

using testing::HasSubstr;

Result<std::vector<ShapeTree>> DerivedWith(const std::string& text, AssetLibrary* assets) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  RuleSettings settings;
  settings.start = "Lot";
  RuleThreads threads;
  threads.count = 1;
  threads.assets = assets;
  return DeriveRules(RulesFrom(text), settings, {&lot, 1}, threads);
}

Result<std::string> FromModels(const std::string& name) {
  return ReadFile(std::string(PARTI_SOURCE_DIR) + "/assets/models/" + name);
}

TEST(RuleAssets, AreReadOnceForAllShapes) {
  AssetLibrary library(FromModels);
  const auto trees = DerivedWith(
      "Lot --> extrude(6) comp(f) { front: Wall }\n"
      "Wall --> split(x) { ~2: Tile }*\n"
      "Tile --> s('0.6, '0.5, 0.2) center(xy) i(\"window.obj\") Window\n",
      &library);
  ASSERT_TRUE(trees) << FormatError(trees.error());
  const auto leaves = trees->front().Leaves();
  ASSERT_EQ(leaves.size(), 5u);
  const Item& first = trees->front()[leaves[0]].item;
  EXPECT_EQ(first.type, ItemType::kVolume);
  EXPECT_NEAR(first.scope.size.z, 0.2, 1e-12);
  EXPECT_EQ(first.mesh, trees->front()[leaves[4]].item.mesh);
}

TEST(RuleAssets, BodiesWithoutAFileAreMadeOnceForAllShapesThatAskForTheSame) {
  for (const char* const body :
       {"primitiveSphere(12, 7)", "primitiveCylinder(12)", "primitiveCone(12)",
        "primitiveSphere(10 + 2, geometry.area * 0 + 7)", "primitiveCone(6 * 2)"}) {
    const std::string rules = fmt::format(
        "Lot --> split(x) {{ ~2: extrude(1) {0} A | ~2: extrude(2) {0} A | "
        "~2: extrude(1) primitiveSphere(5, 7) B }}\n",
        body);
    AssetLibrary library(FromModels);
    const auto shared = DerivedWith(rules, &library), own = DerivedWith(rules, nullptr);
    ASSERT_TRUE(shared && own) << body;
    const auto mesh = [](const Result<std::vector<ShapeTree>>& trees, size_t leaf) {
      return trees->front()[trees->front().Leaves().at(leaf)].item.mesh;
    };
    EXPECT_EQ(mesh(shared, 0), mesh(shared, 1)) << body;
    EXPECT_NE(mesh(shared, 0), mesh(shared, 2)) << body;
    EXPECT_NE(mesh(own, 0), mesh(own, 1)) << "nobody keeps them";
    EXPECT_EQ(mesh(shared, 0)->points, mesh(own, 0)->points) << body;
    EXPECT_EQ(mesh(shared, 0)->faces.size(), mesh(own, 1)->faces.size()) << body;
  }
}

TEST(RuleAssets, MissingFilesNameRuleAndPlace) {
  AssetLibrary library(FromModels);
  const auto trees = DerivedWith("Lot --> i(\"gone.obj\") Thing\n", &library);
  ASSERT_FALSE(trees);
  EXPECT_EQ(trees.error().code, ErrorCode::kFile);
  EXPECT_THAT(trees.error().message, HasSubstr("gone.obj"));
  ASSERT_TRUE(trees.error().place);
  EXPECT_EQ(trees.error().place->line, 1);
}

TEST(RuleParts, EdgesAndCornersCarryWhatIsPutThere) {
  const auto trees = DerivedWith(
      "Lot --> extrude(6) comp(e) { vertical: Post | all: NIL }\n"
      "Post --> s('1, 0.2, 0.2) primitiveCube() Beam\n",
      nullptr);
  ASSERT_TRUE(trees) << FormatError(trees.error());
  EXPECT_EQ(trees->front().Leaves().size(), 4u);
  const auto balls = DerivedWith(
      "Lot --> extrude(6) comp(v) { all: Knob }\n"
      "Knob --> primitiveSphere(8, 4, 0.3) Ball\n",
      nullptr);
  ASSERT_TRUE(balls) << FormatError(balls.error());
  EXPECT_EQ(balls->front().Leaves().size(), 8u);
}

TEST(RuleParts, EdgesRefuseWhatNeedsASurface) {
  const auto trees = DerivedWith(
      "Lot --> extrude(6) comp(e) { all: Rim }\n"
      "Rim --> extrude(1) Wall\n",
      nullptr);
  ASSERT_FALSE(trees);
  EXPECT_EQ(trees.error().code, ErrorCode::kWrongItemType);
}

}  // namespace
}  // namespace parti::grammar::tests
