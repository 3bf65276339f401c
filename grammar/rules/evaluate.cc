#include "grammar/rules/evaluate.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "grammar/rules/built_ins.h"

namespace parti::grammar {
namespace {

using Kind = Expression::Kind;

/// Counts how deep evaluations are nested.
class Deeper {
 public:
  explicit Deeper(int* depth) : depth_(depth) { ++*depth_; }
  ~Deeper() { --*depth_; }
  Deeper(const Deeper&) = delete;
  Deeper& operator=(const Deeper&) = delete;

 private:
  int* depth_;
};

bool Ordered(std::string_view symbol, double a, double b) {
  if (symbol == "<") return a < b;
  if (symbol == "<=") return a <= b;
  if (symbol == ">") return a > b;
  return a >= b;
}

bool IsText(const Expression& expression) { return expression.type == ValueType::kText; }

}  // namespace

void Evaluator::Fail(std::string message, std::string hint) {
  if (failure_) return;
  failure_ = Error{ErrorCode::kLimitReached, std::move(message), std::move(hint), std::nullopt};
}

bool Evaluator::Step() {
  if (failure_) return false;
  value_steps_ = depth_ == 0 ? 0 : value_steps_ + 1;
  if (value_steps_ > kMostStepsOfAValue) {
    Fail(fmt::format("one value takes more than {} steps of computing", kMostStepsOfAValue),
         "simplify the functions that it calls");
    return false;
  }
  if (most_steps_ == 0 || ++steps_ <= most_steps_) return true;
  Fail(fmt::format("more than {} steps of computing", most_steps_), "simplify, or raise the limit");
  return false;
}

double Evaluator::Number(const Expression& expression, const Situation& situation) {
  if (expression.kind == Kind::kConstant) return NumberOf(expression.constant);
  if (expression.kind == Kind::kOperator && expression.type == ValueType::kNumber) {
    return OperatedNumber(expression, situation);
  }
  return NumberOf(Of(expression, situation));
}

bool Evaluator::Truth(const Expression& expression, const Situation& situation) {
  if (expression.kind == Kind::kOperator && expression.type == ValueType::kBool) {
    return OperatedTruth(expression, situation);
  }
  return TruthOf(Of(expression, situation));
}

Value Evaluator::Of(const Expression& expression, const Situation& situation) {
  if (!Step()) return 0.0;
  const Deeper deeper(&depth_);
  if (depth_ > kDeepestEvaluation) {
    Fail("functions call each other without end", "give them a case that ends");
    return 0.0;
  }
  Value value = Computed(expression, situation);
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr || text->size() <= kLongestText) return value;
  Fail(fmt::format("a text is longer than {} bytes", kLongestText),
       "join or replace less, or shorten it with substring()");
  return 0.0;
}

Value Evaluator::Computed(const Expression& expression, const Situation& situation) {
  switch (expression.kind) {
    case Kind::kConstant:
      return expression.constant;
    case Kind::kAttribute:
      return situation.attributes[expression.index];
    case Kind::kParameter:
      return situation.parameters[expression.index];
    case Kind::kCall:
    case Kind::kBuiltIn:
      return Called(expression, situation);
    case Kind::kOperator:
      return Operated(expression, situation);
    case Kind::kCase:
    case Kind::kChance: {
      const Expression* chosen = Chosen(expression, situation);
      return chosen != nullptr ? Of(*chosen, situation) : Value(0.0);
    }
  }
  return 0.0;
}

Value Evaluator::Operated(const Expression& expression, const Situation& situation) {
  if (expression.type == ValueType::kBool) return OperatedTruth(expression, situation);
  if (expression.type == ValueType::kNumber) return OperatedNumber(expression, situation);
  std::string joined;
  for (const Expression& operand : expression.operands) {
    joined += TextOf(Of(operand, situation));
  }
  return joined;
}

double Evaluator::OperatedNumber(const Expression& expression, const Situation& situation) {
  if (!Step()) return 0;
  const Deeper deeper(&depth_);
  if (depth_ > kDeepestEvaluation) {
    Fail("an expression is nested too deep", "name parts of it as functions");
    return 0;
  }
  const double a = Number(expression.operands[0], situation);
  const char symbol = expression.symbol[0];
  if (expression.operands.size() == 1) return symbol == '-' ? -a : a;
  const double b = Number(expression.operands[1], situation);
  switch (symbol) {
    case '+':
      return a + b;
    case '-':
      return a - b;
    case '*':
      return a * b;
    case '/':
      return a / b;
    default:
      return std::fmod(a, b);
  }
}

bool Evaluator::OperatedTruth(const Expression& expression, const Situation& situation) {
  if (!Step()) return false;
  const Deeper deeper(&depth_);
  if (depth_ > kDeepestEvaluation) {
    Fail("an expression is nested too deep", "name parts of it as functions");
    return false;
  }
  const std::string& symbol = expression.symbol;
  if (symbol == "!") return !Truth(expression.operands[0], situation);
  if (symbol == "&&") {
    return Truth(expression.operands[0], situation) && Truth(expression.operands[1], situation);
  }
  if (symbol == "||") {
    return Truth(expression.operands[0], situation) || Truth(expression.operands[1], situation);
  }
  return Compared(expression, situation);
}

bool Evaluator::Compared(const Expression& expression, const Situation& situation) {
  const std::string& symbol = expression.symbol;
  const Expression &left = expression.operands[0], &right = expression.operands[1];
  const bool is_equality = symbol == "==" || symbol == "!=";
  if (IsText(left) || IsText(right)) {
    const std::string a = TextOf(Of(left, situation));
    const std::string b = TextOf(Of(right, situation));
    return is_equality ? (a == b) == (symbol == "==") : Ordered(symbol, a.compare(b), 0);
  }
  const double a = Number(left, situation);
  const double b = Number(right, situation);
  return is_equality ? (a == b) == (symbol == "==") : Ordered(symbol, a, b);
}

Value Evaluator::Called(const Expression& expression, const Situation& situation) {
  std::vector<Value> values;
  values.reserve(expression.operands.size());
  for (const Expression& operand : expression.operands) values.push_back(Of(operand, situation));
  if (failure_) return 0.0;
  if (expression.kind == Kind::kBuiltIn) {
    const BuiltIn& row = *expression.built_in;
    if (row.prints && notes_ != nullptr) notes_->Print(expression.range, values[0]);
    return row.evaluate(values, situation);
  }
  Situation inside = situation;
  inside.parameters = values;
  return Of(rules_.functions[expression.index].value, inside);
}

const Expression* Evaluator::Chosen(const Expression& expression, const Situation& situation) {
  const auto& operands = expression.operands;
  if (operands.empty()) return nullptr;
  const bool is_chance = expression.kind == Kind::kChance;
  double left = is_chance ? 100 * situation.random->Uniform() : 0;
  for (size_t i = 0; i + 1 < operands.size(); i += 2) {
    if (is_chance) left -= Number(operands[i], situation);
    if (is_chance ? left < 0 : Truth(operands[i], situation)) return &operands[i + 1];
    if (failure_) return nullptr;
  }
  return &operands.back();
}

}  // namespace parti::grammar
