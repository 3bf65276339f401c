// Real façades as layered grammars: every annotated rectangle is in the scene, and what is seen of
// it afterwards is what nothing covers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/facades/derived_facade.h"
#include "tests/facades/visible_area.h"
#include "tests/support/data.h"

namespace parti::tests {
namespace {

using grammar::Item;
using grammar::ItemType;
using grammar::ShapeIndex;
using grammar::ShapeTree;

const char* const kData = "facades/cmp-dev.jsonl";
/// What a rectangle's corners may be off by: sizes are added up along rows.
constexpr double kPlace_m = 1e-6;
constexpr double kArea_m2 = 1e-5;

std::vector<AnnotatedFacade> Annotated(const std::string& path) {
  auto facades = ReadAnnotatedFacades(path);
  EXPECT_TRUE(facades) << FormatError(facades.error());
  return facades ? *facades : std::vector<AnnotatedFacade>();
}

/// The symbol of an element's own shape: "Window".
std::string SymbolOf(const AnnotatedFacade& facade, size_t element) {
  return std::string(LabelLayers()[LayerOf(facade.elements[element].label)].symbol);
}

/// The rectangle of a flat item in the coordinates of the sheet.
grammar::Box2 BoxOn(const Item& sheet, const Item& item) {
  const Vec3 low = sheet.scope.ToLocal(item.scope.origin);
  return {Vec2(low), Vec2(low) + Vec2(item.scope.size)};
}

double FarthestCorner(const grammar::Box2& a, const grammar::Box2& b) {
  return std::max(glm::distance(a.low, b.low), glm::distance(a.high, b.high));
}

TEST(RealFacades, EveryAnnotatedRectangleIsInTheSceneBeforeItIsNormalised) {
  PARTI_NEED_DATA(path, kData);
  size_t rectangles = 0;
  for (const AnnotatedFacade& facade : Annotated(path)) {
    SCOPED_TRACE(facade.id);
    const auto model = ModelOf(facade, RulesOf(facade, false));
    const ShapeTree& tree = model.derived[0]->tree;
    const Item& sheet = tree[ShapesNamed(tree, 0, "Sheet").at(0)].item;
    const auto order = ElementsByLayer(facade);
    for (size_t wall = 0; wall < facade.walls.size(); ++wall) {
      const auto placed = PlacedElements(tree, wall);
      ASSERT_EQ(placed.size(), order.size());
      for (size_t i = 0; i < placed.size(); ++i) {
        const auto shapes = ShapesNamed(tree, placed[i], SymbolOf(facade, order[i]));
        ASSERT_EQ(shapes.size(), 1u) << tree.IdOf(placed[i]);
        const Item& item = tree[shapes[0]].item;
        EXPECT_EQ(item.type, ItemType::kShape2D);
        EXPECT_LT(FarthestCorner(BoxOn(sheet, item), facade.elements[order[i]].box), kPlace_m);
        ++rectangles;
      }
    }
  }
  fmt::print("{} rectangles\n", rectangles);
  EXPECT_GT(rectangles, 5000u);
}

/// What is seen of an element: the planar shapes that the normalisation made of it.
double SeenArea(const ShapeTree& tree, ShapeIndex placed, const std::string& symbol) {
  double area = 0;
  for (const ShapeIndex i : ShapesNamed(tree, placed, symbol)) {
    if (tree[i].item.type == ItemType::kPlanar) area += AreaOf(tree[i].item);
  }
  return area;
}

double BackgroundArea(const ShapeTree& tree, ShapeIndex wall) {
  double area = 0;
  for (ShapeIndex i = tree.node(wall).first_child; i != grammar::kNoShape;
       i = tree.node(i).next_sibling) {
    if (tree[i].item.type == ItemType::kPlanar) area += AreaOf(tree[i].item);
  }
  return area;
}

TEST(RealFacades, WhatIsSeenOfEachRectangleIsWhatNothingCovers) {
  PARTI_NEED_DATA(path, kData);
  size_t seen = 0, adapted = 0;
  for (const AnnotatedFacade& facade : Annotated(path)) {
    const auto model = ModelOf(facade, RulesOf(facade));
    const ShapeTree& tree = model.derived[0]->tree;
    const auto order = ElementsByLayer(facade);
    for (size_t wall = 0; wall < facade.walls.size(); ++wall) {
      SCOPED_TRACE(fmt::format("{}, wall {}", facade.id, wall + 1));
      const auto expected = VisibleAreas(facade, facade.walls[wall]);
      const auto placed = PlacedElements(tree, wall);
      ASSERT_EQ(placed.size(), order.size());
      double all = 0;
      for (size_t i = 0; i < placed.size(); ++i) {
        const grammar::Box2& box = facade.elements[order[i]].box;
        const double area = SeenArea(tree, placed[i], SymbolOf(facade, order[i]));
        EXPECT_NEAR(area, expected[order[i]], kArea_m2) << tree.IdOf(placed[i]);
        const double whole = (box.high.x - box.low.x) * (box.high.y - box.low.y);
        seen += area > 0 ? 1 : 0;
        adapted += area > 0 && area < whole - kArea_m2 ? 1 : 0;
        all += area;
      }
      const auto name = fmt::format("Facade{}", wall + 1);
      const Vec2 size = facade.walls[wall].high - facade.walls[wall].low;
      const auto walls = ShapesNamed(tree, 0, name);
      ASSERT_EQ(walls.size(), 1u);
      EXPECT_NEAR(all + BackgroundArea(tree, walls[0]), size.x * size.y, 1e-3);
    }
  }
  fmt::print("{} seen, {} of them in part\n", seen, adapted);
  EXPECT_GT(adapted, 500u);
}

}  // namespace
}  // namespace parti::tests
