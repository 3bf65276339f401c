#include "grammar/rules/rule_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace parti::grammar {
namespace {

using Kind = Statement::Kind;

/// Tasks between two looks at the clock.
constexpr uint32_t kTasksPerLook = 64;

constexpr std::string_view kTagName = "tag";
constexpr std::string_view kSymbolName = "symbol";
constexpr std::string_view kPrintName = "print";

bool IsName(const Operation& row) { return row.name == kTagName || row.name == kSymbolName; }

/// Of ParameterKind::kValue.
Value ValueOf(const Argument& argument) {
  if (const double* number = std::get_if<double>(&argument)) return *number;
  if (const bool* yes = std::get_if<bool>(&argument)) return *yes;
  return std::get<std::string>(argument);
}

Error WrongType(const Operation& row, ItemType type) {
  return {ErrorCode::kWrongItemType,
          fmt::format("{} can't be applied to a {}", row.name, NameOf(type)),
          type == ItemType::kVolume ? "take its faces with comp(f) first" : "", std::nullopt};
}

/// Where the pair of brackets that step `at` stands in is closed, or `to`.
size_t EndOfBrackets(const BodyPlan& body, size_t at, size_t to) {
  for (size_t i = at; i < to; ++i) {
    if (body.steps[i].statement->kind == Kind::kPop) return i;
    if (body.steps[i].statement->kind == Kind::kPush) i = body.steps[i].closing;
  }
  return to;
}

}  // namespace

Error RuleRunner::Named(Error error, uint32_t rule, ShapeIndex shape,
                        const TextRange& range) const {
  const RuleSet& rules = *lot_.program.rules;
  std::string id = tree_->IdOf(shape);
  if (!lot_.above.empty()) id = id == "." ? lot_.above : fmt::format("{}/{}", lot_.above, id);
  error.message =
      fmt::format("rule {}: {} (shape {})", rules.rules[rule].symbol, error.message, id);
  error.place = PlaceOf(rules, range);
  return error;
}

tl::unexpected<Error> RuleRunner::Failed(Error error, const BodyRun& run,
                                         const TextRange& range) const {
  return tl::unexpected<Error>(Named(std::move(error), run.body->rule, run.shape, range));
}

Situation RuleRunner::SituationOf(const BodyRun& run) const {
  Situation situation;
  situation.item = &run.hand.item();
  situation.lot = &lot_.lot;
  situation.split = run.hand.inherited.split;
  situation.comp = run.hand.inherited.comp;
  const SharedValues& own = run.hand.inherited.attributes;
  situation.attributes = own ? *own : lot_.attributes;
  if (run.parameters) situation.parameters = *run.parameters;
  situation.random = &run.stream->random;
  situation.seed = lot_.seed;
  return situation;
}

Result<void> RuleRunner::CheckTime(const RuleTask& task) {
  if (until_look_-- != 0) return {};
  until_look_ = kTasksPerLook;
  const bool is_cancelled =
      lot_.cancelled != nullptr && lot_.cancelled->load(std::memory_order_relaxed);
  if (is_cancelled) return Fail(ErrorCode::kLimitReached, "the derivation was cancelled");
  const bool has_limit = lot_.limits.seconds > 0 && lot_.now_s != nullptr;
  if (!has_limit || lot_.now_s() < lot_.until_s) return {};
  Error error{ErrorCode::kLimitReached,
              fmt::format("deriving took more than {} s", lot_.limits.seconds),
              "simplify, or give more --seconds", std::nullopt};
  return tl::unexpected<Error>(
      Named(std::move(error), task.body->rule, task.shape, task.body->body->range));
}

Result<void> RuleRunner::Run(RuleTask task, LeftTasks* left) {
  if (const auto in_time = CheckTime(task); !in_time) return in_time;
  left_ = left;
  const Shape& shape = (*tree_)[task.shape];
  BodyRun run;
  run.body = task.body;
  run.to = task.to;
  run.shape = task.becomes ? tree_->node(task.shape).parent : task.shape;
  run.taken = task.becomes ? task.shape : kNoShape;
  run.parameters = std::move(task.parameters);
  run.stream = &task.stream;
  run.level = task.level;
  run.hand.whole = &shape.item;
  run.hand.made_by = shape.operation;
  run.hand.is_made = task.becomes;
  run.hand.inherited = std::move(task.inherited);
  return RunBody(&run, task.from);
}

