#include "app/session_state.h"

#include <fmt/format.h>

#include <algorithm>

namespace parti::app {

namespace {

/// Runs the model's trees on every lot; `previous` (may be null) stands on the same lots.
Result<Model> Derived(Model model, const Model* previous) {
  model.derived.clear();
  for (size_t i = 0; i < model.roots.size(); ++i) {
    auto derivation = grammar::Derive(model.trees, *model.roots[i], {},
                                      previous ? previous->derived[i].get() : nullptr);
    if (!derivation) {
      Error error = derivation.error();
      if (model.roots.size() > 1) error.message = fmt::format("lot-{}: {}", i, error.message);
      return tl::unexpected<Error>(std::move(error));
    }
    model.derived.push_back(std::make_shared<grammar::Derivation>(std::move(*derivation)));
  }
  return model;
}

}  // namespace

Result<Model> BuiltOn(std::vector<Lot> lots, grammar::Trees trees) {
  Model model;
  for (const Lot& lot : lots) {
    model.roots.push_back(std::make_shared<const grammar::ShapeTree>(lot.item));
  }
  model.lots = std::move(lots);
  model.trees = std::move(trees);
  return Derived(std::move(model), nullptr);
}

Result<Model> WithTrees(const Model& model, grammar::Trees trees) {
  Model next{model.lots, model.roots, std::move(trees), {}};
  return Derived(std::move(next), &model);
}

std::string IdOf(const Model& model, const ShapeRef& ref) {
  const std::string path = model.derived[ref.lot]->tree.IdOf(ref.shape);
  return model.lots.size() > 1 ? fmt::format("lot-{}:{}", ref.lot, path) : path;
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

const grammar::Shape& ShapeAt(const Model& model, const ShapeRef& ref) {
  return model.derived[ref.lot]->tree[ref.shape];
}

}  // namespace parti::app
