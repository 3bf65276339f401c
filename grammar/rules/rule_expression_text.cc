#include "grammar/rules/rule_expression_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "grammar/lexer.h"
#include "grammar/rules/built_ins.h"
#include "grammar/rules/rule_operators.h"
#include "grammar/rules/rule_text.h"

namespace parti::grammar {
namespace {

using Kind = Expression::Kind;

class ExpressionWriter {
 public:
  ExpressionWriter(const RuleSet& rules, std::span<const RuleParameter> parameters)
      : rules_(rules), parameters_(parameters) {}

  /// In parentheses where it binds no more strongly than `above`.
  std::string Text(const Expression& e, int above) const {
    switch (e.kind) {
      case Kind::kConstant:
        return ConstantText(e.constant);
      case Kind::kAttribute:
        return rules_.attributes.at(e.index).name;
      case Kind::kParameter:
        return parameters_[e.index].name;
      case Kind::kCall:
        return CallText(rules_.functions.at(e.index).name, e, /*bare=*/true);
      case Kind::kBuiltIn:
        return CallText(e.built_in->name, e, /*bare=*/e.built_in->name != "rand");
      case Kind::kOperator:
        return OperatorText(e, above);
      case Kind::kCase:
      case Kind::kChance:
        return fmt::format("({})", ChoiceText(e));
    }
    return "";
  }

  std::string ValueText(const Expression& e) const {
    return e.kind == Kind::kCase || e.kind == Kind::kChance ? ChoiceText(e) : Text(e, 0);
  }

 private:
  std::string CallText(std::string_view name, const Expression& e, bool bare) const {
    if (e.operands.empty() && bare) return std::string(name);
    std::vector<std::string> operands;
    for (const Expression& operand : e.operands) {
      const auto* word = std::get_if<std::string>(&operand.constant);
      const bool is_bare = e.kind == Kind::kBuiltIn && operand.kind == Kind::kConstant &&
                           word != nullptr && IsFreeWord(*e.built_in, *word);
      operands.push_back(is_bare ? *word : Text(operand, 0));
    }
    return fmt::format("{}({})", name, fmt::join(operands, ", "));
  }

  /// A word of the function that nothing else is called.
  bool IsFreeWord(const BuiltIn& row, std::string_view word) const {
    const auto is_word = [&](const auto& named) { return named.name == word; };
    return std::find(row.words.begin(), row.words.end(), word) != row.words.end() &&
           std::none_of(rules_.attributes.begin(), rules_.attributes.end(), is_word) &&
           std::none_of(rules_.functions.begin(), rules_.functions.end(), is_word) &&
           std::none_of(parameters_.begin(), parameters_.end(), is_word);
  }

  std::string OperatorText(const Expression& e, int above) const {
    if (e.operands.size() == 1) {
      const bool sign = e.operands[0].kind == Kind::kOperator && e.operands[0].operands.size() == 1;
      const std::string operand = Text(e.operands[0], kSignPrecedence);
      return e.symbol + (sign ? "(" + operand + ")" : operand);
    }
    const int own = FindOperator(e.symbol)->precedence;
    std::string text =
        fmt::format("{} {} {}", Text(e.operands[0], own - 1), e.symbol, Text(e.operands[1], own));
    return own <= above ? "(" + text + ")" : text;
  }

  std::string ChoiceText(const Expression& e) const {
    std::string text;
    for (size_t i = 0; i + 1 < e.operands.size(); i += 2) {
      text += e.kind == Kind::kCase ? fmt::format("case {}: ", Text(e.operands[i], 0))
                                    : WeightText(rules_, parameters_, e.operands[i]);
      text += ValueText(e.operands[i + 1]) + " ";
    }
    return text + "else: " + ValueText(e.operands.back());
  }

  const RuleSet& rules_;
  std::span<const RuleParameter> parameters_;
};

}  // namespace

std::string ExpressionText(const RuleSet& rules, std::span<const RuleParameter> parameters,
                           const Expression& expression, Place place) {
  const ExpressionWriter writer(rules, parameters);
  return place == Place::kValue ? writer.ValueText(expression) : writer.Text(expression, 0);
}

std::string ConstantText(const Value& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? QuotedText(*text) : TextOf(value);
}

std::string WeightText(const RuleSet& rules, std::span<const RuleParameter> parameters,
                       const Expression& weight) {
  return ExpressionText(rules, parameters, weight, Place::kOperand) + "%: ";
}

std::string TextOf(const RuleSet& rules, const Expression& expression,
                   std::span<const RuleParameter> parameters) {
  return ExpressionText(rules, parameters, expression, Place::kValue);
}

}  // namespace parti::grammar
