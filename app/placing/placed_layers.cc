#include "app/placing/placed_layers.h"

#include <algorithm>
#include <utility>

namespace parti::app {
namespace {

using grammar::InteractiveRules;
using grammar::ShapeIndex;
using grammar::ShapeTree;

/// The elements that rules know, by the symbols that the tree knows.
class Elements {
 public:
  Elements(const ShapeTree& tree, const grammar::RuleSet& rules) : tree_(tree) {
    for (InteractiveRules& found : grammar::InteractiveLayersOf(rules)) {
      const grammar::NameId symbol = tree.Find(found.layer.name);
      if (symbol != grammar::kNoName) known_.emplace_back(symbol, std::move(found));
    }
  }

  bool none() const { return known_.empty(); }

  /// Of the scene of a planar shape, the shape itself included, in the order in which they lie over
  /// each other.
  std::vector<PlacedLayer> In(ShapeIndex planar) const {
    std::vector<std::pair<uint16_t, PlacedLayer>> found;
    std::vector<ShapeIndex> left{planar};
    while (!left.empty()) {
      const ShapeIndex shape = left.back();
      left.pop_back();
      AddAt(shape, &found);
      for (ShapeIndex child = tree_.node(shape).first_child; child != grammar::kNoShape;
           child = tree_.node(child).next_sibling) {
        if (grammar::IsOfScene(tree_[child].item.type)) left.push_back(child);
      }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<PlacedLayer> layers;
    layers.reserve(found.size());
    for (auto& [layer, placed] : found) layers.push_back(std::move(placed));
    return layers;
  }

 private:
  void AddAt(ShapeIndex shape, std::vector<std::pair<uint16_t, PlacedLayer>>* found) const {
    const grammar::Item& item = tree_[shape].item;
    for (const auto& [symbol, rules] : known_) {
      if (symbol != tree_[shape].symbol) continue;
      found->emplace_back(item.layer, PlacedLayer{rules, item.scope});
    }
  }

  const ShapeTree& tree_;
  std::vector<std::pair<grammar::NameId, InteractiveRules>> known_;
};

}  // namespace

std::shared_ptr<const grammar::RuleSet> RulesInReach(const RuleSource& source) {
  auto rules = RulesOf(source);
  if (!rules) return nullptr;
  for (const auto& [name, value] : source.settings.attributes) {
    for (grammar::Attribute& attribute : rules->attributes) {
      if (attribute.name == name) attribute.value.range = {};
    }
  }
  return std::make_shared<const grammar::RuleSet>(std::move(*rules));
}

PlacedLayers PlacedLayersOf(const Model& model, const std::vector<ShapeRef>& selected,
                            std::shared_ptr<const grammar::RuleSet> rules) {
  if (selected.empty() || rules == nullptr) return {};
  const ShapeRef& last = selected.back();
  const ShapeTree& tree = model.derived[last.lot]->tree;
  const Elements elements(tree, *rules);
  if (elements.none()) return {};
  for (ShapeIndex at = last.shape; at != grammar::kNoShape; at = tree.node(at).parent) {
    const grammar::Item& item = tree[at].item;
    if (item.type != grammar::ItemType::kPlanar) continue;
    auto layers = elements.In(at);
    if (!layers.empty()) return {std::move(rules), item.scope, std::move(layers)};
  }
  return {};
}

PlacedLayers PlacedWith(PlacedLayers placed, size_t layer, const grammar::InteractiveLayer& now) {
  const InteractiveRules changed = placed.layers[layer].rules;
  for (PlacedLayer& one : placed.layers) one.rules.layer = Following(one.rules, changed, now);
  return placed;
}

}  // namespace parti::app
