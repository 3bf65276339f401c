// A rule file as a value: what the parser makes, the checker approves and derivation runs
// (docs/language.md; Jesus 2018, 4.2; CGA). Names are resolved, types are known.
// Responsible neither for reading text (rule_text.h) nor for running it (rule_derivation.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "grammar/action.h"
#include "grammar/selection_action.h"

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

inline ValueType TypeOf(const Value& value) { return static_cast<ValueType>(value.index()); }
std::string_view NameOf(ValueType type);  ///< "number", "boolean", "text"

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
    kChance,     ///< weight, value, weight, value …, value for the rest; weights in percent
  };
  Kind kind = Kind::kConstant;
  ValueType type = ValueType::kNumber;  ///< of its value
  Value constant = 0.0;
  uint32_t index = 0;
  const BuiltIn* built_in = nullptr;
  /// "+" (numbers; texts when one operand is a text, the other as str() writes it), "-" "*" "/" "%"
  /// "<" "<=" ">" ">=" (numbers), "==" "!=" (two of one type), "&&" "||" "!" (booleans; the second
  /// operand only where it matters).
  std::string symbol;
  std::vector<Expression> operands;
  TextRange range;
};

/// A named value: "@Range(2.4, 6) attr floor_height = 3".
struct Attribute {
  /// What the value is, for who edits it: @Color, @File …
  enum class Use : uint8_t { kPlain, kColor, kFile, kDirectory, kAngle, kPercent, kDistance };
  std::string name;                 ///< with its import's prefix: "roof.slope"
  Expression value;                 ///< of the style that was asked for
  bool constant = false;            ///< const: neither --set nor set() nor a style changes it
  std::string group;                ///< @Group; "" none
  std::optional<double> order;      ///< @Order
  std::optional<double> low, high;  ///< @Range
  std::optional<double> step;       ///< @Range(stepsize=…)
  bool restricted = true;           ///< @Range(restricted=false): low and high are proposals
  std::vector<Value> choices;       ///< @Enum, @Range of texts; values of the attribute's type
  std::string description;          ///< @Description
  Use use = Use::kPlain;
  bool hidden = false;  ///< @Hidden
  TextRange range;      ///< of its name
};

/// A parameter of a rule or function. Its type is inferred from how it is used; numbers otherwise.
struct RuleParameter {
  std::string name;
  ValueType type = ValueType::kNumber;
};

/// "area(w, h) = w * h"; without parameters "span = 3": computed anew wherever it stands.
struct RuleFunction {
  std::string name;
  std::vector<RuleParameter> parameters;
  Expression value;
  TextRange range;  ///< of its name
};

struct Statement;

/// What happens to a shape: statements one after the other, or one of several bodies.
struct Body {
  enum class Kind : uint8_t { kSequence, kCase, kChance };
  struct Alternative {
    std::optional<Expression> condition;  ///< or weight in percent; the last has none: else
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

/// What an operation is told. An axis or a word is a text constant.
struct RuleArgument {
  Expression value;
  Size::Kind size = Size::Kind::kAbsolute;  ///< ParameterKind::kSize: how the number is meant
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
  const Operation* operation = nullptr;  ///< `split(axis) { … }*` is the row "repeat"
  /// kOperation: one per parameter of the row, those left out as the row's default says, checked
  /// against the row as far as they are constant; kSymbol: the rule's; kSet: the value.
  std::vector<RuleArgument> arguments;
  std::vector<SuccessorRule> successors;
  std::string symbol;     ///< kSymbol: its name; "NIL" ends the shape at hand
  bool deferred = false;  ///< kSymbol: "@Symbol", after the next normalisation (4.3.3)
  uint32_t index = 0;     ///< kSymbol: of RuleSet::rules, kNoRule: a terminal, if only because of
                          ///< a dot after it ("Wall."); kSet: of attributes
  TextRange range;        ///< of the operation's name, or the symbol
};

inline constexpr uint32_t kNoRule = 0xffffffff;

/// "Tower(h) --> case h > 20: extrude(h) Tall else: extrude(h) Low". Rules of one symbol differ in
/// the number of their parameters; what has no arguments (a start symbol) takes the one with none.
struct Rule {
  std::string symbol;  ///< with its import's prefix: "roof.Tiles"
  std::vector<RuleParameter> parameters;
  Body body;
  bool start = false;  ///< @StartRule
  TextRange range;     ///< of its symbol
};

/// A text that was read, for places in messages.
struct RuleFile {
  std::string name;  ///< as the user named it, or as its import's path leads to it
  std::string text;
};

/// `import roof ( Steep ) : "roof.cga" ( slope = 30, eaves )`
struct RuleImport {
  std::string prefix;
  std::string path;   ///< as written
  std::string style;  ///< "" its default
  /// Values given, and (nothing) attributes kept from taking the value of the importing file's
  /// attribute of the same name.
  std::vector<std::pair<std::string, std::optional<Expression>>> attributes;
  bool protects = false;  ///< empty parentheses: all attributes are kept from it
};

/// `style Modern extends Default`: a named set of declarations in place of others, up to the next.
struct RuleStyle {
  std::string name;
  std::string base;  ///< "Default" is the file without styles
  std::string text;  ///< its declarations as written
};

/// Immutable once made; shared by threads.
struct RuleSet {
  std::vector<RuleFile> files;      ///< the first is the one that was asked for; then its imports
  std::string version;              ///< version "…"; "" none
  std::vector<RuleImport> imports;  ///< of the first file
  std::vector<Attribute> attributes;
  std::vector<RuleFunction> functions;
  std::vector<Rule> rules;
  std::vector<RuleStyle> styles;  ///< that the first file knows
  std::string style;              ///< the one that was asked for; "" none
  Trees trees;                    ///< `tree NAME { … }`: run after the rules, on what they made
  /// What was unknown and became nothing: "operation 'envelope', 3 places".
  std::vector<std::string> skipped;
};

/// Equal but for where it stands in a text.
bool operator==(const Expression& a, const Expression& b);
bool operator==(const Attribute& a, const Attribute& b);
bool operator==(const RuleParameter& a, const RuleParameter& b);
bool operator==(const RuleFunction& a, const RuleFunction& b);
bool operator==(const Body& a, const Body& b);
bool operator==(const SuccessorRule& a, const SuccessorRule& b);
bool operator==(const RuleArgument& a, const RuleArgument& b);
bool operator==(const Statement& a, const Statement& b);
bool operator==(const Rule& a, const Rule& b);
bool operator==(const RuleImport& a, const RuleImport& b);
bool operator==(const RuleStyle& a, const RuleStyle& b);
/// What the files are called and how they are written does not matter, nor which style was asked
/// for: what came of it does.
bool operator==(const RuleSet& a, const RuleSet& b);

/// The rule for a symbol without arguments; kNoRule where there is none.
uint32_t RuleFor(const RuleSet& rules, std::string_view symbol);
/// The place in a file that a range names.
SourcePlace PlaceOf(const RuleSet& rules, const TextRange& range);

}  // namespace parti::grammar
