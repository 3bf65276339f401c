// Names and types of expressions.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "grammar/rules/built_ins.h"
#include "grammar/rules/rule_checker.h"

namespace parti::grammar {
namespace {

using Kind = WrittenExpression::Kind;

std::string TypeHint(ValueType wanted, ValueType got) {
  if (wanted == ValueType::kBool) return "compare it with something: x > 0, x == \"a\"";
  if (wanted == ValueType::kText) return "str(…) makes a text of it";
  return got == ValueType::kText ? "float(…) reads a number from a text" : "";
}

std::string CountText(const std::vector<size_t>& counts, std::string_view what) {
  std::vector<std::string> texts;
  for (const size_t count : counts) texts.push_back(std::to_string(count));
  return fmt::format("{} {}{}", fmt::join(texts, " or "), what,
                     counts.size() == 1 && counts[0] == 1 ? "" : "s");
}

Expression Word(const WrittenExpression& written) {
  Expression expression;
  expression.type = ValueType::kText;
  expression.constant = written.name;
  expression.range = written.range;
  return expression;
}

/// What stands for a value that is not known.
Value Nothing(ValueType type) {
  if (type == ValueType::kBool) return false;
  if (type == ValueType::kText) return std::string();
  return 0.0;
}

/// Whether CGA has a function of this name that takes or gives an array.
bool IsOfArrays(std::string_view name) {
  constexpr std::array<std::string_view, 9> kNames = {"size",       "sum",       "nRows",
                                                      "nColumns",   "transpose", "stringArray",
                                                      "floatArray", "boolArray", "splitString"};
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
}

std::vector<size_t> BuiltInsNamed(std::string_view name) {
  std::vector<size_t> counts;
  for (const BuiltIn& row : BuiltIns()) {
    if (row.name == name) counts.push_back(row.operands.size());
  }
  return counts;
}

}  // namespace

Expression RuleChecker::Resolve(const WrittenExpression& written, const Expected& expected,
                                MaybeType* type) {
  Expression expression;
  expression.range = written.range;
  MaybeType own;
  switch (written.kind) {
    case Kind::kConstant:
      expression.constant = written.constant;
      own = TypeOf(written.constant);
      break;
    case Kind::kName:
      own = ResolveName(written, &expression);
      break;
    case Kind::kCall:
      own = ResolveCall(written, &expression);
      break;
    case Kind::kOperator:
      own = ResolveOperator(written, expected, &expression);
      break;
    case Kind::kCase:
    case Kind::kChance:
      own = ResolveChoice(written, expected, &expression);
      break;
  }
  if (!own && expected.type) {
    Learn(expression, expected.type);
    own = expected.type;
  } else if (own && expected.type && *own != *expected.type) {
    Report(written.range, ErrorCode::kBadArguments,
           fmt::format("the {}{}{} is a {}, got a {}", expected.role,
                       expected.of.empty() ? "" : " of ", expected.of, NameOf(*expected.type),
                       NameOf(*own)),
           TypeHint(*expected.type, *own));
  }
  expression.type = own.value_or(ValueType::kNumber);
  const bool is_refused =
      expression.kind == Expression::Kind::kConstant && written.kind != Kind::kConstant;
  if (is_refused) expression.constant = Nothing(expression.type);
  if (type != nullptr) *type = own;
  return expression;
}

uint32_t RuleChecker::ParameterNamed(std::string_view name) const {
  if (inside_ == nullptr) return RuleNames::kNone;
  const auto& parameters = inside_->written->parameters;
  for (size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name == name) return static_cast<uint32_t>(i);
  }
  return RuleNames::kNone;
}

MaybeType RuleChecker::ResolveName(const WrittenExpression& written, Expression* expression) {
  expression->index = ParameterNamed(written.name);
  if (expression->index != RuleNames::kNone) {
    expression->kind = Expression::Kind::kParameter;
    return inside_->parameters[expression->index];
  }
  expression->index = names_.Attribute(FullName(written.name));
  if (expression->index != RuleNames::kNone) {
    expression->kind = Expression::Kind::kAttribute;
    return attributes_[expression->index].type;
  }
  return ResolveCall(written, expression);
}

