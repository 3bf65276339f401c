#include "grammar/rules/rule_program.h"

#include <utility>

#include "base/check.h"
#include "grammar/asset_library.h"
#include "grammar/rules/conversions.h"
#include "grammar/rules/rule_argument.h"

namespace parti::grammar {
namespace {

using Kind = Statement::Kind;

bool IsConstant(const Expression& expression) {
  return expression.kind == Expression::Kind::kConstant;
}

class Maker {
 public:
  explicit Maker(RuleProgram* program) : program_(program) {}

  BodyPlan PlanOf(const Body& body, uint32_t rule);

 private:
  StepPlan StepOf(const Statement& statement, uint32_t rule);
  void AddSuccessors(const std::vector<SuccessorRule>& list, uint32_t rule, StepPlan* step,
                     ActionRecipe* recipe, std::vector<Successor>* made);
  uint32_t RecipeOf(const Statement& statement, uint32_t rule, StepPlan* step);

  RuleProgram* program_;
};

bool OnlyNil(const Body& body) {
  return body.kind == Body::Kind::kSequence && body.statements.size() == 1 &&
         body.statements[0].kind == Kind::kSymbol && body.statements[0].symbol == kNil;
}

bool IsSimple(const Body& body) {
  if (body.kind != Body::Kind::kSequence) return false;
  for (size_t i = 0; i < body.statements.size(); ++i) {
    const Statement& statement = body.statements[i];
    const bool is_last = i + 1 == body.statements.size();
    const bool changes = statement.kind == Kind::kOperation && OnlyChanges(*statement.operation);
    if (!changes && statement.kind != Kind::kSet && !(statement.kind == Kind::kSymbol && is_last)) {
      return false;
    }
  }
  return true;
}

/// Which step closes each that opens; the checker has seen that all are closed.
void Match(std::vector<StepPlan>* steps) {
  std::vector<size_t> open;
  for (size_t i = 0; i < steps->size(); ++i) {
    const Kind kind = (*steps)[i].statement->kind;
    if (kind == Kind::kPush) open.push_back(i);
    if (kind != Kind::kPop || open.empty()) continue;
    (*steps)[open.back()].closing = static_cast<uint32_t>(i);
    open.pop_back();
  }
  for (const size_t i : open) (*steps)[i].closing = static_cast<uint32_t>(steps->size());
}

/// The types of what comes to each step of a sequence, from the first.
class TypeWalk {
 public:
  explicit TypeWalk(ItemType type) : type_(type) {}

  /// Null where the step can take what comes to it.
  const StepPlan* UnfitAt(const StepPlan& step) {
    const Kind kind = step.statement->kind;
    if (kind == Kind::kPush) saved_.push_back(type_);
    if (kind == Kind::kPop && !saved_.empty()) {
      type_ = saved_.back();
      saved_.pop_back();
    }
    if (kind != Kind::kOperation) return nullptr;
    const Operation& row = *step.statement->operation;
    if (MustWait(row, type_)) type_ = ItemType::kPlanar;
    const auto out = OutType(row, type_);
    if (!out) return &step;
    for (const BodyPlan& body : step.successors) {
      if (const StepPlan* unfit = body.unfit[TypeNumber(*out)]) return unfit;
    }
    if (row.braces == Braces::kNone) type_ = *out;
    return nullptr;
  }

