#include "app/session_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "app/lot_values.h"
#include "base/text_file.h"
#include "grammar/asset_library.h"

namespace parti::app {

std::shared_ptr<const Ground> GroundOf(std::vector<Lot> lots) {
  auto ground = std::make_shared<Ground>();
  for (const Lot& lot : lots) {
    ground->roots.push_back(std::make_shared<const grammar::ShapeTree>(lot.item));
  }
  ground->lots = std::move(lots);
  return ground;
}

Result<std::shared_ptr<const Ground>> GroundOf(std::vector<Lot> lots,
                                               std::shared_ptr<const RuleSource> source) {
  if (!source) return GroundOf(std::move(lots));
  const auto rules = RulesOf(*source);
  if (!rules) return tl::unexpected<Error>(rules.error().front());
  return GroundOf(std::move(lots), std::move(source), *rules);
}

Result<std::shared_ptr<const Ground>> GroundOf(std::vector<Lot> lots,
                                               std::shared_ptr<const RuleSource> source,
                                               const grammar::RuleSet& rules,
                                               const grammar::RuleThreads& threads) {
  std::vector<grammar::Item> items;
  std::vector<std::vector<grammar::GivenValue>> given;
  for (const Lot& lot : lots) {
    auto values = ValuesOf(lot, rules, source->settings);
    if (!values) return Fail(values);
    items.push_back(lot.item);
    given.push_back(std::move(*values));
  }
  grammar::AssetLibrary assets([](const std::string& path) { return ReadFile(path); });
  grammar::RuleThreads watched = threads;
  watched.assets = &assets;
  auto trees = grammar::DeriveRules(rules, source->settings, items, watched, given);
  if (!trees) return Fail(trees);
  auto ground = std::make_shared<Ground>();
  for (grammar::ShapeTree& tree : *trees) {
    ground->roots.push_back(std::make_shared<const grammar::ShapeTree>(std::move(tree)));
  }
  ground->lots = std::move(lots);
  ground->source = std::move(source);
  ground->underived =
      std::make_shared<const Ground>(Ground{ground->lots, {}, ground->source, nullptr});
  return ground;
}

Result<std::shared_ptr<const Ground>> WithRoots(std::shared_ptr<const Ground> ground,
                                                const Model* nearby,
                                                const grammar::RuleThreads& threads) {
  if (ground->roots.size() == ground->lots.size()) return ground;
  if (nearby != nullptr && nearby->ground->underived == ground) return nearby->ground;
  const auto rules = RulesOf(*ground->source);
  if (!rules) return tl::unexpected<Error>(rules.error().front());
  auto made = GroundOf(ground->lots, ground->source, *rules, threads);
  if (!made) return Fail(made);
  Ground rooted = **made;
  rooted.underived = std::move(ground);
  return std::make_shared<const Ground>(std::move(rooted));
}

Result<Model> BuiltOn(std::vector<Lot> lots, grammar::Trees trees, grammar::Unfit unfit) {
  return Derived(GroundOf(std::move(lots)),
                 std::make_shared<const grammar::Trees>(std::move(trees)), nullptr, unfit);
}

Result<Model> Derived(std::shared_ptr<const Ground> ground,
                      std::shared_ptr<const grammar::Trees> rules, const Model* previous,
                      grammar::Unfit unfit) {
  Model model{std::move(ground), std::move(rules), {}};
  const size_t count = model.ground->roots.size();
  const bool goes_on = previous != nullptr && previous->derived.size() == count;
  for (size_t i = 0; i < count; ++i) {
    auto derivation =
        grammar::Derive(model.trees(), *model.ground->roots[i], {},
                        goes_on ? previous->derived[i].get() : nullptr, nullptr, unfit);
    if (!derivation) {
      Error error = derivation.error();
      if (count > 1) error.message = fmt::format("lot-{}: {}", i, error.message);
      return tl::unexpected<Error>(std::move(error));
    }
    model.derived.push_back(std::make_shared<grammar::Derivation>(std::move(*derivation)));
  }
  return model;
}

std::vector<NodeProblem> ProblemsOf(const Model& model) {
  std::vector<NodeProblem> problems;
  for (size_t lot = 0; lot < model.derived.size(); ++lot) {
    const grammar::Derivation& derivation = *model.derived[lot];
    for (const grammar::DerivationProblem& problem : derivation.problems) {
      problems.push_back(
          {derivation.nodes[problem.result].path, lot, problem.shapes, problem.error});
    }
  }
  return problems;
}

std::string IdOf(const Model& model, const ShapeRef& ref) {
  const std::string path = model.derived[ref.lot]->tree.IdOf(ref.shape);
  return model.derived.size() > 1 ? fmt::format("lot-{}:{}", ref.lot, path) : path;
}

Result<ShapeRef> RefAt(const Model& model, std::string_view id) {
  constexpr std::string_view kLot = "lot-";
  ShapeRef ref;
  std::string_view path = id;
  if (model.derived.size() > 1) {
    const size_t colon = id.find(':');
    const char* const end = id.data() + std::min(colon, id.size());
    const bool named = id.starts_with(kLot) && colon != std::string_view::npos;
    const auto read = std::from_chars(id.data() + (named ? kLot.size() : 0), end, ref.lot);
    if (!named || read.ec != std::errc() || read.ptr != end) {
      return Fail(ErrorCode::kBadText, fmt::format("'{}' is not the id of a shape", id),
                  "a lot and a path, as in lot-3:0/2/5");
    }
    path = id.substr(colon + 1);
  }
  if (ref.lot >= model.derived.size()) {
    return Fail(ErrorCode::kUnknownName, fmt::format("there is no shape '{}'", id),
                fmt::format("the model has {} lots", model.derived.size()));
  }
  const auto shape = model.derived[ref.lot]->tree.AtId(path);
  if (!shape) return Fail(shape);
  ref.shape = *shape;
  return ref;
}

std::vector<ShapeRef> VisibleShapes(const Model& model) {
  std::vector<ShapeRef> shapes;
  for (size_t lot = 0; lot < model.derived.size(); ++lot) {
    for (const grammar::ShapeIndex leaf : model.derived[lot]->tree.Leaves()) {
      shapes.push_back({lot, leaf});
    }
  }
  return shapes;
}

Selection SelectionOf(const Model& model, std::vector<ShapeRef> shapes) {
  std::vector<const grammar::ShapeTree*> trees;
  for (const auto& derivation : model.derived) trees.push_back(&derivation->tree);
  std::vector<grammar::TappedShape> tapped;
  for (const ShapeRef& ref : shapes) tapped.push_back({ref.lot, ref.shape});
  auto candidates = grammar::Generalise(trees, tapped);
  return {std::move(shapes), std::move(candidates)};
}

const grammar::Shape& ShapeAt(const Model& model, const ShapeRef& ref) {
  return model.derived[ref.lot]->tree[ref.shape];
}

}  // namespace parti::app
