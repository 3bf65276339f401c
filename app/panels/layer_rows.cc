#include "app/panels/layer_rows.h"

#include <algorithm>

namespace parti::app::panels {

const grammar::RuleSet* KnownRules::Of(const Model& model) {
  const auto& source = model.ground->source;
  if (source == of_) return rules_.get();
  of_ = source;
  rules_.reset();
  if (!source) return nullptr;
  RuleSource texts = *source;
  texts.layers = {};
  if (auto rules = RulesOf(texts)) {
    rules_ = std::make_shared<const grammar::RuleSet>(std::move(*rules));
  }
  return rules_.get();
}

ShownLayers LayersOf(const SessionState& state, const grammar::RuleSet& rules) {
  const Model& model = state.model;
  std::vector<grammar::LayeredRule> all = ListLayers(rules, model.ground->source->layers);
  if (state.selection.shapes.empty()) return {false, std::move(all)};
  const ShapeRef& face = state.selection.shapes.back();
  const grammar::ShapeTree& tree = model.derived[face.lot]->tree;
  for (auto shape = face.shape; shape != grammar::kNoShape; shape = tree.node(shape).parent) {
    const auto made_by = std::find_if(all.begin(), all.end(), [&](const auto& one) {
      return one.rule == tree.Name(tree[shape].symbol);
    });
    if (made_by != all.end()) return {true, {std::move(*made_by)}};
  }
  return {false, std::move(all)};
}

}  // namespace parti::app::panels
