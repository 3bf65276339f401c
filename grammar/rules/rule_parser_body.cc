// Bodies of rules: operations and symbols one after the other, cases, chances, and what stands in
// the braces of operations.
#include <fmt/format.h>

#include <utility>

#include "grammar/rules/rule_parser.h"

namespace parti::grammar {
namespace {

using Kind = Token::Kind;

}  // namespace

bool RuleParser::ReadBody(WrittenBody* body) {
  const Nesting nesting(&body_depth_);
  if (!Enter(nesting, kDeepestBody, "bodies")) return false;
  const size_t from = lexer_.Peek().offset;
  const bool good = lexer_.AtWord("case") ? ReadCases(body)
                    : AtWeight()          ? ReadChances(body)
                                          : ReadSequence(body);
  body->range = RangeFrom(from);
  return good;
}

bool RuleParser::ReadCases(WrittenBody* body) {
  body->kind = Body::Kind::kCase;
  while (lexer_.AcceptWord("case")) {
    auto& alternative = body->alternatives.emplace_back();
    first_ = false;
    if (!ReadExpression(&alternative.condition.emplace_back()) ||
        !Expect(':', "':' after the condition")) {
      body->alternatives.pop_back();  // a part of a value is none
      return false;
    }
    if (!ReadChosen(&alternative)) return false;
  }
  return ReadElse() && ReadChosen(&body->alternatives.emplace_back());
}

bool RuleParser::ReadChances(WrittenBody* body) {
  body->kind = Body::Kind::kChance;
  while (AtWeight()) {
    auto& alternative = body->alternatives.emplace_back();
    first_ = false;
    if (!ReadWeight(&alternative.condition.emplace_back())) {
      body->alternatives.pop_back();
      return false;
    }
    if (!ReadChosen(&alternative)) return false;
  }
  if (!lexer_.AtWord("else")) return true;
  return ReadElse() && ReadChosen(&body->alternatives.emplace_back());
}

bool RuleParser::ReadChosen(WrittenBody::Alternative* alternative) {
  WrittenBody& body = alternative->body.emplace_back();
  if (!ReadBody(&body)) return false;
  // An empty one before another case would be read as holding it.
  if (body.kind != Body::Kind::kSequence || !body.statements.empty()) return true;
  return Unexpected("an operation or a symbol; [ ] changes nothing");
}

bool RuleParser::ReadSequence(WrittenBody* body) {
  int open = 0;  // brackets that this sequence has opened
  while (!AtBodyEnd() && !(in_brackets_ && open == 0 && lexer_.At(']'))) {
    const bool opens = lexer_.At('[');
    open += opens ? 1 : lexer_.At(']') ? -1 : 0;
    if (!ReadStep(&body->statements.emplace_back())) {
      body->statements.pop_back();
      return false;
    }
    first_ = false;
    if (opens && (lexer_.AtWord("case") || AtWeight()) && !ReadBranch(body)) return false;
  }
  return true;
}

/// "[ case … ]": the cases become a rule of their own, which the brackets name.
bool RuleParser::ReadBranch(WrittenBody* body) {
  WrittenDeclaration branch;
  branch.name = fmt::format("{}_branch{}", rule_->name, ++branches_);
  branch.range = RangeOf(lexer_.Peek());
  branch.parameters = rule_->parameters;
  const bool outer = std::exchange(in_brackets_, true);
  const bool good = ReadBody(&branch.body);
  in_brackets_ = outer;
  if (!good) return false;
  if (!lexer_.At(']')) return Unexpected("']' after the last alternative");
  WrittenStatement& call = body->statements.emplace_back();
  call.name = branch.name;
  call.range = branch.range;
  call.called = !branch.parameters.empty();
  for (const WrittenParameter& parameter : branch.parameters) {
    WrittenArgument& argument = call.arguments.emplace_back();
    argument.value.kind = WrittenExpression::Kind::kName;
    argument.value.name = parameter.name;
    argument.range = argument.value.range = branch.range;
  }
  Add(std::move(branch));
  return true;
}

bool RuleParser::AtBodyEnd() const {
  if (lexer_.At('[') || lexer_.At(']')) return false;
  if (lexer_.At('@')) return AtAnnotation();
  if (!lexer_.At(Kind::kName)) return true;
  return lexer_.AtWord("else") || lexer_.AtWord("case") || AtWeight() || AtDeclaration();
}

bool RuleParser::ReadStep(WrittenStatement* statement) {
  const size_t from = lexer_.Peek().offset;
  if (lexer_.At('[') || lexer_.At(']')) {
    statement->kind = lexer_.At('[') ? WrittenStatement::Kind::kPush : WrittenStatement::Kind::kPop;
    statement->range = RangeOf(lexer_.Next());
    return true;
  }
  statement->deferred = lexer_.Accept('@');
  if (!lexer_.At(Kind::kName)) return Unexpected("a symbol after the @");
  if (IsRuleWord(lexer_.Peek().text)) return Unexpected("an operation or a symbol");
  ReadDotted(&statement->name);
  statement->ends = lexer_.Touching() && lexer_.Accept('.');
  statement->range = RangeFrom(from);
  if (lexer_.At('(') && !ReadArguments(&statement->arguments)) return false;
  statement->called = lexer_.previous_end() > statement->range.to;
  if (!lexer_.At('{')) return true;
  statement->braces = true;
  const size_t failures = failures_;
  if (!ReadBraces(&statement->alternatives)) return false;
  statement->broken = failures_ != failures;
  statement->repeated = lexer_.Accept('*');
  return true;
}

bool RuleParser::ReadArguments(std::vector<WrittenArgument>* arguments) {
  lexer_.Next();
  if (lexer_.Accept(')')) return true;
  do {
    if (!ReadArgument(&arguments->emplace_back())) return false;
  } while (lexer_.Accept(','));
  return Expect(')', "',' or ')'");
}

bool RuleParser::ReadArgument(WrittenArgument* argument) {
  const size_t from = lexer_.Peek().offset;
  if (lexer_.Accept('~')) argument->size = Size::Kind::kFloating;
  if (argument->size == Size::Kind::kAbsolute && lexer_.Accept('\'')) {
    argument->size = Size::Kind::kRelative;
  }
  if (!ReadValue(&argument->value)) return false;
  argument->range = RangeFrom(from);
  return true;
}

bool RuleParser::ReadBraces(std::vector<WrittenAlternative>* alternatives) {
  const Nesting nesting(&body_depth_);
  if (!Enter(nesting, kDeepestBody, "braces")) return false;
  const bool outer = std::exchange(in_brackets_, false);
  const bool good = ReadAlternatives(alternatives);
  in_brackets_ = outer;
  return good;
}

bool RuleParser::ReadAlternatives(std::vector<WrittenAlternative>* alternatives) {
  lexer_.Next();
  const int braces = lexer_.open_braces();
  if (lexer_.Accept('}')) return true;
  while (true) {
    const bool good = ReadAlternative(&alternatives->emplace_back());
    if (!good) alternatives->pop_back();
    if (good && !lexer_.At('|') && !lexer_.At('}')) {
      Error error = lexer_.Unexpected("'|' or '}'");
      if (lexer_.At(',')) error.hint = "alternatives are separated by |";
      Fail(RangeOf(lexer_.Peek()), error.code, error.message, error.hint);
    }
    if (!SkipToAlternative(braces)) return false;
    if (lexer_.Accept('}')) return true;
    lexer_.Next();
  }
}

bool RuleParser::SkipToAlternative(int braces) {
  for (; !lexer_.At(Kind::kEnd); lexer_.Next()) {
    if (lexer_.open_braces() == braces && (lexer_.At('|') || lexer_.At('}'))) return true;
    if (lexer_.open_braces() < braces) return false;
    if (lexer_.Peek().starts_line && AtDeclaration()) return false;
  }
  return false;
}

bool RuleParser::ReadAlternative(WrittenAlternative* alternative) {
  const size_t from = lexer_.Peek().offset;
  if (lexer_.At('{')) {
    alternative->group = true;
    if (!ReadBraces(&alternative->repeat) || !Expect('*', "'*' after braces in braces")) {
      return false;
    }
  } else {
    if (AtKey()) {
      if (!ReadArgument(&alternative->key.emplace_back())) return false;
      if (!lexer_.Accept('=') && !Expect(':', "':' after the size or selector")) return false;
    }
    if (!ReadBody(&alternative->body)) return false;
  }
  alternative->range = RangeFrom(from);
  return true;
}

/// "all = Roof", as CGA has it, and no comparison.
bool RuleParser::AtEqualsAlone(Lexer at) {
  at.Next();
  return !(at.At('=') && at.Touching());
}

bool RuleParser::AtKey() const {
  if (lexer_.At('~') || lexer_.At('\'') || lexer_.At('-')) return true;
  if (lexer_.At(Kind::kNumber)) return !AtWeight();
  Kind previous = Kind::kMark;
  bool weight = false;
  int parentheses = 0;
  for (Lexer ahead = lexer_; !ahead.At(Kind::kEnd); ahead.Next()) {
    const Token& token = ahead.Peek();
    if (parentheses == 0 && ahead.At(':')) return !weight;
    if (parentheses == 0 && ahead.At('=') && previous == Kind::kName) return AtEqualsAlone(ahead);
    if (ahead.At('(')) ++parentheses;
    if (ahead.At(')') && --parentheses < 0) return false;
    if (ahead.At('{') || ahead.At('}') || ahead.At('[') || ahead.At('@')) return false;
    if (ahead.At(Kind::kArrow)) return false;
    const bool ends =
        ahead.At('|') || ahead.At(';') || ahead.AtWord("case") || ahead.AtWord("else");
    if (parentheses == 0 && ends) return false;
    const bool after_name = previous == Kind::kName || previous == Kind::kEnd;
    if (parentheses == 0 && token.kind == Kind::kName && after_name) return false;
    // kEnd stands for a closing parenthesis: a name after it starts another step.
    previous = ahead.At(')') ? Kind::kEnd : token.kind;
    weight = ahead.At('%');
  }
  return false;
}

}  // namespace parti::grammar