/// Null where no alternative's condition holds and none is left over.
Result<const BodyPlan*> RuleRunner::Choose(const BodyRun& run) {
  const BodyPlan* chosen = run.body;
  while (chosen != nullptr && chosen->body->kind != Body::Kind::kSequence) {
    const bool is_chance = chosen->body->kind == Body::Kind::kChance;
    const Situation situation = SituationOf(run);
    double left = is_chance ? 100 * run.stream->random.Uniform() : 0;
    const BodyPlan* next = nullptr;
    for (size_t i = 0; i < chosen->alternatives.size() && next == nullptr; ++i) {
      const auto& condition = chosen->body->alternatives[i].condition;
      bool fits = !condition;
      if (condition && is_chance) fits = (left -= evaluator_.Number(*condition, situation)) < 0;
      if (condition && !is_chance) fits = evaluator_.Truth(*condition, situation);
      if (fits) next = &chosen->alternatives[i];
    }
    if (evaluator_.failure()) return Failed(*evaluator_.failure(), run, chosen->body->range);
    chosen = next;
  }
  return chosen;
}

Result<void> RuleRunner::RunBody(BodyRun* run, size_t from) {
  const auto chosen = Choose(*run);
  if (!chosen) return Fail(chosen);
  if (*chosen != nullptr) {
    run->body = *chosen;
    const ItemType type = run->hand.item().type;
    const StepPlan* unfit = from == 0 ? run->body->unfit[TypeNumber(type)] : nullptr;
    if (unfit != nullptr) {
      return Failed(WrongType(*unfit->statement->operation, type), *run, unfit->statement->range);
    }
    run->to = std::min(run->to, run->body->steps.size());
    if (const auto done = RunSteps(run, from, run->to); !done) return done;
  }
  return Finish(run);
}

/// Steps [from, to), which open and close their brackets.
Result<void> RuleRunner::RunSteps(BodyRun* run, size_t from, size_t to) {
  for (size_t i = from; i < to; ++i) {
    const StepPlan& step = run->body->steps[i];
    const Statement& statement = *step.statement;
    if (!evaluator_.Step()) return Failed(*evaluator_.failure(), *run, statement.range);
    if (statement.kind == Kind::kPop) {
      run->hand = std::move(run->saved.back());
      run->saved.pop_back();
      continue;
    }
    if (statement.kind == Kind::kPush) {
      if (WaitsInside(*run, i)) return Wait(i, to, run);
      run->saved.push_back(run->hand);
      continue;
    }
    if (run->hand.is_gone) continue;
    if (statement.kind != Kind::kOperation) {
      if (const auto done = RunStep(step, run); !done) return done;
      continue;
    }
    const Operation& row = *statement.operation;
    const size_t end = EndOfBrackets(*run->body, i, to);
    if (MustWait(row, run->hand.item().type)) {
      if (const auto done = Wait(i, end, run); !done) return done;
      i = end - 1;
      continue;
    }
    if (run->hand.is_made && MakesScene(row, run->hand.item().type)) {
      if (const auto done = GoOnBelow(i, end, run); !done) return done;
      i = end - 1;
      continue;
    }
    auto products = Applied(step, run);
    if (!products) return Fail(products);
    if (row.braces != Braces::kNone) {
      if (const auto done = Divide(step, std::move(*products), run); !done) return done;
    } else if (products->size() > 1) {
      if (const auto done = RunEach(std::move(*products), i + 1, end, run); !done) return done;
      i = end - 1;
    } else if (products->empty()) {
      run->hand.is_gone = true;
    } else {
      run->hand.Become(std::move(products->front().item));
    }
  }
  return {};
}

/// A step that is no operation, and opens and closes nothing.
Result<void> RuleRunner::RunStep(const StepPlan& step, BodyRun* run) {
  if (step.statement->kind == Kind::kSet) return Set(step, run);
  if (!step.is_nil) return Emit(step, run);
  run->hand.is_gone = true;
  return {};
}

