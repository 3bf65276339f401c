#include "grammar/rules/rule_body_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "base/check.h"
#include "grammar/action_text.h"
#include "grammar/lexer.h"
#include "grammar/operation.h"
#include "grammar/rules/built_ins.h"
#include "grammar/rules/rule_expression_text.h"
#include "grammar/rules/scatter_body.h"

namespace parti::grammar {
namespace {

constexpr size_t kWidest = 80;        ///< of a line
constexpr size_t kWidestBraces = 50;  ///< braces of one line behind what stands before them
constexpr std::string_view kOffset = "offset";
constexpr std::string_view kScatter = "scatter";

/// Bodies of one rule. What does not fit into a line is broken at braces and cases.
class BodyWriter {
 public:
  BodyWriter(const RuleSet& rules, const Rule& rule) : rules_(rules), rule_(rule) {}

  /// `column` is where the text starts, `indent` what its further lines start with; kFlat keeps it
  /// on one line.
  std::string Text(const Body& body, size_t column, size_t indent) const {
    if (indent != kFlat) {
      std::string flat = Text(body, column, kFlat);
      if (column + flat.size() <= kWidest) return flat;
    }
    if (body.kind != Body::Kind::kSequence) return ChoiceText(body, indent);
    return StepsText(body.statements, indent);
  }

  static constexpr size_t kFlat = static_cast<size_t>(-1);

 private:
  static std::string Break(size_t indent) {
    return indent == kFlat ? " " : "\n" + std::string(indent, ' ');
  }

  using Steps = std::span<const Statement>;

  std::string StepsText(Steps steps, size_t indent) const {
    std::vector<std::string> parts;
    for (size_t i = 0; i < steps.size(); ++i) {
      const size_t end = EndOfScatter(steps, i);
      if (end > 0) {
        parts.push_back(ScatterText(steps.subspan(i + 1, end - i - 1), indent));
        i = end;
        continue;
      }
      const bool goes_on = i + 1 < steps.size() && steps[i + 1].kind != Statement::Kind::kPop;
      const bool is_offset = IsPlainOffset(steps[i]);
      const std::string text = StatementText(steps[i], indent);
      parts.push_back(is_offset && goes_on ? fmt::format("[ {} ]", text) : text);
    }
    return fmt::format("{}", fmt::join(parts, " "));
  }

  /// The step that closes the brackets which step `from` opens, where they hold what CGA's scatter
  /// has in its braces (scatter_body.h); else 0.
  static size_t EndOfScatter(Steps steps, size_t from) {
    const bool is_open = steps[from].kind == Statement::Kind::kPush && from + 2 < steps.size();
    if (!is_open || !IsPlainScatter(steps[from + 1])) return 0;
    int depth = 1;
    for (size_t i = from + 2; i < steps.size(); ++i) {
      if (steps[i].kind == Statement::Kind::kPush) ++depth;
      if (steps[i].kind == Statement::Kind::kPop && --depth == 0) return i > from + 2 ? i : 0;
    }
    return 0;
  }

  /// Whether its seed is drawn for each shape, and CGA has its arguments.
  static bool IsPlainScatter(const Statement& step) {
    if (step.operation == nullptr || step.operation->name != kScatter) return false;
    const Expression& seed = step.arguments.back().value;
    const bool draws = seed.kind == Expression::Kind::kBuiltIn && seed.operands.size() == 1 &&
                       seed.built_in->name == "rand" &&
                       seed.operands[0].constant == Value(kScatterSeeds);
    const bool is_gaussian = step.arguments[2].value.constant == Value(std::string("gaussian"));
    const auto& row = step.operation->parameters;
    return draws && (is_gaussian || (IsDefault(row[3], step.arguments[3]) &&
                                     IsDefault(row[4], step.arguments[4])));
  }

