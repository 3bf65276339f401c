#include "grammar/rules/recipe_actions.h"

#include "grammar/asset_library.h"
#include "grammar/rules/rule_argument.h"

namespace parti::grammar {
namespace {

void AddSizes(std::vector<Successor>* list, std::vector<double*>* sizes) {
  for (Successor& one : *list) {
    if (!one.repeat.empty()) {
      AddSizes(&one.repeat, sizes);
    } else {
      Size* size = std::get_if<Size>(&one.key);
      sizes->push_back(size != nullptr ? &size->value : nullptr);
    }
  }
}

}  // namespace

Result<const Action*> RecipeActions::Computed(const StepPlan& step, const Situation& situation,
                                              Evaluator* evaluator) {
  const ActionRecipe& recipe = program_.recipes[step.recipe];
  if (recipe.unfit) return tl::unexpected<Error>(*recipe.unfit);
  if (recipe.constant()) return &recipe.action;
  Kept& kept = kept_[step.recipe];
  if (!kept.is_ready) {
    kept.action = recipe.action;
    AddSizes(&kept.action.successors, &kept.sizes);
    kept.is_ready = true;
  }
  for (const ActionRecipe::Computed& one : recipe.arguments) {
    kept.action.arguments[one.index] = ArgumentFrom(recipe.action.operation->parameters[one.index],
                                                    step.statement->arguments[one.index],
                                                    evaluator->Of(*one.expression, situation));
  }
  for (const ActionRecipe::Computed& one : recipe.sizes) {
    *kept.sizes[one.index] = evaluator->Number(*one.expression, situation);
  }
  if (evaluator->failure()) return tl::unexpected<Error>(*evaluator->failure());
  if (const auto good = Check(kept.action); !good) return Fail(good);
  if (program_.assets != nullptr && WantsAsset(kept.action)) {
    const auto read = ResolveAssets(recipe.folder, program_.assets, &kept.action);
    if (!read) return Fail(read);
  }
  return &kept.action;
}

}  // namespace parti::grammar
