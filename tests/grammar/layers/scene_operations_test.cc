// layers, segment and set_property on each type of item (Jesus 2018, 4.2.3).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grammar/action_text.h"
#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A wall 10 m wide and 7 m high, seen from the south.
Item Wall() {
  return PlanarFrom({{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 7, 0), Vec3(0, 7, 0)}}).value();
}
std::vector<Product> Made(std::string_view action, const Item& item) {
  return Apply(ParseAction(action).value(), item).value();
}
Error Refused(std::string_view action, const Item& item) {
  const auto made = Apply(ParseAction(action).value(), item);
  return made ? Error{} : made.error();
}
Item MadeLayer() { return Made("layers(\"a\", \"b\") { A | B }", Wall())[1].item; }

TEST(Layers, StackOverAPlanarShape) {
  const auto layers = Made("layers(\"a\", \"b\", \"c\") { A | NIL | C }", Wall());
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_EQ(layers[0].item.type, ItemType::kLayer);
  EXPECT_EQ(layers[0].item.layer, 0);
  EXPECT_EQ(layers[1].item.layer, 2);
  EXPECT_EQ(layers[1].successor, 2);
  EXPECT_EQ(layers[1].item.scope.size, Vec3(10, 7, 0));
}

TEST(Layers, TakePlanarShapesOnly) {
  EXPECT_EQ(Refused("layers(\"a\") { A }", MadeLayer()).code, ErrorCode::kWrongItemType);
  const Item shape = Made("segment(x) { 2: A }", Wall())[0].item;
  const Error refused = Refused("layers(\"a\") { A }", shape);
  EXPECT_EQ(refused.code, ErrorCode::kWrongItemType);
  EXPECT_THAT(refused.message, HasSubstr("Shape2D"));
  EXPECT_THAT(refused.hint, HasSubstr("normalisation"));
}

TEST(Segment, LaysShapesOutOverItsPredecessor) {
  const auto planar = Made("segment(x) { 2: A | ~1: NIL | 3: B }", Wall());
  ASSERT_EQ(planar.size(), 2u);
  EXPECT_EQ(planar[1].item.type, ItemType::kShape2D);
  EXPECT_EQ(planar[1].successor, 2);
  EXPECT_EQ(planar[1].item.scope.origin, Vec3(7, 0, 0));
  EXPECT_EQ(planar[1].item.scope.size, Vec3(3, 7, 0));
  EXPECT_EQ(planar[1].item.layer, 0);
  EXPECT_EQ(planar[1].item.depth, -1);
  const auto above = Made("segment(y) { 1: A }", planar[1].item);
  EXPECT_EQ(above[0].item.depth, -2);
  const auto layered = Made("segment(y, ~1, 2) { NIL | A }", MadeLayer());
  EXPECT_EQ(layered[0].item.layer, 1);
  EXPECT_EQ(layered[0].item.depth, -1);
  EXPECT_EQ(layered[0].item.scope.origin, Vec3(0, 5, 0));
}

TEST(Segment, RepeatsInAllForms) {
  const auto widths = [](std::string_view action) { return SizesOf(Made(action, Wall()), 0); };
  EXPECT_THAT(widths("segment(x) { ~2.4: A }*"), ElementsAre(2.5, 2.5, 2.5, 2.5));
  EXPECT_THAT(widths("segment(x) { 4: A }*"), ElementsAre(4, 4, 2));
  EXPECT_THAT(widths("segment(x) { 1: A | { ~4: B }* | '0.1: C }"), ElementsAre(1, 4, 4, 1));
  EXPECT_THAT(widths("segment(x) { { { 1: A }* | 4: B }* }"), ElementsAre(1, 4, 1, 4));
}

TEST(Segment, AxisZIsDepthOfLevelShapesOnly) {
  const auto level = Made("segment(z) { 2: A }", Lot("0,0 10,0 10,8 0,8"));
  EXPECT_EQ(level[0].item.scope.size, Vec3(10, 2, 0));
  EXPECT_EQ(Refused("segment(z) { 2: A }", Wall()).code, ErrorCode::kBadArguments);
  EXPECT_EQ(Refused("segment(x) { 2: A }", Apply(Extrude(3), Wall())->front().item).code,
            ErrorCode::kWrongItemType);
}

constexpr const char* kArch = "vectorial(\"M0,0 L0,0.5 C0,1 1,1 1,0.5 L1,0Z\", 50)";

