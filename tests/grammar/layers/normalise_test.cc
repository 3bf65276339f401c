// Each sentence of Jesus 2018, 4.3, and errata 2, 3, 5, 6, 9a, on small scenes.
#include "grammar/layers/normalise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/grammar/layers/scene_support.h"

namespace parti::grammar::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Two layers over a façade of 10 m by 7 m.
struct TwoLayers : TestScene {
  ShapeIndex floors, door;
  TwoLayers() : TestScene(10, 7) {
    const auto layers = Layers("layers(\"floors\", \"door\") { Floors | Door }");
    floors = layers[0];
    door = layers[1];
  }
};

TEST(Normalise, ASceneWithoutShapesIsAllBackground) {
  TwoLayers scene;
  EXPECT_THAT(scene.Normalise(), IsEmpty());
  ASSERT_THAT(scene.uncovered, SizeIs(1));
  EXPECT_EQ(scene.uncovered[0].planar, 0u);
  EXPECT_EQ(scene.uncovered[0].polygon, Rectangle(Vec2(10, 7)));
}

TEST(Normalise, AShapeThatNothingCoversBecomesPlanarInPlace) {
  TwoLayers scene;
  const auto made = scene.Act(scene.floors, "segment(x) { 3: NIL | 2: tag(\"t\") A }");
  const Item laid_out = scene[made[0]];
  scene.shapes = made;
  EXPECT_THAT(scene.Normalise(), ElementsAre(ElementsAre(made[0])));
  const Shape& shape = scene.tree[made[0]];
  EXPECT_EQ(shape.item.type, ItemType::kPlanar);
  EXPECT_EQ(shape.item.scope.origin, laid_out.scope.origin);
  EXPECT_EQ(shape.item.scope.size, Vec3(2, 7, 0));
  EXPECT_EQ(shape.item.polygon, nullptr);
  EXPECT_EQ(shape.item.depth, 0);
  EXPECT_EQ(scene.tree.Name(shape.symbol), "A");
  EXPECT_THAT(shape.tags, SizeIs(1));
}

TEST(Normalise, PlaceholdersLeaveNoTrace) {
  TwoLayers scene;
  scene.Act(scene.floors, "segment(x) { ~1: A | ~1: B }");
  scene.Normalise();
  EXPECT_EQ(scene.UncoveredArea(), 70);
}

TEST(Normalise, FixedGeometryThatIsCoveredIsDiscarded) {
  TwoLayers scene;
  const ShapeIndex balcony = scene.Add(scene.floors, {2, 2}, {5, 4}, true);
  const ShapeIndex arch = scene.Add(scene.door, {4, 0}, {6, 3}, true);
  EXPECT_THAT(scene.Normalise(), ElementsAre(IsEmpty(), ElementsAre(arch)));
  EXPECT_EQ(scene[balcony].type, ItemType::kShape2D);
  EXPECT_DOUBLE_EQ(scene.UncoveredArea(), 70 - 6);  // what is discarded covers nothing
}

