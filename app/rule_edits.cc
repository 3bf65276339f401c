#include "app/rule_edits.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/placing/placed_layers.h"
#include "grammar/rules/layer_list.h"

namespace parti::app {
namespace {

using Failed = tl::unexpected<std::vector<Error>>;

Error NoFiles() {
  return {ErrorCode::kNothingMade, "this building is not made by rule files",
          "make one of a rule file: parti derive house.cga --save house.parti", std::nullopt};
}

Error NoSuchFile(const RuleSource& source, const std::string& name) {
  std::vector<std::string> names;
  for (const grammar::RuleFile& file : source.files) names.push_back(file.name);
  const auto meant = DidYouMean(name, names);
  return {ErrorCode::kUnknownName, fmt::format("the building has no rule file '{}'", name),
          meant ? fmt::format("did you mean '{}'?", *meant)
                : fmt::format("files are {}", fmt::join(names, ", ")),
          std::nullopt};
}

Error NoSuchElement(const std::vector<grammar::InteractiveRules>& elements,
                    const std::string& name) {
  std::vector<std::string> names;
  for (const grammar::InteractiveRules& one : elements) names.push_back(one.layer.name);
  return {ErrorCode::kUnknownName, fmt::format("the rules place no element '{}' by numbers", name),
          names.empty() ? "docs/layers.md says which rules do: \"Placing by hand\""
                        : fmt::format("they place {}", fmt::join(names, ", ")),
          std::nullopt};
}

/// The model on the ground that another source makes of its lots.
EditedModel Remade(const Model& model, RuleSource source) {
  const auto rules = RulesOf(source);
  if (!rules) return Failed(rules.error());
  // The old texts were read before; where they can't be any more, the trees stay.
  const auto old_rules = RulesOf(*model.ground->source);
  const bool other_trees = old_rules && old_rules->trees != rules->trees;
  auto ground =
      GroundOf(model.lots(), std::make_shared<const RuleSource>(std::move(source)), *rules);
  if (!ground) return Failed({ground.error()});
  auto trees = other_trees ? std::make_shared<const grammar::Trees>(rules->trees) : model.rules;
  auto made = Derived(std::move(*ground), std::move(trees), nullptr, grammar::Unfit::kSkip);
  if (!made) return Failed({made.error()});
  return std::move(*made);
}

/// The edits with the layer at `at` of a listed rule changed.
grammar::LayerEdits Changed(grammar::LayerEdits edits, const grammar::RuleSet& rules,
                            const grammar::LayeredRule& listed, size_t at,
                            const ChangeLayer& change) {
  const std::string& name = listed.layers[at].name;
  switch (change.how) {
    case ChangeLayer::How::kOff:
    case ChangeLayer::How::kOn:
      return Switched(std::move(edits), listed.rule, name, change.how == ChangeLayer::How::kOn);
    case ChangeLayer::How::kUp:
      return Moved(std::move(edits), rules, listed, at, at > 0 ? at - 1 : at);
    case ChangeLayer::How::kDown:
      return Moved(std::move(edits), rules, listed, at, std::min(at + 1, listed.layers.size() - 1));
    case ChangeLayer::How::kGets:
      break;
  }
  return Given(std::move(edits), listed.rule, name, change.symbol);
}

/// The shape of the same id and symbol.
std::optional<ShapeRef> SameIn(const Model& after, const Model& before, const ShapeRef& ref) {
  const auto same = RefAt(after, IdOf(before, ref));
  if (!same) return std::nullopt;
  const auto symbol = [](const Model& model, const ShapeRef& r) {
    return model.derived[r.lot]->tree.Name(ShapeAt(model, r).symbol);
  };
  return symbol(before, ref) == symbol(after, *same) ? std::optional(*same) : std::nullopt;
}

std::string PlacedMessage(const Error& error) {
  if (!error.place) return error.message;
  return fmt::format("{}:{}: {}", error.place->line, error.place->column, error.message);
}

}  // namespace

EditedModel WithRuleText(const Model& model, const SetRuleText& edit) {
  if (!model.ground->source) return Failed({NoFiles()});
  RuleSource source = *model.ground->source;
  const auto file =
      std::find_if(source.files.begin(), source.files.end(),
                   [&](const grammar::RuleFile& one) { return one.name == edit.file; });
  if (file == source.files.end()) return Failed({NoSuchFile(source, edit.file)});
  file->text = edit.text;
  return Remade(model, std::move(source));
}

EditedModel WithLayerEdits(const Model& model, const EditLayers& edit) {
  if (!model.ground->source) return Failed({NoFiles()});
  RuleSource source = *model.ground->source;
  source.layers = edit.layers;
  return Remade(model, std::move(source));
}

EditedModel WithLayerChange(const Model& model, const ChangeLayer& change) {
  if (!model.ground->source) return Failed({NoFiles()});
  RuleSource source = *model.ground->source;
  const grammar::LayerEdits before = std::exchange(source.layers, {});
  const auto rules = RulesOf(source);
  if (!rules) return Failed(rules.error());
  const auto known = grammar::CheckLayer(change.layer, grammar::LayerNames(*rules));
  if (!known) return Failed(std::vector<Error>{known.error()});
  for (const grammar::LayeredRule& listed : ListLayers(*rules, before)) {
    for (size_t i = 0; i < listed.layers.size(); ++i) {
      if (grammar::LayerName(listed.rule, listed.layers[i].name) != change.layer) continue;
      source.layers = Changed(before, *rules, listed, i, change);
    }
  }
  return Remade(model, std::move(source));
}

EditedModel WithElementPlaced(const Model& model, const PlaceElement& edit) {
  if (!model.ground->source) return Failed({NoFiles()});
  RuleSource source = *model.ground->source;
  const auto rules = RulesInReach(source);
  if (!rules) return Failed(RulesOf(source).error());
  const auto elements = grammar::InteractiveLayersOf(*rules);
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const auto& one) { return one.layer.name == edit.element; });
  if (found == elements.end()) return Failed({NoSuchElement(elements, edit.element)});
  grammar::InteractiveLayer now = found->layer;
  now.left = edit.left.value_or(now.left);
  now.bottom = edit.bottom.value_or(now.bottom);
  now.width = edit.width.value_or(now.width);
  now.height = edit.height.value_or(now.height);
  source.files[found->left.file].text = grammar::TextWith(*rules, *found, now);
  return Remade(model, std::move(source));
}

std::vector<ShapeRef> KeptShapes(const Model& before, const std::vector<ShapeRef>& shapes,
                                 const Model& after) {
  std::vector<ShapeRef> kept;
  for (ShapeRef ref : shapes) {
    std::optional<ShapeRef> same = SameIn(after, before, ref);
    const grammar::ShapeTree& tree = before.derived[ref.lot]->tree;
    while (!same && ref.shape != 0) {
      ref.shape = tree.node(ref.shape).parent;
      if (ref.shape != 0) same = SameIn(after, before, ref);
    }
    if (same && std::find(kept.begin(), kept.end(), *same) == kept.end()) kept.push_back(*same);
  }
  return kept;
}

Error AsOne(const std::vector<Error>& errors) {
  Error all = errors.front();
  for (size_t i = 1; i < errors.size(); ++i) {
    all.message += fmt::format("; {}", PlacedMessage(errors[i]));
  }
  return all;
}

}  // namespace parti::app
