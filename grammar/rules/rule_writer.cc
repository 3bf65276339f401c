// A RuleSet as text: plain CGA where it is plain CGA (TextOf of rule_text.h).
#include <fmt/format.h>

#include <vector>

#include "grammar/lexer.h"
#include "grammar/rules/rule_body_text.h"
#include "grammar/rules/rule_expression_text.h"
#include "grammar/rules/rule_text.h"

namespace parti::grammar {
namespace {

std::string ParametersText(const std::vector<RuleParameter>& parameters) {
  std::vector<std::string> names;
  for (const RuleParameter& parameter : parameters) names.push_back(parameter.name);
  return names.empty() ? "" : fmt::format("({})", fmt::join(names, ", "));
}

std::string RangeText(const Attribute& attribute) {
  if (attribute.low && attribute.high && !attribute.step && attribute.restricted) {
    return fmt::format("@Range({}, {})", NumberText(*attribute.low), NumberText(*attribute.high));
  }
  std::vector<std::string> bounds;
  const auto add = [&](std::string_view name, const std::optional<double>& bound) {
    if (bound) bounds.push_back(fmt::format("{}={}", name, NumberText(*bound)));
  };
  add("min", attribute.low);
  add("max", attribute.high);
  add("stepsize", attribute.step);
  if (!attribute.restricted) bounds.emplace_back("restricted=false");
  return bounds.empty() ? "" : fmt::format("@Range({})", fmt::join(bounds, ", "));
}

std::string UseText(Attribute::Use use) {
  switch (use) {
    case Attribute::Use::kColor:
      return "@Color";
    case Attribute::Use::kFile:
      return "@File";
    case Attribute::Use::kDirectory:
      return "@Directory";
    case Attribute::Use::kAngle:
      return "@Angle";
    case Attribute::Use::kPercent:
      return "@Percent";
    case Attribute::Use::kDistance:
      return "@Distance";
    case Attribute::Use::kPlain:
      break;
  }
  return "";
}

std::string AnnotationsText(const Attribute& attribute) {
  std::vector<std::string> texts;
  if (!attribute.group.empty()) {
    texts.push_back(fmt::format("@Group({})", QuotedText(attribute.group)));
  }
  if (attribute.order) texts.push_back(fmt::format("@Order({})", NumberText(*attribute.order)));
  if (!attribute.description.empty()) {
    texts.push_back(fmt::format("@Description({})", QuotedText(attribute.description)));
  }
  if (std::string range = RangeText(attribute); !range.empty()) texts.push_back(std::move(range));
  if (std::string use = UseText(attribute.use); !use.empty()) texts.push_back(std::move(use));
  if (attribute.hidden) texts.emplace_back("@Hidden");
  std::vector<std::string> choices;
  for (const Value& choice : attribute.choices) choices.push_back(ConstantText(choice));
  if (!choices.empty()) texts.push_back(fmt::format("@Enum({})", fmt::join(choices, ", ")));
  return texts.empty() ? "" : fmt::format("{}\n", fmt::join(texts, " "));
}

std::string ImportText(const RuleSet& rules, const RuleImport& import) {
  std::string text = "import " + import.prefix;
  if (!import.style.empty()) text += fmt::format(" ({})", import.style);
  text += " : " + QuotedText(import.path);
  std::vector<std::string> attributes;
  for (const auto& [name, value] : import.attributes) {
    attributes.push_back(value ? name + " = " + ExpressionText(rules, {}, *value, Place::kOperand)
                               : name);
  }
  if (import.protects) return text + " ()\n";
  return text + (attributes.empty() ? "" : fmt::format(" ({})", fmt::join(attributes, ", "))) +
         "\n";
}

std::string AttributeText(const RuleSet& rules, const Attribute& attribute) {
  return fmt::format("{}{} {} = {}\n", AnnotationsText(attribute),
                     attribute.constant ? "const" : "attr", attribute.name,
                     TextOf(rules, attribute.value));
}

std::string FunctionText(const RuleSet& rules, const RuleFunction& function) {
  return fmt::format("{}{} = {}\n", function.name, ParametersText(function.parameters),
                     TextOf(rules, function.value, function.parameters));
}

std::string RuleText(const RuleSet& rules, const Rule& rule) {
  const std::string head = rule.symbol + ParametersText(rule.parameters) + " -->";
  const std::string body = BodyText(rules, rule, head.size() + 1, 2);
  const bool is_broken = body.find('\n') != std::string::npos;
  const std::string_view between = body.empty() || body[0] == '\n' ? "" : is_broken ? "\n  " : " ";
  return fmt::format("{}{}{}{}\n", rule.start ? "@StartRule\n" : "", head, between, body);
}

/// Declarations of the first file, a group of a kind behind an empty line.
template <typename T, typename Print>
void PrintGroup(const std::vector<T>& list, const Print& print, std::string* text) {
  std::string group;
  for (const T& one : list) {
    if (one.range.file == 0) group += print(one);
  }
  if (!text->empty() && !group.empty()) *text += "\n";
  *text += group;
}

}  // namespace

std::string TextOf(const RuleSet& rules) {
  std::string text;
  if (!rules.version.empty()) text += fmt::format("version {}\n", QuotedText(rules.version));
  for (const RuleImport& import : rules.imports) text += ImportText(rules, import);
  PrintGroup(
      rules.attributes, [&](const auto& one) { return AttributeText(rules, one); }, &text);
  PrintGroup(
      rules.functions, [&](const auto& one) { return FunctionText(rules, one); }, &text);
  PrintGroup(
      rules.rules, [&](const auto& one) { return RuleText(rules, one); }, &text);
  for (const RuleStyle& style : rules.styles) {
    text += fmt::format("\nstyle {} extends {}\n{}\n", style.name, style.base, style.text);
  }
  if (!rules.trees.empty()) text += (text.empty() ? "" : "\n") + TextOf(rules.trees);
  return text;
}

}  // namespace parti::grammar
