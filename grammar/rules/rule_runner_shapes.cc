// What a body makes: children in the tree, and tasks for what they wait for.
#include <fmt/format.h>

#include <utility>

#include "base/check.h"
#include "grammar/rules/rule_runner.h"

namespace parti::grammar {
namespace {

using Kind = Statement::Kind;

/// Where a rule begins, nothing has moved yet (CGA's previous shape).
Item WithoutAnchor(const Item& item) {
  Item placed = item;
  placed.anchor.reset();
  return placed;
}

/// Whether a shape can itself become what steps [from, to) make of it.
bool AreSimple(const BodyPlan& body, size_t from, size_t to) {
  for (size_t i = from; i < to; ++i) {
    const Statement& statement = *body.steps[i].statement;
    const bool changes = statement.kind == Kind::kOperation && OnlyChanges(*statement.operation);
    const bool ends = statement.kind == Kind::kSymbol && i + 1 == to;
    if (!changes && !ends && statement.kind != Kind::kSet) return false;
  }
  return true;
}

}  // namespace

/// Products of an operation with braces become children, each what its successor says.
Result<void> RuleRunner::Divide(const StepPlan& step, std::vector<Product> products, BodyRun* run) {
  const Operation& row = *step.statement->operation;
  const auto total = static_cast<uint32_t>(products.size());
  const bool is_comp = row.braces == Braces::kSelectors;
  const bool is_scene = MakesScene(row, run->hand.item().type);
  left_->has_scene = left_->has_scene || is_scene;
  run->has_cut = run->has_cut || !is_scene;
  for (uint32_t i = 0; i < total; ++i) {
    const auto number = static_cast<size_t>(products[i].successor);
    CHECK(number < step.successors.size(), "a product belongs to one of the successors");
    Inheritance inherited = run->hand.inherited;
    (is_comp ? inherited.comp : inherited.split) = {i, total};
    const auto done =
        Fill(step.successors[number], row, std::move(products[i].item), std::move(inherited), run);
    if (!done) return done;
  }
  return {};
}

/// A successor's body on its product. What is more than a change and a symbol gets a shape of its
/// own, whose children are what the body makes.
Result<void> RuleRunner::Fill(const BodyPlan& body, const Operation& row, Item&& product,
                              Inheritance inherited, BodyRun* run) {
  Stream stream = run->stream->Next();
  BodyRun inner;
  inner.body = &body;
  inner.to = SIZE_MAX;
  inner.shape = run->shape;
  inner.parameters = run->parameters;
  inner.stream = &stream;
  inner.level = run->level;
  inner.hand.Become(std::move(product));
  inner.hand.is_made = true;
  inner.hand.made_by = &row;
  inner.hand.inherited = std::move(inherited);
  const auto chosen = Choose(inner);
  if (!chosen) return Fail(chosen);
  if (*chosen == nullptr || (*chosen)->is_nil) return {};
  inner.body = *chosen;
  const bool has_own = !inner.body->is_simple;
  inner.is_successor = !has_own;
  if (has_own) {
    const auto placed = Place(kNoName, body.body->range, &inner);
    if (!placed) return Fail(placed);
    inner.shape = *placed;
    inner.made = 0;
    inner.hand.whole = &(*tree_)[*placed].item;
    inner.hand.is_changed = inner.hand.is_made = false;
  }
  const auto done = RunBody(&inner, 0);
  if (done) run->made += has_own ? 1 : inner.made;
  return done;
}

Result<SharedValues> RuleRunner::ArgumentsOf(const StepPlan& step, BodyRun* run) {
  const Statement& statement = *step.statement;
  if (statement.arguments.empty()) return SharedValues();
  const Situation situation = SituationOf(*run);
  auto values = std::make_shared<std::vector<Value>>();
  for (const RuleArgument& argument : statement.arguments) {
    values->push_back(evaluator_.Of(argument.value, situation));
  }
  if (evaluator_.failure()) return Failed(*evaluator_.failure(), *run, statement.range);
  return SharedValues(std::move(values));
}

/// A child from what is in the hand, or, where a place waits to be taken, in that place.
Result<ShapeIndex> RuleRunner::Place(NameId symbol, const TextRange& range, BodyRun* run) {
  ++run->made;
  const InHand& hand = run->hand;
  if (run->taken != kNoShape) {
    const ShapeIndex taken = std::exchange(run->taken, kNoShape);
    run->hand.changed.anchor.reset();
    if (hand.is_changed) tree_->SetItem(taken, hand.changed);
    tree_->SetMade(taken, symbol, hand.made_by);
    for (const NameId tag : hand.tags) tree_->AddTag(taken, tag);
    return taken;
  }
  if (tree_->size() >= lot_.limits.shapes) {
    return Failed({ErrorCode::kLimitReached, fmt::format("more than {} shapes", lot_.limits.shapes),
                   "check its sizes, or allow more --shapes", std::nullopt},
                  *run, range);
  }
  return tree_->Append(run->shape, WithoutAnchor(hand.item()), symbol, hand.made_by, hand.tags);
}

Result<void> RuleRunner::Emit(const StepPlan& step, BodyRun* run) {
  const Statement& statement = *step.statement;
  Stream stream = run->stream->Next();
  const auto placed = Place(step.symbol, statement.range, run);
  if (!placed) return Fail(placed);
  left_->has_scene = left_->has_scene || IsOfScene(run->hand.item().type);
  if (statement.index == kNoRule) return {};
  if (run->level >= lot_.limits.depth) return Failed(TooDeep(step, *run), *run, statement.range);
  auto arguments = ArgumentsOf(step, run);
  if (!arguments) return Fail(arguments);
  RuleTask task;
  task.shape = *placed;
  task.body = &lot_.program.bodies[statement.index];
  task.parameters = std::move(*arguments);
  task.inherited = run->hand.inherited;
  task.stream = stream;
  task.level = run->level + 1;
  Leave(std::move(task), statement.deferred);
  return {};
}

void RuleRunner::Leave(RuleTask task, bool deferred) {
  const bool is_flat = IsOfScene((*tree_)[task.shape].item.type);
  auto& list = !is_flat ? left_->next : deferred ? left_->deferred : left_->flat;
  list.push_back(std::move(task));
}

/// What is in the hand gets a shape of its own, on which steps [at, to) run: a scene needs the
/// shape that it belongs to, and clips to.
Result<void> RuleRunner::GoOnBelow(size_t at, size_t to, BodyRun* run) {
  RuleTask task = Rest(at, to, *run);
  task.stream = run->stream->Next();
  const auto placed = Place(run->hand.symbol, run->body->body->range, run);
  if (!placed) return Fail(placed);
  task.shape = *placed;
  left_->has_scene = left_->has_scene || IsOfScene(run->hand.item().type);
  run->hand.is_gone = true;
  Leave(std::move(task), false);
  return {};
}

/// Steps [at, to) as a task, still without its shape and stream.
RuleTask RuleRunner::Rest(size_t at, size_t to, const BodyRun& run) const {
  RuleTask task;
  task.body = run.body;
  task.parameters = run.parameters;
  task.inherited = run.hand.inherited;
  task.from = static_cast<uint32_t>(at);
  task.to = static_cast<uint32_t>(to);
  task.level = run.level;
  return task;
}

/// Steps [at, to) run when the normalisation has made a planar shape of what is in the hand.
Result<void> RuleRunner::Wait(size_t at, size_t to, BodyRun* run) {
  RuleTask task = Rest(at, to, *run);
  if (run->hand.is_made) {
    task.stream = run->stream->Next();
    task.becomes = AreSimple(*run->body, at, to);
    const bool has_symbol =
        task.becomes && run->body->steps[to - 1].statement->kind == Kind::kSymbol;
    const auto placed =
        Place(has_symbol ? run->body->steps[to - 1].symbol : kNoName, run->body->body->range, run);
    if (!placed) return Fail(placed);
    task.shape = *placed;
  } else {
    task.stream = *run->stream;
    task.shape = run->shape;
    if (run->hand.is_changed) tree_->SetItem(run->shape, run->hand.changed);
    ++run->made;
  }
  run->hand.is_gone = true;
  left_->has_scene = true;
  const bool is_layer = (*tree_)[task.shape].item.type == ItemType::kLayer;
  (is_layer ? left_->deferred : left_->waiting).push_back(std::move(task));
  return {};
}

/// Whether something in the brackets that step `push` opens must wait for the normalisation: then
/// all of them does, as the shape at hand will be another one.
bool RuleRunner::WaitsInside(const BodyRun& run, size_t push) const {
  const ItemType type = run.hand.item().type;
  if (run.hand.is_gone || !IsOfScene(type)) return false;
  for (size_t i = push; i < run.body->steps[push].closing; ++i) {
    const Statement& statement = *run.body->steps[i].statement;
    if (statement.kind == Kind::kOperation && MustWait(*statement.operation, type)) return true;
  }
  return false;
}

Error RuleRunner::TooDeep(const StepPlan& step, const BodyRun& run) const {
  uint32_t same = 0;
  for (ShapeIndex i = run.shape; i != kNoShape; i = tree_->node(i).parent) {
    same += (*tree_)[i].symbol == step.symbol ? 1 : 0;
  }
  const std::string_view symbol = tree_->Name(step.symbol);
  const std::string how =
      same > 0 ? fmt::format("{} comes of itself without end", symbol) : "the rules go on";
  return {ErrorCode::kLimitReached,
          fmt::format("{}: more than {} levels of rules", how, lot_.limits.depth),
          "end it with a case, or allow more --depth", std::nullopt};
}

}  // namespace parti::grammar