TEST(Normalise, GeometryThatIsNotFixedAdapts) {
  TwoLayers scene;
  const ShapeIndex balcony = scene.Add(scene.floors, {2, 2}, {5, 4}, false);
  scene.Add(scene.door, {4, 0}, {6, 3}, true);
  EXPECT_THAT(scene.Normalise(), SizeIs(2));
  EXPECT_DOUBLE_EQ(AreaOf(scene[balcony]), 6 - 1);
  EXPECT_EQ(PolygonOf(scene[balcony]).outer,
            (Ring{{0, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {0, 2}}));
}

TEST(Normalise, ADiscardedShapeDoesNotCover) {
  TestScene scene(10, 7);
  const auto layers = scene.Layers("layers(\"a\", \"b\", \"c\") { A | B | C }");
  const ShapeIndex low = scene.Add(layers[0], {0, 0}, {2, 2}, true);
  scene.Add(layers[1], {1, 1}, {4, 4}, true);
  const ShapeIndex top = scene.Add(layers[2], {3, 3}, {5, 5}, true);
  EXPECT_THAT(scene.Normalise(), ElementsAre(ElementsAre(low), IsEmpty(), ElementsAre(top)));
}

TEST(Normalise, TouchingAlongAnEdgeDoesNotOcclude) {
  TwoLayers scene;
  const ShapeIndex low = scene.Add(scene.floors, {0, 0}, {1.0 / 3, 7}, true);
  const ShapeIndex top = scene.Add(scene.door, {1.0 / 3 - 1e-12, 0}, {2, 7}, true);
  EXPECT_THAT(scene.Normalise(), ElementsAre(ElementsAre(low), ElementsAre(top)));
  EXPECT_EQ(scene[low].scope.size.x, 1.0 / 3);
}

TEST(Normalise, OverlapsBelowABillionthOfTheSceneAreNone) {
  TwoLayers scene;
  const ShapeIndex low = scene.Add(scene.floors, {0, 0}, {2, 2}, true);
  const ShapeIndex top = scene.Add(scene.door, {2 - 2e-4, 2 - 2e-4}, {4, 4}, true);
  EXPECT_THAT(scene.Normalise(), ElementsAre(ElementsAre(low), ElementsAre(top)));
  TwoLayers more;
  more.Add(more.floors, {0, 0}, {2, 2}, true);
  more.Add(more.door, {2 - 4e-4, 2 - 4e-4}, {4, 4}, true);
  EXPECT_THAT(more.Normalise(), ElementsAre(IsEmpty(), SizeIs(1)));
}

TEST(Normalise, ALaterLayerLiesOverAnEarlierOneWhateverTheDepths) {
  TwoLayers scene;
  const auto deep = scene.Act(scene.floors, "segment(x) { ~1: A }");
  const auto deeper = scene.Act(deep[0], "segment(y) { ~1: A }");
  scene.shapes = scene.Act(deeper[0], "segment(x) { ~1: A }");
  const ShapeIndex top = scene.Add(scene.door, {0, 0}, {10, 7});
  EXPECT_THAT(scene.Normalise(), ElementsAre(IsEmpty(), ElementsAre(top)));
}

TEST(Normalise, InALayerTheSmallerDepthLiesOnTop) {
  TwoLayers scene;
  const ShapeIndex tile = scene.Add(scene.floors, {0, 0}, {10, 7});
  const ShapeIndex window = scene.Add(tile, {4, 2}, {6, 4});
  EXPECT_THAT(scene.Normalise(), ElementsAre(ElementsAre(tile), ElementsAre(window)));
  EXPECT_DOUBLE_EQ(AreaOf(scene[tile]), 70 - 4);
  EXPECT_THAT(scene[tile].polygon->holes, SizeIs(1));
  EXPECT_THAT(scene.uncovered, IsEmpty());
}

TEST(Normalise, OfEqualsTheLaterLiesOnTop) {
  TwoLayers scene;
  const ShapeIndex first = scene.Add(scene.door, {0, 0}, {3, 3});
  const ShapeIndex second = scene.Add(scene.door, {2, 2}, {5, 5});
  scene.Normalise();
  EXPECT_DOUBLE_EQ(AreaOf(scene[first]), 8);
  EXPECT_DOUBLE_EQ(AreaOf(scene[second]), 9);
}

TEST(Normalise, ChildrenAreClippedToWhatTheyWereMadeFrom) {
  TwoLayers scene;
  const ShapeIndex tile = scene.Add(scene.floors, {2, 2}, {6, 6});
  const ShapeIndex middle = scene.Add(tile, {1, 1}, {4, 4});
  const ShapeIndex leaf = scene.Add(middle, {0, 3}, {10, 3.5});
  scene.shapes = {leaf};  // placeholders clip, too
  scene.Normalise();
  EXPECT_EQ(scene[leaf].scope.origin, Vec3(2, 3, 0));
  EXPECT_EQ(scene[leaf].scope.size, Vec3(2, 0.5, 0));
}

TEST(Normalise, ShapesAreClippedToThePlanarShape) {
  TestScene gable(PlanarFrom({{Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(5, 5, 0)}}).value());
  const auto layers = gable.Layers("layers(\"a\") { A }");
  const ShapeIndex strip = gable.Add(layers[0], {0, 0}, {10, 1});
  gable.Normalise();
  EXPECT_NEAR(AreaOf(gable[strip]), 9, 1e-12);
  EXPECT_NEAR(gable.UncoveredArea(), 16, 1e-12);
}

TEST(Normalise, SeveralPiecesAreSeparateShapesWithTheSameSymbol) {
  TwoLayers scene;
  const ShapeIndex band = scene.Add(scene.floors, {0, 3}, {10, 4});
  scene.tree.AddTag(band, scene.tree.Intern("t"));
  scene.Add(scene.door, {4, 0}, {6, 7});
  const auto pieces = scene.Normalise();
  ASSERT_THAT(pieces[0], SizeIs(2));
  EXPECT_EQ(pieces[0][0], band);
  for (const ShapeIndex i : pieces[0]) {
    const Shape& piece = scene.tree[i];
    EXPECT_EQ(scene.tree.node(i).parent, scene.floors);
    EXPECT_EQ(scene.tree.Name(piece.symbol), "Shape");
    EXPECT_THAT(piece.tags, SizeIs(1));
    EXPECT_EQ(piece.item.scope.size, Vec3(4, 1, 0));
  }
  EXPECT_EQ(scene[pieces[0][1]].scope.origin, Vec3(6, 3, 0));
}

// Errata 3: the lower left corner of an arch's bounds is none of its corners when it is cut there.
TEST(Normalise, APiecesScopeIsItsBoundingRectangle) {
  TwoLayers scene;
  const ShapeIndex tile = scene.Add(scene.floors, {0, 0}, {4, 4});
  scene.Add(scene.door, {0, 0}, {2, 2});
  scene.Normalise();
  EXPECT_EQ(scene[tile].scope.origin, Vec3(0, 0, 0));
  EXPECT_EQ(scene[tile].scope.size, Vec3(4, 4, 0));
  EXPECT_DOUBLE_EQ(AreaOf(scene[tile]), 12);
}

TEST(Normalise, HolesAreKeptAsHoles) {
  TwoLayers scene;
  scene.Add(scene.floors, {1, 1}, {3, 3});
  scene.AddPolygon(scene.door, Arch({5, 2}, {2, 3}));
  scene.Normalise();
  ASSERT_THAT(scene.uncovered, SizeIs(1));
  EXPECT_EQ(scene.uncovered[0].polygon.outer, Rectangle(Vec2(10, 7)).outer);
  EXPECT_THAT(scene.uncovered[0].polygon.holes, SizeIs(2));
}

TEST(Normalise, AnArchIsCutOutOfWhatLiesUnderIt) {
  TwoLayers scene;
  const ShapeIndex wall = scene.Add(scene.floors, {3, 0}, {7, 4});
  const ShapeIndex arch = scene.AddPolygon(scene.door, Arch({4, 0}, {2, 3}), true);
  const double area = AreaOf(scene[arch]);
  scene.Normalise();
  EXPECT_NEAR(AreaOf(scene[wall]), 16 - area, 1e-12);
  EXPECT_EQ(scene[arch].type, ItemType::kPlanar);
  EXPECT_DOUBLE_EQ(AreaOf(scene[arch]), area);
}

TEST(Normalise, AWholeOfWhichNothingIsLeftIsDiscarded) {
  TwoLayers scene;
  const ShapeIndex under = scene.Add(scene.floors, {1, 1}, {3, 3}, false);
  scene.Add(scene.door, {0, 0}, {4, 4}, true);
  EXPECT_THAT(scene.Normalise(), ElementsAre(IsEmpty(), SizeIs(1)));
  EXPECT_EQ(scene[under].type, ItemType::kShape2D);
}

/// Listings 4.3 and 4.4 laid out by hand.
struct BalconyAndDoor : TwoLayers {
  ShapeIndex balcony, arch;
  explicit BalconyAndDoor(std::string_view balcony_property = "") {
    const auto middle = Act(floors, "segment(y, 3, 2, 2) { NIL | Floor | NIL }");
    balcony = Act(middle[0], "segment(x, 3, 2, 3) { NIL | Balcony | NIL }")[0];
    if (!balcony_property.empty()) Act(balcony, balcony_property);
    const auto upright = Act(door, "segment(x, 3, 2, 3) { NIL | DoorTile | NIL }");
    const auto tile = Act(upright[0], "segment(y, 4, ~1) { ArchedDoor | NIL }");
    arch = Act(tile[0], "vectorial(\"M0,0 L0,0.5 C0,1 1,1 1,0.5 L1,0Z\", 50)")[0];
    shapes = {balcony, arch};
  }
};

TEST(Listing4_4, TheArchReplacesTheBalcony) {
  BalconyAndDoor scene;
  EXPECT_THAT(scene.Normalise(), ElementsAre(IsEmpty(), ElementsAre(scene.arch)));
  EXPECT_NEAR(scene.UncoveredArea(), 70 - AreaOf(scene[scene.arch]), 1e-9);
}

TEST(Listing4_5, TheBalconyAdaptsToTheArch) {
  BalconyAndDoor scene("set_property(\"fixed_geometry\", false)");
  EXPECT_THAT(scene.Normalise(), ElementsAre(ElementsAre(scene.balcony), ElementsAre(scene.arch)));
  const Item& balcony = scene[scene.balcony];
  EXPECT_GT(balcony.polygon->outer.size(), 20u);
  EXPECT_LT(AreaOf(balcony), 4);
  EXPECT_EQ(balcony.scope.origin, Vec3(3, 3, 0));
  EXPECT_EQ(balcony.scope.size, Vec3(2, 2, 0));
}

TEST(AppendBackground, ComesLastAndIsTagged) {
  TwoLayers scene;
  scene.Add(scene.floors, {4, 0}, {6, 7});
  scene.Normalise();
  AppendBackground(&scene.tree, scene.uncovered);
  std::vector<ShapeIndex> children;
  for (ShapeIndex i = scene.tree.node(0).first_child; i != kNoShape;
       i = scene.tree.node(i).next_sibling) {
    children.push_back(i);
  }
  ASSERT_THAT(children, SizeIs(4));  // two layers, two parts of the wall
  for (const ShapeIndex i : {children[2], children[3]}) {
    EXPECT_EQ(scene.tree[i].symbol, kNoName);
    EXPECT_THAT(scene.tree[i].tags, ElementsAre(scene.tree.Find("background")));
    EXPECT_EQ(scene[i].type, ItemType::kPlanar);
    EXPECT_EQ(scene[i].scope.size, Vec3(4, 7, 0));
  }
  EXPECT_THAT(scene.tree.Leaves(), SizeIs(3));
}

// Listing 4.8: windows after frames.
TEST(PlaceDeferred, TakesWhatNothingCovers) {
  TwoLayers scene;
  scene.shapes = scene.Act(scene.door, "segment(x) { 1: Frame | ~1: NIL | 1: Frame }");
  scene.Normalise();
  const auto pieces = PlaceDeferred(&scene.tree, scene.floors, &scene.uncovered);
  ASSERT_TRUE(pieces.has_value());
  EXPECT_THAT(*pieces, ElementsAre(scene.floors));
  EXPECT_EQ(scene[scene.floors].type, ItemType::kPlanar);
  EXPECT_EQ(scene[scene.floors].scope.origin, Vec3(1, 0, 0));
  EXPECT_EQ(scene[scene.floors].scope.size, Vec3(8, 7, 0));
  EXPECT_THAT(scene.uncovered, IsEmpty());
}

TEST(PlaceDeferred, OneShapePerConnectedPiece) {
  TwoLayers scene;
  scene.shapes = scene.Act(scene.door, "segment(x) { ~1: NIL | 2: Frame | ~1: NIL }");
  scene.Normalise();
  const auto pieces = PlaceDeferred(&scene.tree, scene.floors, &scene.uncovered);
  ASSERT_THAT(*pieces, SizeIs(2));
  EXPECT_EQ((*pieces)[0], scene.floors);
  EXPECT_EQ(scene.tree.node((*pieces)[1]).parent, scene.planar);
  EXPECT_EQ(scene.tree[(*pieces)[1]].symbol, scene.tree[scene.floors].symbol);
}

TEST(PlaceDeferred, A2DShapeTakesItsOwnPart) {
  TwoLayers scene;
  const ShapeIndex deferred = scene.Act(scene.floors, "segment(y) { 3: A }")[0];
  scene.shapes = scene.Act(scene.door, "segment(x) { 4: Frame }");
  scene.Normalise();
  EXPECT_THAT(*PlaceDeferred(&scene.tree, deferred, &scene.uncovered), ElementsAre(deferred));
  EXPECT_EQ(scene[deferred].scope.size, Vec3(6, 3, 0));
  EXPECT_DOUBLE_EQ(scene.UncoveredArea(), 24);
}

// Errata 9a: several follow in order, each after what came before.
TEST(PlaceDeferred, TheNextTakesWhatTheFirstsSceneLeft) {
  TestScene scene(10, 7);
  const auto layers = scene.Layers("layers(\"a\", \"b\", \"c\") { @A | @B | C }");
  scene.shapes = scene.Act(layers[2], "segment(x) { 2: Frame }");
  scene.Normalise();
  ASSERT_THAT(*PlaceDeferred(&scene.tree, layers[0], &scene.uncovered), ElementsAre(layers[0]));
  scene.planar = layers[0];
  scene.shapes = scene.Act(layers[0], "segment(y) { 4: Sill }");
  auto inner = Normalise(&scene.tree, layers[0], scene.shapes);
  ASSERT_TRUE(inner.has_value());
  EXPECT_EQ(scene[scene.shapes[0]].scope.size, Vec3(8, 4, 0));
  const auto pieces = PlaceDeferred(&scene.tree, layers[1], &inner->uncovered);
  ASSERT_THAT(*pieces, ElementsAre(layers[1]));
  EXPECT_EQ(scene[layers[1]].scope.origin, Vec3(2, 4, 0));
  EXPECT_EQ(scene[layers[1]].scope.size, Vec3(8, 3, 0));
  EXPECT_THAT(inner->uncovered, IsEmpty());
}

TEST(PlaceDeferred, WhereEverythingIsCoveredNothingIsMade) {
  TwoLayers scene;
  scene.shapes = scene.Act(scene.door, "segment(x) { ~1: All }");
  scene.Normalise();
  EXPECT_THAT(*PlaceDeferred(&scene.tree, scene.floors, &scene.uncovered), IsEmpty());
  EXPECT_EQ(scene[scene.floors].type, ItemType::kLayer);
}

}  // namespace
}  // namespace parti::grammar::tests