MaybeType RuleChecker::ResolveCall(const WrittenExpression& written, Expression* expression) {
  const size_t count = written.operands.size();
  expression->index = names_.Function(FullName(written.name), count);
  const bool own = expression->index != RuleNames::kNone;
  const BuiltIn* row = own ? nullptr : FindBuiltIn(written.name, count);
  if (!own) expression->index = 0;
  expression->kind = own ? Expression::Kind::kCall : Expression::Kind::kBuiltIn;
  expression->built_in = row;
  if (!own && row == nullptr) {
    CheckOperands(written);
    expression->kind = Expression::Kind::kConstant;
    RefuseName(written);
    return std::nullopt;
  }
  MaybeType got;
  for (size_t i = 0; i < count; ++i) {
    MaybeType wanted;
    if (own) wanted = functions_[expression->index].parameters[i];
    if (row != nullptr) wanted = row->operands[i];
    if (row != nullptr && IsWordOf(*row, written.operands[i])) {
      expression->operands.push_back(Word(written.operands[i]));
      continue;
    }
    expression->operands.push_back(
        Resolve(written.operands[i], {wanted, "operand", written.name}, &got));
    if (own && learns_from_calls_) Set(&functions_[expression->index].parameters[i], got);
  }
  if (own) return functions_[expression->index].type;
  return row->prints ? got : row->result;
}

/// A bare name that stands for itself, as nothing else is called so: maxSlope.
bool RuleChecker::IsWordOf(const BuiltIn& row, const WrittenExpression& operand) const {
  if (operand.kind != Kind::kName) return false;
  const bool is_word =
      std::find(row.words.begin(), row.words.end(), operand.name) != row.words.end();
  return is_word && ParameterNamed(operand.name) == RuleNames::kNone &&
         names_.Attribute(FullName(operand.name)) == RuleNames::kNone &&
         names_.Function(FullName(operand.name), 0) == RuleNames::kNone;
}

/// Of an unknown function: a bare name may be a word of its own.
void RuleChecker::CheckOperands(const WrittenExpression& call) {
  for (const WrittenExpression& operand : call.operands) {
    if (operand.kind != Kind::kName) Resolve(operand, {{}, "operand", call.name});
  }
}

MaybeType RuleChecker::ResolveOperator(const WrittenExpression& written, const Expected& expected,
                                       Expression* expression) {
  expression->kind = Expression::Kind::kOperator;
  expression->symbol = written.name;
  const std::string& symbol = written.name;
  const bool is_logic = symbol == "!" || symbol == "&&" || symbol == "||";
  const std::string_view comparisons = "== != <= >= < >";
  if (!is_logic && comparisons.find(symbol) != std::string_view::npos) {
    return ResolveComparison(written, expression);
  }
  const bool is_sum = symbol == "+";
  MaybeType wanted = is_logic ? ValueType::kBool : ValueType::kNumber;
  if (is_sum && expected.type != ValueType::kNumber) wanted = std::nullopt;
  std::vector<MaybeType> types;
  for (const WrittenExpression& operand : written.operands) {
    // A text in a sum of numbers is told of the sum: what it gives is not what is expected.
    const MaybeType here = is_sum ? MaybeType() : wanted;
    expression->operands.push_back(
        Resolve(operand, {here, "operand", symbol}, &types.emplace_back()));
  }
  if (!is_sum) return is_logic ? ValueType::kBool : ValueType::kNumber;
  if (types[0] == ValueType::kText || types[1] == ValueType::kText) return ValueType::kText;
  if (wanted) {
    for (const Expression& operand : expression->operands) Learn(operand, wanted);
  }
  for (size_t i = 0; i < 2; ++i) {
    if (types[i] != ValueType::kBool) continue;
    Report(written.operands[i].range, ErrorCode::kBadArguments,
           "the operand of + is a number or a text, got a boolean", "str(…) makes a text of it");
  }
  const bool is_known = types[0] && types[1];
  return wanted || is_known ? MaybeType(ValueType::kNumber) : std::nullopt;
}

MaybeType RuleChecker::ResolveComparison(const WrittenExpression& written, Expression* expression) {
  MaybeType left, right;
  const std::string& symbol = written.name;
  expression->operands.push_back(Resolve(written.operands[0], {{}, "operand", symbol}, &left));
  expression->operands.push_back(Resolve(written.operands[1], {left, "operand", symbol}, &right));
  if (!left && right) Learn(expression->operands[0], right);
  const bool is_order = symbol != "==" && symbol != "!=";
  if (is_order && left == ValueType::kBool) {
    Report(written.range, ErrorCode::kBadArguments,
           fmt::format("{} compares numbers or texts, not booleans", symbol));
  }
  if (!left && right) expression->operands[0].type = *right;
  return ValueType::kBool;
}