  std::string ScatterText(Steps steps, size_t indent) const {
    const auto& parameters = steps[0].operation->parameters;
    const bool is_usual = IsDefault(parameters[3], steps[0].arguments[3]) &&
                          IsDefault(parameters[4], steps[0].arguments[4]);
    std::vector<std::string> arguments;
    for (size_t i = 0; i < (is_usual ? 3 : 5); ++i) {
      AddArgument(parameters[i], steps[0].arguments[i], &arguments);
    }
    return fmt::format("{}({}) {{ {} }}", kScatter, fmt::join(arguments, ", "),
                       StepsText(steps.subspan(1), indent));
  }

  /// Whether each of its parts is named at most once: CGA says it with a comp(f).
  static bool IsPlainOffset(const Statement& step) {
    if (step.operation == nullptr || step.operation->name != kOffset) return false;
    const auto& parts = step.successors;
    return parts.size() == 1 || (parts.size() == 2 && parts[0].key != parts[1].key);
  }

  std::string ChoiceText(const Body& body, size_t indent) const {
    const size_t inner = indent == kFlat ? kFlat : indent + 2;
    std::string text;
    for (const Body::Alternative& alternative : body.alternatives) {
      if (!text.empty() || indent != kFlat) text += Break(indent);
      std::string head = "else: ";
      if (alternative.condition && body.kind == Body::Kind::kCase) {
        head = fmt::format("case {}: ", Operand(*alternative.condition));
      } else if (alternative.condition) {
        head = WeightText(rules_, rule_.parameters, *alternative.condition);
      }
      const std::string chosen = Text(*alternative.body, indent + head.size(), inner);
      text += head + (chosen.empty() ? "[ ]" : chosen);
    }
    return text;
  }

  std::string StatementText(const Statement& statement, size_t indent) const {
    switch (statement.kind) {
      case Statement::Kind::kPush:
        return "[";
      case Statement::Kind::kPop:
        return "]";
      case Statement::Kind::kSet:
        return fmt::format("set({}, {})", rules_.attributes.at(statement.index).name,
                           Operand(statement.arguments.at(0).value));
      case Statement::Kind::kSymbol:
        return SymbolText(statement);
      case Statement::Kind::kOperation:
        break;
    }
    return OperationText(statement, indent);
  }

  std::string SymbolText(const Statement& statement) const {
    std::vector<std::string> arguments;
    for (const RuleArgument& argument : statement.arguments) {
      arguments.push_back(Operand(argument.value));
    }
    const bool ends = statement.index == kNoRule && RuleFor(rules_, statement.symbol) != kNoRule;
    return fmt::format("{}{}{}{}", statement.deferred ? "@" : "", statement.symbol,
                       arguments.empty() ? "" : fmt::format("({})", fmt::join(arguments, ", ")),
                       ends ? "." : "");
  }

  /// As CGA has it.
  std::string MaterialText(const Statement& statement) const {
    return fmt::format("set(material.{}, {})",
                       std::get<std::string>(statement.arguments.at(0).value.constant),
                       Operand(statement.arguments.at(1).value));
  }

  std::string OperationText(const Statement& statement, size_t indent) const {
    CHECK(statement.operation != nullptr, "an operation of the table");
    const Operation& row = *statement.operation;
    const bool is_repeat = row.name == kRepeatName;
    if (row.name == "setMaterial") return MaterialText(statement);
    std::string text =
        fmt::format("{}({})", Written(row), fmt::join(ArgumentTexts(statement), ", "));
    if (row.braces == Braces::kNone) return text;
    const auto& successors = statement.successors;
    const bool is_star = is_repeat || (row.name != kSplitName && row.braces == Braces::kSizes &&
                                       successors.size() == 1 && !successors[0].repeat.empty());
    const auto& inside = is_star && !is_repeat ? successors[0].repeat : successors;
    if (IsPlainOffset(statement)) text += " comp(f)";
    return text + " " + BracesText(inside, indent) + (is_star ? "*" : "");
  }

