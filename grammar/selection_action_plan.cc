#include "grammar/selection_action_plan.h"

#include <fmt/format.h>

#include "base/check.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kTagName = "tag";
constexpr std::string_view kSymbolName = "symbol";

AlternativePlan AlternativeFrom(const std::vector<Action>& actions, std::string_view symbol,
                                ShapeTree* tree) {
  AlternativePlan plan;
  plan.nil = symbol == kNil;
  if (!plan.nil) plan.symbol = tree->Intern(symbol);
  for (const Action& action : actions) plan.steps.push_back(PlanOf(action, tree));
  return plan;
}

/// Depth first through repeat groups, as Product::successor counts.
void AddAlternatives(const std::vector<Successor>& successors, ShapeTree* tree, ActionPlan* plan) {
  for (const Successor& successor : successors) {
    if (!successor.repeat.empty()) {
      AddAlternatives(successor.repeat, tree, plan);
    } else {
      plan->alternatives.push_back(AlternativeFrom(successor.actions, successor.symbol, tree));
    }
  }
}

/// Runs the successor's operations on a product and appends what comes of it.
Result<void> Append(Item item, const AlternativePlan& plan, const Operation* operation,
                    ShapeIndex parent, ShapeTree* tree) {
  NameId symbol = plan.symbol;
  std::vector<NameId> tags;
  for (const ActionPlan& step : plan.steps) {
    if (step.kind == ActionPlan::Kind::kTag) tags.push_back(step.name);
    if (step.kind == ActionPlan::Kind::kSymbol && symbol == kNoName) symbol = step.name;
    if (step.kind != ActionPlan::Kind::kChange) continue;
    auto changed = Apply(*step.action, item);
    if (!changed) return Fail(changed);
    CHECK(changed->size() == 1, "an operation in place gives the item back");
    item = std::move(changed->front().item);
  }
  tree->Append(parent, std::move(item), symbol, operation, std::move(tags));
  return {};
}

Result<void> Make(const ActionPlan& plan, ShapeIndex parent, uint32_t most, ShapeTree* tree) {
  auto products = Apply(*plan.action, (*tree)[parent].item);
  if (!products) return Fail(products);
  for (Product& product : *products) {
    const AlternativePlan& alternative = plan.AlternativeOf(product);
    if (alternative.nil) continue;
    if (tree->size() >= most) {
      return Fail(ErrorCode::kLimitReached, fmt::format("more than {} shapes", most),
                  "check its sizes, or raise the limit");
    }
    const auto appended =
        Append(std::move(product.item), alternative, plan.action->operation, parent, tree);
    if (!appended) return appended;
  }
  return {};
}

}  // namespace

const AlternativePlan& ActionPlan::AlternativeOf(const Product& product) const {
  const auto number = static_cast<size_t>(product.successor < 0 ? 0 : product.successor);
  CHECK(number < alternatives.size(), "a product belongs to one of the action's successors");
  return alternatives[number];
}

ActionPlan PlanOf(const Action& action, ShapeTree* tree) {
  const Operation& row = *action.operation;
  ActionPlan plan;
  plan.action = &action;
  if (row.name == kTagName || row.name == kSymbolName) {
    plan.kind = row.name == kTagName ? ActionPlan::Kind::kTag : ActionPlan::Kind::kSymbol;
    plan.name = tree->Intern(std::get<std::string>(action.arguments.at(0)));
  } else if (row.in_place) {
    plan.kind = ActionPlan::Kind::kChange;
  }
  if (row.braces == Braces::kNone) {
    plan.alternatives.push_back(AlternativeFrom({}, action.symbol, tree));
  } else {
    AddAlternatives(action.successors, tree, &plan);
  }
  return plan;
}

Result<void> Act(const ActionPlan& plan, ShapeIndex shape, uint32_t most, ShapeTree* tree) {
  if (plan.kind == ActionPlan::Kind::kMake) return Make(plan, shape, most, tree);
  if (plan.kind == ActionPlan::Kind::kTag) tree->AddTag(shape, plan.name);
  if (plan.kind == ActionPlan::Kind::kSymbol) tree->SetSymbol(shape, plan.name);
  if (plan.kind == ActionPlan::Kind::kChange) {
    auto products = Apply(*plan.action, (*tree)[shape].item);
    if (!products) return Fail(products);
    CHECK(products->size() == 1, "an operation in place gives the item back");
    tree->SetItem(shape, std::move(products->front().item));
  }
  const NameId symbol = plan.alternatives.front().symbol;
  if (symbol != kNoName) tree->SetSymbol(shape, symbol);
  return {};
}

}  // namespace parti::grammar
