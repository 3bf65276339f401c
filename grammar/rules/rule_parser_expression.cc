// Values of a rule file: expressions with CGA's precedence, case and chance.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "grammar/rules/rule_operators.h"
#include "grammar/rules/rule_parser.h"

namespace parti::grammar {
namespace {

using Kind = Token::Kind;

bool IsNumber(const WrittenExpression& expression) {
  return expression.kind == WrittenExpression::Kind::kConstant &&
         std::holds_alternative<double>(expression.constant);
}

}  // namespace

bool RuleParser::ReadValue(WrittenExpression* value) {
  if (lexer_.AtWord("case")) return ReadCaseValue(value);
  if (AtWeight()) return ReadChanceValue(value);
  return ReadExpression(value);
}

bool RuleParser::ReadCaseValue(WrittenExpression* value) {
  const Nesting nesting(&body_depth_);
  if (!Enter(nesting, kDeepestBody, "cases")) return false;
  const size_t from = lexer_.Peek().offset;
  value->kind = WrittenExpression::Kind::kCase;
  while (lexer_.AcceptWord("case")) {
    if (!ReadExpression(&value->operands.emplace_back()) ||
        !Expect(':', "':' after the condition") || !ReadValue(&value->operands.emplace_back())) {
      return false;
    }
  }
  if (!ReadElse() || !ReadValue(&value->operands.emplace_back())) return false;
  value->range = RangeFrom(from);
  return Deepen(value);
}

bool RuleParser::ReadChanceValue(WrittenExpression* value) {
  const Nesting nesting(&body_depth_);
  if (!Enter(nesting, kDeepestBody, "chances")) return false;
  const size_t from = lexer_.Peek().offset;
  value->kind = WrittenExpression::Kind::kChance;
  while (AtWeight()) {
    if (!ReadWeight(&value->operands.emplace_back()) ||
        !ReadValue(&value->operands.emplace_back())) {
      return false;
    }
  }
  if (lexer_.AtWord("else") && (!ReadElse() || !ReadValue(&value->operands.emplace_back()))) {
    return false;
  }
  value->range = RangeFrom(from);
  return Deepen(value);
}

bool RuleParser::ReadElse() {
  if (!lexer_.AcceptWord("else")) return Unexpected("'else:' after the last alternative");
  return Expect(':', "':' after else");
}

bool RuleParser::AtWeight() const {
  if (!lexer_.At(Kind::kNumber) && !lexer_.At(Kind::kName)) return false;
  Lexer ahead = lexer_;
  const bool name = ahead.Next().kind == Kind::kName;
  while (name && ahead.At('.') && ahead.Touching()) {
    ahead.Next();
    if (!ahead.At(Kind::kName)) return false;
    ahead.Next();
  }
  return ahead.Accept('%') && ahead.At(':');
}

bool RuleParser::ReadWeight(WrittenExpression* weight) {
  return ReadOperand(weight) && Expect('%', "'%'") && Expect(':', "':' after the weight");
}

bool RuleParser::ReadExpression(WrittenExpression* expression, int above) {
  if (!ReadOperand(expression)) return false;
  for (const RuleOperator* row = AtOperator(); row != nullptr && row->precedence > above;
       row = AtOperator()) {
    for (size_t i = 0; i < row->symbol.size(); ++i) lexer_.Next();
    WrittenExpression both;
    both.kind = WrittenExpression::Kind::kOperator;
    both.name = row->symbol;
    both.range = expression->range;
    both.operands.push_back(std::move(*expression));
    if (!ReadExpression(&both.operands.emplace_back(), row->precedence)) return false;
    both.range.to = static_cast<uint32_t>(lexer_.previous_end());
    *expression = std::move(both);
    if (!Deepen(expression)) return false;
  }
  return true;
}

const RuleOperator* RuleParser::AtOperator() const {
  if (!lexer_.At(Kind::kMark)) return nullptr;
  std::string symbol(1, lexer_.Peek().mark);
  Lexer ahead = lexer_;
  ahead.Next();
  if (symbol == "%" && ahead.At(':')) return nullptr;  // the weight of an alternative
  const bool two = ahead.At(Kind::kMark) && ahead.Touching();
  const RuleOperator* longer = two ? FindOperator(symbol + ahead.Peek().mark) : nullptr;
  return longer != nullptr ? longer : FindOperator(symbol);
}

bool RuleParser::ReadOperand(WrittenExpression* operand) {
  const Nesting nesting(&expression_depth_);
  if (!Enter(nesting, kDeepestExpression, "expressions")) return false;
  const Token& token = lexer_.Peek();
  const size_t from = token.offset;
  if (lexer_.At('-') || lexer_.At('!') || lexer_.At('+')) return ReadSigned(operand);
  if (lexer_.Accept('(')) {
    if (!ReadValue(operand)) return false;
    return Expect(')', "')'");
  }
  if (lexer_.At(Kind::kName)) return ReadNamed(operand);
  if (lexer_.At('[')) return RefuseArray(RangeOf(lexer_.Peek()));
  if (!lexer_.At(Kind::kNumber) && !lexer_.At(Kind::kText)) return Unexpected("a value");
  const Token literal = lexer_.Next();
  if (literal.kind == Kind::kNumber) operand->constant = literal.number;
  if (literal.kind == Kind::kText) operand->constant = literal.text;
  operand->range = RangeFrom(from);
  return true;
}

bool RuleParser::ReadSigned(WrittenExpression* operand) {
  const Token sign = lexer_.Next();
  WrittenExpression inner;
  if (!ReadOperand(&inner)) return false;
  if (sign.mark == '-' && IsNumber(inner)) {
    inner.constant = -std::get<double>(inner.constant);
  } else if (sign.mark != '+') {
    operand->kind = WrittenExpression::Kind::kOperator;
    operand->name = std::string(1, sign.mark);
    operand->operands.push_back(std::move(inner));
    operand->range = RangeFrom(sign.offset);
    return Deepen(operand);
  }
  *operand = std::move(inner);
  operand->range = RangeFrom(sign.offset);
  return true;
}

bool RuleParser::ReadNamed(WrittenExpression* operand) {
  const size_t from = lexer_.Peek().offset;
  if (lexer_.AtWord("true") || lexer_.AtWord("false")) {
    operand->constant = lexer_.Next().text == "true";
    operand->range = RangeFrom(from);
    return true;
  }
  const bool is_next = lexer_.Peek().starts_line && DeclarationFollows(lexer_, false);
  if (is_next || IsRuleWord(lexer_.Peek().text)) return Unexpected("a value");
  operand->kind = WrittenExpression::Kind::kName;
  ReadDotted(&operand->name);
  if (lexer_.At('.') && lexer_.Touching()) {
    lexer_.Next();
    return Unexpected("a name after the dot");
  }
  operand->range = RangeFrom(from);
  if (lexer_.Accept('(')) {
    operand->kind = WrittenExpression::Kind::kCall;
    if (!lexer_.Accept(')')) {
      do {
        if (!ReadValue(&operand->operands.emplace_back())) return false;
      } while (lexer_.Accept(','));
      if (!Expect(')', "',' or ')'")) return false;
    }
    operand->range = RangeFrom(from);
    if (!Deepen(operand)) return false;
  }
  const bool is_array = lexer_.At('[') && lexer_.Touching();  // heights[2], float[]
  return !is_array || RefuseArray(operand->range);
}

bool RuleParser::RefuseArray(TextRange range) {
  return Fail(range, ErrorCode::kBadText, "arrays are not read",
              "write a list, \"3;4;5\": float(listItem(list, 0)) is its first number");
}

void RuleParser::ReadDotted(std::string* name) {
  *name = lexer_.Next().text;
  while (lexer_.At('.') && lexer_.Touching()) {
    Lexer ahead = lexer_;
    ahead.Next();
    if (!ahead.At(Kind::kName) || !ahead.Touching()) return;
    *name += "." + ahead.Next().text;
    lexer_ = std::move(ahead);
  }
}

bool RuleParser::Deepen(WrittenExpression* parent) {
  for (const WrittenExpression& operand : parent->operands) {
    parent->depth = std::max(parent->depth, operand.depth + 1);
  }
  if (parent->depth <= kDeepestExpression) return true;
  return Fail(parent->range, ErrorCode::kLimitReached,
              fmt::format("this expression is nested more than {} deep", kDeepestExpression),
              "split it up with functions");
}

bool RuleParser::Enter(const Nesting& nesting, int deepest, std::string_view what) {
  if (nesting.depth() <= deepest) return true;
  return Fail(RangeOf(lexer_.Peek()), ErrorCode::kLimitReached,
              fmt::format("{} are nested more than {} deep here", what, deepest));
}

}  // namespace parti::grammar
