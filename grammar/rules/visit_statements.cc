#include "grammar/rules/visit_statements.h"

namespace parti::grammar {
namespace {

using Visit = std::function<void(const Statement&)>;

void VisitSuccessor(const SuccessorRule& successor, const Visit& visit) {
  VisitStatements(successor.body, visit);
  for (const SuccessorRule& one : successor.repeat) VisitSuccessor(one, visit);
}

}  // namespace

void VisitStatements(const Body& body, const Visit& visit) {
  for (const Statement& statement : body.statements) {
    visit(statement);
    for (const SuccessorRule& one : statement.successors) VisitSuccessor(one, visit);
  }
  for (const Body::Alternative& one : body.alternatives) VisitStatements(*one.body, visit);
}

}  // namespace parti::grammar