MaybeType RuleChecker::ResolveChoice(const WrittenExpression& written, const Expected& expected,
                                     Expression* expression) {
  const bool is_case = written.kind == Kind::kCase;
  expression->kind = is_case ? Expression::Kind::kCase : Expression::Kind::kChance;
  const Expected condition =
      is_case ? Expected{ValueType::kBool, "condition"} : Expected{ValueType::kNumber, "weight"};
  Expected value = expected;
  if (!value.type) value.role = "alternative";
  for (size_t i = 0; i < written.operands.size(); ++i) {
    const bool last = i + 1 == written.operands.size() && i % 2 == 0;
    MaybeType type;
    const bool is_value = last || i % 2 == 1;
    expression->operands.push_back(
        Resolve(written.operands[i], is_value ? value : condition, &type));
    if (is_value && !value.type) value.type = type;
  }
  if (!is_case) CheckWeights(written, expression);
  return value.type;
}

void RuleChecker::CheckWeights(const WrittenExpression& written, Expression* expression) {
  std::vector<const Expression*> weights;
  for (size_t i = 0; i + 1 < expression->operands.size(); i += 2) {
    weights.push_back(&expression->operands[i]);
  }
  const bool has_else = written.operands.size() % 2 == 1;
  if (!CheckWeights(weights, has_else, written.range) || has_else) return;
  expression->operands.erase(expression->operands.end() - 2);
}

bool RuleChecker::CheckWeights(const std::vector<const Expression*>& weights, bool has_else,
                               TextRange range) {
  double sum = 0;
  bool is_constant = true;
  for (const Expression* weight : weights) {
    const double* number = std::get_if<double>(&weight->constant);
    is_constant = is_constant && weight->kind == Expression::Kind::kConstant && number != nullptr;
    if (!is_constant) break;
    sum += *number;
    if (*number >= 0 && *number <= 100) continue;
    Report(weight->range, ErrorCode::kBadNumber, fmt::format("a weight of {:.6g} %", *number),
           "give a number from 0 to 100");
  }
  constexpr double kSlack = 1e-6;
  if (is_constant && sum > 100 + kSlack) {
    Report(range, ErrorCode::kBadNumber, fmt::format("the weights sum up to {:.6g} %", sum),
           "they may sum up to 100 %");
  }
  const bool is_whole = is_constant && sum >= 100 - kSlack;
  if (!has_else && !is_whole) {
    Report(range, ErrorCode::kBadText, "these alternatives lack an else",
           "end them with else: for what the weights leave of 100 %");
  }
  return has_else || is_whole;
}

void RuleChecker::Learn(const Expression& expression, MaybeType type) {
  switch (expression.kind) {
    case Expression::Kind::kParameter:
      return Set(&inside_->parameters[expression.index], type);
    case Expression::Kind::kCase:
    case Expression::Kind::kChance:
      for (size_t i = 1; i < expression.operands.size(); i += 2)
        Learn(expression.operands[i], type);
      return Learn(expression.operands.back(), type);
    case Expression::Kind::kBuiltIn:
      if (expression.built_in->prints) Learn(expression.operands[0], type);
      return;
    default:
      return;
  }
}

void RuleChecker::Set(MaybeType* known, MaybeType type) {
  if (known->has_value() || !type) return;
  *known = type;
  changed_ = true;
}

void RuleChecker::RefuseName(const WrittenExpression& written) {
  if (!reporting_ || IsLost(written.name)) return;
  std::vector<size_t> counts = names_.FunctionsNamed(FullName(written.name));
  if (counts.empty()) counts = BuiltInsNamed(written.name);
  if (!counts.empty()) {
    Report(written.range, ErrorCode::kBadArguments,
           fmt::format("{} takes {}, got {}", written.name, CountText(counts, "operand"),
                       written.operands.size()));
    return;
  }
  const bool is_call = written.kind == Kind::kCall;
  const std::string what = fmt::format("{} '{}'", is_call ? "function" : "value", written.name);
  const bool is_array = is_call && IsOfArrays(written.name);
  const auto meant = !is_array && errors_->WantsHint(what) ? ValueLike(written.name) : std::nullopt;
  ReportUnknown(written.range, what,
                is_array  ? "arrays are not read; functions of lists are listSize, listItem …"
                : meant   ? fmt::format("did you mean '{}'?", *meant)
                : is_call ? "functions are listed in docs/functions.md"
                          : fmt::format("attr {} = …, or a text in quotes", written.name),
                /*can_be_skipped=*/is_call || written.name.find('.') != std::string::npos);
}

std::optional<std::string> RuleChecker::ValueLike(std::string_view name) const {
  std::vector<std::string> known = names_.Values(module_->prefix);
  if (inside_ != nullptr) {
    for (const WrittenParameter& p : inside_->written->parameters) known.push_back(p.name);
  }
  for (const BuiltIn& row : BuiltIns()) known.emplace_back(row.name);
  return DidYouMean(name, known);
}

}  // namespace parti::grammar
