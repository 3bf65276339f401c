// A rule file as a value: what the parser makes, the checker approves and derivation runs
// (docs/language.md; Jesus 2018, 4.2; CGA). Names are resolved, types are known.
// Responsible neither for reading text (rule_text.h) nor for running it (rule_derivation.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "grammar/action.h"

namespace parti::grammar {

struct BuiltIn;  // built_ins.h: a function of the language

/// Bytes [from, to) of a file of a rule set.
struct TextRange {
  uint32_t file = 0;  ///< of RuleSet::files
  uint32_t from = 0;
  uint32_t to = 0;
};

/// CGA's float, bool and string.
enum class ValueType : uint8_t { kNumber, kBool, kText };
/// Alternatives in the order of ValueType.
using Value = std::variant<double, bool, std::string>;

/// What is computed for each shape anew: "case height > 20: rand(2, 3) else: 'floor'".
struct Expression {
  enum class Kind : uint8_t {
    kConstant,   ///< `constant`
    kAttribute,  ///< RuleSet::attributes[index]: an attr or a const
    kParameter,  ///< the index-th parameter of the rule or function that this stands in
    kCall,       ///< RuleSet::functions[index] of the operands
    kBuiltIn,    ///< `built_in` of the operands: sin(x), scope.sx, split.index
    kOperator,   ///< `symbol` of one or two operands
    kCase,       ///< condition, value, condition, value …, value: the first condition that holds
    kChance,     ///< weight, value, weight, value …, value for the rest of 100 %; weights 0 to 1
  };
  Kind kind = Kind::kConstant;
  ValueType type = ValueType::kNumber;  ///< of its value
  Value constant = 0.0;
  uint32_t index = 0;
  const BuiltIn* built_in = nullptr;
  std::string
      symbol;  ///< "+", "-", "*", "/", "%", "<", "<=", ">", ">=", "==", "!=", "&&", "||", "!"
  std::vector<Expression> operands;
  TextRange range;
};

/// A named value: "@Range(2.4, 6) attr floor_height = 3".
struct Attribute {
  std::string name;
  Expression value;
  bool constant = false;            ///< const: neither --set nor set() nor a style changes it
  std::string group;                ///< @Group; "" none
  std::optional<double> low, high;  ///< @Range
  std::vector<Value> choices;       ///< @Enum
  bool hidden = false;              ///< @Hidden
  TextRange range;
};

/// A parameter of a rule or function. Its type is inferred from how it is used; numbers otherwise.
struct RuleParameter {
  std::string name;
  ValueType type = ValueType::kNumber;
};

/// "area(w, h) = w * h"
struct RuleFunction {
  std::string name;
  std::vector<RuleParameter> parameters;
  Expression value;
  TextRange range;
};

struct Statement;

/// What happens to a shape: statements one after the other, or one of several bodies.
struct Body {
  enum class Kind : uint8_t { kSequence, kCase, kChance };
  struct Alternative {
    std::optional<Expression> condition;  ///< or weight (0 to 1); nothing: else
    std::shared_ptr<const Body> body;
  };
  Kind kind = Kind::kSequence;
  std::vector<Statement> statements;      ///< kSequence; empty: the shape stays as it is
  std::vector<Alternative> alternatives;  ///< kCase, kChance
  TextRange range;
};

/// One alternative in the braces of an operation: "~1: Wall", "side: Facade", "{ … }*". What it
/// makes is a body: a symbol, an operation sequence, NIL.
struct SuccessorRule {
  /// A size's number is the expression `size`; the Size here holds its kind, and its number where
  /// that is a constant. A Selector is complete. A layer's name is text.
  std::variant<std::monostate, Size, Selector, std::string> key;
  std::optional<Expression> size;
  Body body;
  std::vector<SuccessorRule> repeat;  ///< not empty: a group that repeats; all else is unused
  TextRange range;
};

/// One step of a body.
struct Statement {
  enum class Kind : uint8_t {
    kOperation,  ///< `operation` on the shape at hand; what has braces gives children
    kSymbol,     ///< a child of this symbol: the shape at hand as it now is
    kPush,       ///< [
    kPop,        ///< ]
    kSet,        ///< set(name, value): an attribute from here on, for this shape and those below
  };
  Kind kind = Kind::kOperation;
  const Operation* operation = nullptr;
  std::vector<Expression> arguments;  ///< one per parameter of the row, axes and words as text;
                                      ///< kSymbol: the rule's arguments; kSet: the value
  std::vector<SuccessorRule> successors;
  std::string symbol;     ///< kSymbol: its name; "NIL" ends the shape at hand
  bool deferred = false;  ///< kSymbol: "@Symbol", after the next normalisation (4.3.3)
  uint32_t index = 0;  ///< kSymbol: of RuleSet::rules, kNoRule for a terminal; kSet: of attributes
  TextRange range;
};

inline constexpr uint32_t kNoRule = 0xffffffff;

/// "Tower(h) --> case h > 20: extrude(h) Tall else: extrude(h) Low"
struct Rule {
  std::string symbol;
  std::vector<RuleParameter> parameters;
  Body body;
  bool start = false;  ///< @StartRule
  TextRange range;
};

/// A text that was read, for places in messages.
struct RuleFile {
  std::string name;  ///< as the user named it
  std::string text;
};

/// Immutable once made; shared by threads.
struct RuleSet {
  std::vector<RuleFile> files;  ///< the first is the one that was asked for; then its imports
  std::string version;          ///< version "…"; "" none
  std::vector<Attribute> attributes;
  std::vector<RuleFunction> functions;
  std::vector<Rule> rules;
  std::vector<std::string> styles;  ///< that the file knows
};

}  // namespace parti::grammar