/// Each of several results of one operation goes through steps [from, to) by itself.
Result<void> RuleRunner::RunEach(std::vector<Product> results, size_t from, size_t to,
                                 BodyRun* run) {
  const InHand before = run->hand;
  for (Product& result : results) {
    run->hand = before;
    run->hand.Become(std::move(result.item));
    const uint32_t made = run->made;
    if (const auto done = RunSteps(run, from, to); !done) return done;
    const bool is_left = to == run->to && run->made == made && !run->hand.is_gone;
    if (!is_left) continue;
    const auto placed = Place(run->hand.symbol, run->body->body->range, run);
    if (!placed) return Fail(placed);
  }
  run->hand.is_gone = true;
  return {};
}

/// What is left in the hand at the end, where the body has made nothing of it, is the shape itself,
/// or a child without symbol.
Result<void> RuleRunner::Finish(BodyRun* run) {
  if (run->made > 0) return {};
  const bool is_nothing = run->hand.is_gone || run->has_cut;
  const ShapeIndex self = run->taken != kNoShape ? run->taken : run->shape;
  if (is_nothing) {
    if (!run->is_successor) tree_->Hide(self);
  } else if (run->hand.is_made) {
    const auto placed = Place(run->hand.symbol, run->body->body->range, run);
    if (!placed) return Fail(placed);
  } else if (run->hand.is_changed) {
    tree_->SetItem(run->shape, std::move(run->hand.changed));
  }
  return {};
}

/// What an operation makes of the hand; rows in place that only name are done here.
Result<std::vector<Product>> RuleRunner::Applied(const StepPlan& step, BodyRun* run) {
  const Operation& row = *step.statement->operation;
  const Item& item = run->hand.item();
  if ((row.takes & Types(item.type)) == 0) {
    return Failed(WrongType(row, item.type), *run, step.statement->range);
  }
  const auto action = actions_.Computed(step, SituationOf(*run), &evaluator_);
  if (!action) return Failed(action.error(), *run, step.statement->range);
  if (row.notes || IsName(row)) {
    const auto noted = row.notes ? Note(**action, *step.statement, *run) : Result<void>();
    if (!noted) return Fail(noted);
    if (!row.notes) Name(**action, run);
    std::vector<Product> same(1);
    same.front().item = item;
    return same;
  }
  auto products = row.apply(item, **action);
  if (!products) {
    Error error = products.error();
    if (error.message.find(row.name) == std::string::npos) {
      error.message = fmt::format("{}: {}", row.name, error.message);
    }
    return Failed(std::move(error), *run, step.statement->range);
  }
  if (!row.in_place) {
    run->hand.made_by = &row;
    run->hand.is_made = run->hand.is_made || row.braces == Braces::kNone;
  }
  return products;
}

/// tag and symbol: of the shape itself, or of what is made of it.
void RuleRunner::Name(const Action& action, BodyRun* run) {
  const NameId name = tree_->Intern(std::get<std::string>(action.arguments.at(0)));
  const bool is_tag = action.operation->name == kTagName;
  if (run->hand.is_made) {
    if (is_tag) run->hand.tags.push_back(name);
    if (!is_tag) run->hand.symbol = name;
  } else if (is_tag) {
    tree_->AddTag(run->shape, name);
  } else {
    tree_->SetSymbol(run->shape, name);
  }
}

/// report and print, where somebody wants to know.
Result<void> RuleRunner::Note(const Action& action, const Statement& statement,
                              const BodyRun& run) {
  if (notes_ == nullptr) return {};
  if (action.operation->name == kPrintName) {
    notes_->Print(statement.range, ValueOf(action.arguments[0]));
    return {};
  }
  if (notes_->Report(std::get<std::string>(action.arguments[0]), ValueOf(action.arguments[1]))) {
    return {};
  }
  return Failed(
      {ErrorCode::kLimitReached, fmt::format("more than {} reports", kMostReports),
       "report what parts have in common once, of the shape that they are parts of", std::nullopt},
      run, statement.range);
}

Result<void> RuleRunner::Set(const StepPlan& step, BodyRun* run) {
  const Statement& statement = *step.statement;
  Inheritance& inherited = run->hand.inherited;
  auto values = std::make_shared<std::vector<Value>>(inherited.attributes ? *inherited.attributes
                                                                          : lot_.attributes);
  (*values)[statement.index] = evaluator_.Of(statement.arguments.front().value, SituationOf(*run));
  if (evaluator_.failure()) return Failed(*evaluator_.failure(), *run, statement.range);
  inherited.attributes = std::move(values);
  return {};
}

}  // namespace parti::grammar
