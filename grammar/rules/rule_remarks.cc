#include "grammar/rules/rule_remarks.h"

#include <fmt/format.h>

#include <utility>

#include "grammar/operation.h"

namespace parti::grammar {
namespace {

using Kind = Statement::Kind;

bool IsNil(const Statement& statement) {
  return statement.kind == Kind::kSymbol && statement.symbol == kNil;
}

/// Leaves children, or cuts the shape up: what came before is in them.
bool Keeps(const Statement& statement) {
  if (statement.kind == Kind::kSymbol) return !IsNil(statement);
  return statement.kind == Kind::kOperation && statement.operation->braces != Braces::kNone;
}

/// Changes the shape in hand, and nothing else.
bool OnlyChangesHand(const Statement& statement) {
  if (statement.kind != Kind::kOperation || Keeps(statement)) return false;
  const Operation& row = *statement.operation;
  return !row.notes && row.name != "tag" && row.name != "symbol";
}

/// Goes through one sequence, with what no statement has kept yet.
class SequenceWalk {
 public:
  /// The first of each row of operations that nothing keeps.
  std::vector<const Statement*> Lost(const Body& body) {
    for (const Statement& statement : body.statements) Take(statement);
    const Open end = open_.back();
    if (has_made_ && end.pending != nullptr) lost_.push_back(end.pending);
    return std::move(lost_);
  }

 private:
  /// A pair of brackets, or the sequence itself.
  struct Open {
    const Statement* pending = nullptr;  ///< the first since something was kept
    bool is_gone = false;                ///< after NIL
  };

  void Take(const Statement& statement) {
    if (statement.kind == Kind::kPush) return open_.push_back({nullptr, open_.back().is_gone});
    if (statement.kind == Kind::kPop) return Close();
    Open& here = open_.back();
    if (here.is_gone) return;
    if (IsNil(statement)) here = {nullptr, true};
    if (Keeps(statement)) {
      has_made_ = true;
      for (Open& one : open_) one.pending = nullptr;
    }
    if (OnlyChangesHand(statement) && here.pending == nullptr) here.pending = &statement;
  }

  void Close() {
    if (open_.size() == 1) return;  // the checker has seen that all are opened
    if (open_.back().pending != nullptr) lost_.push_back(open_.back().pending);
    open_.pop_back();
  }

  std::vector<Open> open_ = {Open()};
  bool has_made_ = false;
  std::vector<const Statement*> lost_;
};

class Remarks {
 public:
  explicit Remarks(const RuleSet& rules) : rules_(rules) {}

  void Visit(const Body& body) {
    for (const Body::Alternative& one : body.alternatives) Visit(*one.body);
    for (const Statement* lost : SequenceWalk().Lost(body)) Tell(*lost);
    for (const Statement& statement : body.statements) {
      for (const SuccessorRule& one : statement.successors) Visit(one);
    }
  }

  std::vector<Error> Take() { return std::move(remarks_); }

 private:
  void Visit(const SuccessorRule& successor) {
    Visit(successor.body);
    for (const SuccessorRule& one : successor.repeat) Visit(one);
  }

  void Tell(const Statement& lost) {
    if (remarks_.size() >= kMostRemarks) return;
    const std::string_view name = lost.operation->name;
    remarks_.push_back(
        {ErrorCode::kNothingMade, fmt::format("{} acts on a shape that nothing keeps", name),
         "put it before what it is meant for, or a symbol behind it", PlaceOf(rules_, lost.range)});
  }

  const RuleSet& rules_;
  std::vector<Error> remarks_;
};

}  // namespace

std::vector<Error> RemarksOn(const RuleSet& rules) {
  Remarks remarks(rules);
  for (const Rule& rule : rules.rules) remarks.Visit(rule.body);
  return remarks.Take();
}

}  // namespace parti::grammar
