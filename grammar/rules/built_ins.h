// The functions of the rule language: a row per name and number of operands. The parser finds them
// here and takes their types; the evaluator calls them; the manual lists them. CGA's names and
// meanings where CGA has them. Functions that rules define are rule_set.h's.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "grammar/rules/conversions.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

struct Situation;

/// A row of the table. Names with a dot and no operands are the shape's, and are written without
/// parentheses: scope.sx, split.index.
struct BuiltIn {
  std::string_view name;
  std::span<const std::optional<ValueType>> operands;  ///< their types; nothing: any
  ValueType result;
  std::string_view doc;

  /// Pure but for what it draws from the situation's stream. The operands are of the row's types,
  /// or what is turned into them (conversions.h). Never fails: what has no answer is infinite, no
  /// number, or "", and refused by the operation that gets it.
  Value (*evaluate)(std::span<const Value> operands, const Situation& situation);
  /// Texts that may be written as bare words where nothing else has the name: maxSlope, world.up.
  std::span<const std::string_view> words = {};
  bool prints = false;  ///< its only operand is its result, of that one's type, and is printed
};

/// All rows, sorted by name, then by the number of operands.
std::span<const BuiltIn> BuiltIns();
/// nullptr when there is none of this name with so many operands.
const BuiltIn* FindBuiltIn(std::string_view name, size_t operands);

}  // namespace parti::grammar