TEST(Vectorial, FillsThePredecessorsRectangle) {
  for (const Item& item : {Wall(), MadeLayer(), Made("segment(x) { ~1: A }", Wall())[0].item}) {
    const auto made = Made(kArch, item);
    ASSERT_EQ(made.size(), 1u);
    const Item& arch = made[0].item;
    EXPECT_EQ(arch.type, ItemType::kShape2D);
    EXPECT_EQ(arch.layer, item.layer);
    EXPECT_EQ(arch.depth, item.depth - 1);
    EXPECT_EQ(arch.scope.origin, Vec3(0, 0, 0));
    EXPECT_EQ(arch.scope.size.x, 10);
    EXPECT_NEAR(arch.scope.size.y, 7 * 0.875, 1e-3);  // the curve's top
    EXPECT_EQ(arch.polygon->outer.size(), 54u);
  }
}

TEST(Vectorial, BoundsAreThePathsOwn) {
  const Item made = Made("vectorial(\"M0.2,0.5 H0.6 V1.5 Z\")", Wall())[0].item;
  EXPECT_EQ(made.scope.origin, Vec3(2, 3.5, 0));
  EXPECT_EQ(made.scope.size, Vec3(4, 7, 0));
}

TEST(Vectorial, FurtherLoopsAreHoles) {
  const Item made = Made("vectorial(\"M0,0H1V1H0Z M.2,.2H.8V.8H.2Z\")", Wall())[0].item;
  EXPECT_EQ(made.polygon->holes.size(), 1u);
  EXPECT_NEAR(AreaOf(made), 70 * (1 - 0.36), 1e-9);
}

TEST(Vectorial, RefusesPathsThatCrossThemselves) {
  const Error error = Refused("vectorial(\"M0,0 L1,1 L1,0 L0,1Z\")", Wall());
  EXPECT_EQ(error.code, ErrorCode::kSelfIntersecting);
  EXPECT_THAT(error.message, HasSubstr("vectorial: the outline crosses itself at (5.000, 3.500)"));
  EXPECT_TRUE(error.place.has_value());
  EXPECT_EQ(Refused("vectorial(\"M0,0 L1,0\")", Wall()).code, ErrorCode::kDegenerateGeometry);
  EXPECT_EQ(Refused("vectorial(\"M0,0 L1,0 0,1 X\")", Wall()).code, ErrorCode::kBadText);
  EXPECT_EQ(Refused(kArch, Apply(Extrude(3), Wall())->front().item).code,
            ErrorCode::kWrongItemType);
}

TEST(SetProperty, KeepsTheTypeAndIsInherited) {
  const Item free = Made("set_property(\"fixed_geometry\", false)", MadeLayer())[0].item;
  EXPECT_EQ(free.type, ItemType::kLayer);
  EXPECT_FALSE(free.fixed_geometry);
  const Item made = Made("segment(x) { 2: A }", free)[0].item;
  EXPECT_FALSE(made.fixed_geometry);
  EXPECT_TRUE(Made("set_property(\"fixed_geometry\", true)", made)[0].item.fixed_geometry);
}

TEST(OutType, FollowsTheTypeMaps) {
  const auto out = [](std::string_view name, ItemType type) {
    return OutType(*FindOperation(name), type);
  };
  for (const ItemType type : {ItemType::kPlanar, ItemType::kLayer, ItemType::kShape2D}) {
    EXPECT_EQ(out("segment", type), ItemType::kShape2D);  // (4.12)
    EXPECT_EQ(out("set_property", type), type);           // (4.14)
  }
  EXPECT_EQ(out("segment", ItemType::kVolume), std::nullopt);
  for (const ItemType type : {ItemType::kPlanar, ItemType::kLayer, ItemType::kShape2D}) {
    EXPECT_EQ(out("vectorial", type), ItemType::kShape2D);  // (4.13)
  }
  EXPECT_EQ(out("layers", ItemType::kPlanar), ItemType::kLayer);  // (4.11)
  EXPECT_EQ(out("layers", ItemType::kLayer), std::nullopt);
  EXPECT_EQ(out("split", ItemType::kVolume), ItemType::kVolume);
  EXPECT_EQ(out("split", ItemType::kPlanar), ItemType::kPlanar);
  EXPECT_EQ(out("split", ItemType::kShape2D), std::nullopt);
  EXPECT_EQ(out("extrude", ItemType::kPlanar), ItemType::kVolume);
  EXPECT_EQ(out("comp", ItemType::kVolume), ItemType::kPlanar);
}

}  // namespace
}  // namespace parti::grammar::tests
