#include "tests/facades/derived_facade.h"

#include <fmt/format.h>

#include "app/rule_source.h"
#include "base/check.h"

namespace parti::tests {

using grammar::ShapeIndex;
using grammar::ShapeTree;

app::Model ModelOf(const AnnotatedFacade& facade, const std::string& rules) {
  auto source = std::make_shared<app::RuleSource>();
  source->files = {{facade.id + ".cga", rules}};
  auto lots = app::ParseLots(LotOf(facade));
  CHECK(lots.has_value(), "a lot as wide as the photograph");
  auto ground = app::GroundOf(std::move(*lots), source);
  CHECK(ground.has_value(), ground ? "" : FormatError(ground.error()).c_str());
  auto model = app::Derived(*ground, std::make_shared<const grammar::Trees>(), nullptr);
  CHECK(model.has_value(), "no tree, so nothing that could fail");
  return std::move(*model);
}

std::vector<ShapeIndex> ShapesNamed(const ShapeTree& tree, ShapeIndex root,
                                    std::string_view symbol) {
  std::vector<ShapeIndex> found;
  for (ShapeIndex i = root; i < tree.size(); ++i) {
    if (tree.Name(tree[i].symbol) != symbol) continue;
    if (i == root || tree.IsAncestor(root, i)) found.push_back(i);
  }
  return found;
}

std::vector<ShapeIndex> PlacedElements(const ShapeTree& tree, size_t wall) {
  std::vector<ShapeIndex> placed;
  for (const LabelLayer& layer : LabelLayers()) {
    const auto layers = ShapesNamed(tree, 0, fmt::format("{}s{}", layer.symbol, wall + 1));
    for (const ShapeIndex parent : layers) {
      for (ShapeIndex i = tree.node(parent).first_child; i != grammar::kNoShape;
           i = tree.node(i).next_sibling) {
        placed.push_back(i);
      }
    }
  }
  return placed;
}

std::vector<size_t> ElementsByLayer(const AnnotatedFacade& facade) {
  std::vector<size_t> order;
  for (size_t layer = 0; layer < LabelLayers().size(); ++layer) {
    for (size_t i = 0; i < facade.elements.size(); ++i) {
      if (LayerOf(facade.elements[i].label) == layer) order.push_back(i);
    }
  }
  return order;
}

}  // namespace parti::tests
