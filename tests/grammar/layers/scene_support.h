// Scenes for tests, laid out by operations as a driver would, and what they come to.
#pragma once

#include <gtest/gtest.h>

#include "base/random.h"
#include "grammar/action_text.h"
#include "grammar/layers/normalise.h"
#include "grammar/selection_action_plan.h"

namespace parti::grammar::tests {

/// An upright façade; its lower left corner is the world's origin, and it looks south.
inline Item Facade(double width, double height) {
  Item facade;
  facade.scope.size = Vec3(width, height, 0);
  facade.facing = facade.scope.z;
  return facade;
}

/// A scene that grows by operations, and is normalised once.
struct TestScene {
  ShapeTree tree;
  ShapeIndex planar = 0;
  std::vector<ShapeIndex> shapes;  ///< those that are no placeholders, to be in tree order
  std::vector<Uncovered> uncovered;

  explicit TestScene(Item facade) : tree(std::move(facade), "Facade") {}
  TestScene(double width, double height) : TestScene(Facade(width, height)) {}

  /// Acts on a shape; returns its new children.
  std::vector<ShapeIndex> Act(ShapeIndex shape, std::string_view text) {
    const Action action = ParseAction(text).value();
    const uint32_t before = tree.size();
    const auto acted = grammar::Act(PlanOf(action, &tree), shape, 1'000'000, &tree);
    EXPECT_TRUE(acted.has_value()) << text << ": " << (acted ? "" : acted.error().message);
    std::vector<ShapeIndex> made;
    for (uint32_t i = before; i < tree.size(); ++i) made.push_back(i);
    return made;
  }
  std::vector<ShapeIndex> Layers(std::string_view text) { return Act(planar, text); }

  /// A 2D shape laid out in a layer, not by segment; without a polygon its bounds are [low, high].
  ShapeIndex Add(ShapeIndex parent, const Vec2& low, const Vec2& high, bool fixed = false) {
    Item item = tree[parent].item;
    item.type = ItemType::kShape2D;
    item.fixed_geometry = fixed;
    item.depth -= 1;
    item.polygon = nullptr;
    item.scope.origin = tree[planar].item.scope.ToWorld(Vec3(low.x, low.y, 0));
    item.scope.size = Vec3(high.x - low.x, high.y - low.y, 0);
    shapes.push_back(tree.Append(parent, std::move(item), tree.Intern("Shape"), nullptr));
    return shapes.back();
  }
  ShapeIndex AddPolygon(ShapeIndex parent, Polygon polygon, bool fixed = false) {
    const Box2 box = Bounds(polygon);
    const ShapeIndex shape = Add(parent, box.low, box.high, fixed);
    for (Vec2& p : polygon.outer) p -= box.low;
    for (Ring& hole : polygon.holes) {
      for (Vec2& p : hole) p -= box.low;
    }
    Item item = tree[shape].item;
    item.polygon = std::make_shared<const Polygon>(std::move(polygon));
    tree.SetItem(shape, std::move(item));
    return shape;
  }

  std::vector<std::vector<ShapeIndex>> Normalise() {
    auto scene = grammar::Normalise(&tree, planar, shapes);
    EXPECT_TRUE(scene.has_value()) << (scene ? "" : scene.error().message);
    if (!scene) return {};
    uncovered = std::move(scene->uncovered);
    return std::move(scene->pieces);
  }

  const Item& operator[](ShapeIndex shape) const { return tree[shape].item; }
  double UncoveredArea() const {
    double area = 0;
    for (const Uncovered& free : uncovered) area += Area(free.polygon);
    return area;
  }
};

/// A half ellipse on a rectangle: "M0,0 L0,h/2 …" of Listing 4.4, sampled.
inline Polygon Arch(const Vec2& low, const Vec2& size, int samples = 24) {
  constexpr double kHalfTurn = 3.141592653589793;
  Polygon arch{{low, low + Vec2(size.x, 0)}, {}};
  for (int i = 0; i <= samples; ++i) {
    const double angle = kHalfTurn * i / samples;
    const Vec2 part(0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle));
    arch.outer.push_back(low + part * size);
  }
  return arch;
}

}  // namespace parti::grammar::tests
