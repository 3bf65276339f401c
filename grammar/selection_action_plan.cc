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

/// A shape that is not in the tree yet.
struct Draft {
  Item item;
  const Operation* operation = nullptr;
  NameId symbol = kNoName;
  std::vector<NameId> tags;
};

class Actor {
 public:
  Actor(uint32_t most, ShapeTree* tree) : most_(most), tree_(*tree) {}

  Result<void> Make(const ActionPlan& plan, ShapeIndex parent) {
    auto products = Apply(*plan.action, tree_[parent].item);
    if (!products) return Fail(products);
    for (Product& product : *products) {
      const AlternativePlan& alternative = plan.AlternativeOf(product);
      Draft draft{std::move(product.item), plan.action->operation, kNoName, {}};
      const auto finished = Finish(alternative, 0, std::move(draft), parent);
      if (!finished) return finished;
    }
    return {};
  }

 private:
  /// Runs the steps from `first` on and appends what they make of the draft.
  Result<void> Finish(const AlternativePlan& plan, size_t first, Draft draft, ShapeIndex parent) {
    if (plan.nil) return {};
    for (size_t i = first; i < plan.steps.size(); ++i) {
      const ActionPlan& step = plan.steps[i];
      if (step.kind == ActionPlan::Kind::kTag) {
        draft.tags.push_back(step.name);
      } else if (step.kind == ActionPlan::Kind::kSymbol) {
        draft.symbol = step.name;
      } else if (step.action->operation->braces != Braces::kNone) {
        const auto shape = Append(plan, std::move(draft), parent);
        return shape ? Make(step, *shape) : Fail(shape);
      } else {
        return FinishEach(plan, i, draft, parent);
      }
    }
    const auto shape = Append(plan, std::move(draft), parent);
    if (!shape) return Fail(shape);
    return {};
  }

  /// Step `i` without braces: what follows it happens to each of its products.
  Result<void> FinishEach(const AlternativePlan& plan, size_t i, const Draft& draft,
                          ShapeIndex parent) {
    const ActionPlan& step = plan.steps[i];
    auto products = Apply(*step.action, draft.item);
    if (!products) return Fail(products);
    for (Product& product : *products) {
      Draft next = draft;
      next.item = std::move(product.item);
      if (step.kind == ActionPlan::Kind::kMake) next.operation = step.action->operation;
      const auto finished = Finish(plan, i + 1, std::move(next), parent);
      if (!finished) return finished;
    }
    return {};
  }

  Result<ShapeIndex> Append(const AlternativePlan& plan, Draft draft, ShapeIndex parent) {
    if (tree_.size() >= most_) {
      return Fail(ErrorCode::kLimitReached, fmt::format("more than {} shapes", most_),
                  "check its sizes, or raise the limit");
    }
    return tree_.Append(parent, std::move(draft.item),
                        plan.symbol == kNoName ? draft.symbol : plan.symbol, draft.operation,
                        std::move(draft.tags));
  }

  uint32_t most_;
  ShapeTree& tree_;
};

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
  if (plan.kind == ActionPlan::Kind::kMake) return Actor(most, tree).Make(plan, shape);
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
