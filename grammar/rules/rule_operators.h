// The operators of the rule language and how strongly they bind (CGA's, which are C's).
// What they compute is evaluate.h's.
#pragma once

#include <string_view>

namespace parti::grammar {

/// One of two operands; those of equal precedence go from left to right.
struct RuleOperator {
  std::string_view symbol;
  int precedence;  ///< from 1; the stronger the higher
};

/// Signs, "-" and "!", bind more strongly than all of them.
inline constexpr RuleOperator kRuleOperators[] = {
    {"||", 1}, {"&&", 2}, {"==", 3}, {"!=", 3}, {"<", 4}, {"<=", 4}, {">", 4},
    {">=", 4}, {"+", 5},  {"-", 5},  {"*", 6},  {"/", 6}, {"%", 6}};
inline constexpr int kSignPrecedence = 7;

/// nullptr where there is none.
constexpr const RuleOperator* FindOperator(std::string_view symbol) {
  for (const RuleOperator& row : kRuleOperators) {
    if (row.symbol == symbol) return &row;
  }
  return nullptr;
}

}  // namespace parti::grammar