 private:
  ItemType type_;
  std::vector<ItemType> saved_;
};

void FindUnfit(BodyPlan* plan) {
  for (const ItemType type : {ItemType::kVolume, ItemType::kPlanar, ItemType::kShape2D,
                              ItemType::kLayer, ItemType::kEdge, ItemType::kPoint}) {
    TypeWalk walk(type);
    for (const StepPlan& step : plan->steps) {
      plan->unfit[TypeNumber(type)] = walk.UnfitAt(step);
      if (plan->unfit[TypeNumber(type)] != nullptr) break;
    }
  }
}

BodyPlan Maker::PlanOf(const Body& body, uint32_t rule) {
  BodyPlan plan;
  plan.body = &body;
  plan.rule = rule;
  plan.is_nil = OnlyNil(body);
  plan.is_simple = IsSimple(body);
  for (const Statement& statement : body.statements) plan.steps.push_back(StepOf(statement, rule));
  for (const Body::Alternative& one : body.alternatives) {
    plan.alternatives.push_back(PlanOf(*one.body, rule));
  }
  Match(&plan.steps);
  FindUnfit(&plan);
  return plan;
}

StepPlan Maker::StepOf(const Statement& statement, uint32_t rule) {
  StepPlan step;
  step.statement = &statement;
  if (statement.kind == Kind::kOperation) step.recipe = RecipeOf(statement, rule, &step);
  if (statement.kind != Kind::kSymbol) return step;
  step.is_nil = statement.symbol == kNil;
  if (!step.is_nil) step.symbol = program_->names.Intern(statement.symbol);
  return step;
}

/// Depth first through repeat groups, as Product::successor counts.
void Maker::AddSuccessors(const std::vector<SuccessorRule>& list, uint32_t rule, StepPlan* step,
                          ActionRecipe* recipe, std::vector<Successor>* made) {
  for (const SuccessorRule& one : list) {
    Successor& successor = made->emplace_back();
    if (!one.repeat.empty()) {
      AddSuccessors(one.repeat, rule, step, recipe, &successor.repeat);
      continue;
    }
    successor.key = one.key;
    if (one.size && IsConstant(*one.size)) {
      std::get<Size>(successor.key).value = NumberOf(one.size->constant);
    } else if (one.size) {
      recipe->sizes.push_back({static_cast<uint32_t>(step->successors.size()), &*one.size});
    }
    step->successors.push_back(PlanOf(one.body, rule));
    if (step->successors.back().is_nil) successor.symbol = kNil;
  }
}

uint32_t Maker::RecipeOf(const Statement& statement, uint32_t rule, StepPlan* step) {
  const Operation& row = *statement.operation;
  ActionRecipe recipe;
  recipe.action = Default(row);
  if (row.file >= 0 && statement.range.file < program_->rules->files.size()) {
    recipe.folder = FolderOf(program_->rules->files[statement.range.file].name);
  }
  CHECK(statement.arguments.size() <= row.parameters.size(), "the checker counted arguments");
  for (size_t i = 0; i < statement.arguments.size(); ++i) {
    const RuleArgument& argument = statement.arguments[i];
    if (IsConstant(argument.value)) {
      recipe.action.arguments[i] =
          ArgumentFrom(row.parameters[i], argument, argument.value.constant);
    } else {
      recipe.arguments.push_back({static_cast<uint32_t>(i), &argument.value});
    }
  }
  AddSuccessors(statement.successors, rule, step, &recipe, &recipe.action.successors);
  if (recipe.constant()) {
    if (const auto good = Check(recipe.action); !good) recipe.unfit = good.error();
  }
  program_->recipes.push_back(std::move(recipe));
  return static_cast<uint32_t>(program_->recipes.size() - 1);
}

}  // namespace

bool MustWait(const Operation& row, ItemType type) {
  return IsOfScene(type) && (row.takes & Types(type)) == 0 &&
         (row.takes & Types(ItemType::kPlanar)) != 0;
}

bool MakesScene(const Operation& row, ItemType type) {
  const auto out = OutType(row, type);
  return out && IsOfScene(*out) && !row.in_place;
}

bool OnlyChanges(const Operation& row) {
  constexpr ItemTypes kVisible = Types(ItemType::kVolume, ItemType::kPlanar);
  return row.braces == Braces::kNone && (row.in_place || (row.gives & kVisible) != 0);
}

RuleProgram ProgramOf(const RuleSet& rules, const std::string& start, AssetLibrary* assets) {
  RuleProgram program{&rules, {}, {}, RuleFor(rules, start), ShapeTree(Item(), start), assets};
  Maker maker(&program);
  for (uint32_t i = 0; i < rules.rules.size(); ++i) {
    program.bodies.push_back(maker.PlanOf(rules.rules[i].body, i));
  }
  for (ActionRecipe& recipe : program.recipes) {
    if (assets == nullptr || !recipe.constant() || recipe.unfit) continue;
    const auto read = ResolveAssets(recipe.folder, assets, &recipe.action);
    if (!read) recipe.unfit = read.error();
  }
  return program;
}

}  // namespace parti::grammar