  std::vector<std::string> ArgumentTexts(const Statement& statement) const {
    const Operation& row = *statement.operation;
    std::vector<std::string> texts;
    size_t count = statement.arguments.size();
    while (count > 0 && row.parameters[count - 1].kind != ParameterKind::kColor &&
           IsDefault(row.parameters[count - 1], statement.arguments[count - 1])) {
      --count;
    }
    for (size_t i = 0; i < count; ++i) {
      const Parameter& parameter = row.parameters[i];
      const bool is_color = parameter.kind == ParameterKind::kColor;  // in place of numbers
      const bool is_implied = (is_color ? count > 1 : parameter.kind == ParameterKind::kWord) &&
                              IsDefault(parameter, statement.arguments[i]);
      if (!is_implied) AddArgument(parameter, statement.arguments[i], &texts);
    }
    for (const SuccessorRule& successor : statement.successors) {
      const auto* name = std::get_if<std::string>(&successor.key);
      if (name != nullptr) texts.push_back(QuotedText(*name));
    }
    return texts;
  }

  static bool IsDefault(const Parameter& parameter, const RuleArgument& argument) {
    if (parameter.required || argument.value.kind != Expression::Kind::kConstant) return false;
    const Argument& usual = parameter.default_value;
    const Value& value = argument.value.constant;
    if (const auto* size = std::get_if<Size>(&usual)) {
      return value == Value(size->value) && argument.size == size->kind;
    }
    if (const auto* axis = std::get_if<Axis>(&usual))
      return value == Value(std::string(NameOf(*axis)));
    if (const auto* number = std::get_if<double>(&usual)) return value == Value(*number);
    if (const auto* yes = std::get_if<bool>(&usual)) return value == Value(*yes);
    return value == Value(std::get<std::string>(usual));
  }

  void AddArgument(const Parameter& parameter, const RuleArgument& argument,
                   std::vector<std::string>* texts) const {
    const Expression& value = argument.value;
    const bool is_word =
        parameter.kind == ParameterKind::kAxis || parameter.kind == ParameterKind::kWord;
    if (is_word && value.kind == Expression::Kind::kConstant) {
      texts->push_back(std::get<std::string>(value.constant));
    } else if (is_word) {
      texts->push_back(Operand(value.operands.at(0)));  // a part's number, computed
    } else {
      texts->push_back(SizeMark(argument.size) + Operand(value));
    }
  }

  static std::string SizeMark(Size::Kind kind) {
    return kind == Size::Kind::kRelative ? "'" : kind == Size::Kind::kFloating ? "~" : "";
  }

  std::string BracesText(const std::vector<SuccessorRule>& successors, size_t indent) const {
    if (indent != kFlat) {
      std::string flat = BracesText(successors, kFlat);
      if (indent + flat.size() <= kWidestBraces) return flat;
    }
    const size_t inner = indent == kFlat ? kFlat : indent + 2;
    std::string text = "{";
    for (size_t i = 0; i < successors.size(); ++i) {
      if (i > 0) text += " |";
      text += Break(inner) + SuccessorText(successors[i], inner);
    }
    return text + Break(indent) + "}";
  }

  std::string SuccessorText(const SuccessorRule& successor, size_t indent) const {
    if (!successor.repeat.empty()) return BracesText(successor.repeat, indent) + "*";
    std::string text;
    if (const Size* size = std::get_if<Size>(&successor.key)) {
      text = SizeMark(size->kind) +
             (successor.size ? Operand(*successor.size) : NumberText(size->value)) + ": ";
    } else if (const auto* selector = std::get_if<Selector>(&successor.key)) {
      text = TextOf(*selector) + ": ";
    }
    const std::string body =
        Text(successor.body, indent + text.size(), indent == kFlat ? kFlat : indent + 2);
    return text + (body.empty() ? "[ ]" : body);
  }

  std::string Operand(const Expression& expression) const {
    return ExpressionText(rules_, rule_.parameters, expression, Place::kOperand);
  }

  const RuleSet& rules_;
  const Rule& rule_;
};

}  // namespace

std::string BodyText(const RuleSet& rules, const Rule& rule, size_t column, size_t indent) {
  return BodyWriter(rules, rule).Text(rule.body, column, indent);
}

}  // namespace parti::grammar
