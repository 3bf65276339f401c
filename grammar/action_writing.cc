// Actions as rules write them: what action_text.cc reads.
#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "grammar/action_text.h"

namespace parti::grammar {
namespace {

std::string TextOf(const Argument& argument, ParameterKind kind) {
  if (const double* number = std::get_if<double>(&argument)) return NumberText(*number);
  if (const bool* yes = std::get_if<bool>(&argument)) return *yes ? "true" : "false";
  if (const Axis* axis = std::get_if<Axis>(&argument)) return std::string(NameOf(*axis));
  if (const Size* size = std::get_if<Size>(&argument)) return grammar::TextOf(*size);
  const std::string& text = std::get<std::string>(argument);
  // comp(f) is a word of the language; tag("x") is the user's.
  return kind == ParameterKind::kWord ? text : QuotedText(text);
}

std::string ArgumentsText(const Action& action) {
  const Operation& row = *action.operation;
  size_t count = std::min(action.arguments.size(), row.parameters.size());
  while (count > 0 && !row.parameters[count - 1].required &&
         row.parameters[count - 1].kind != ParameterKind::kColor &&
         action.arguments[count - 1] == row.parameters[count - 1].default_value) {
    --count;
  }
  std::vector<std::string> texts;
  for (size_t i = 0; i < count; ++i) {
    const Parameter& parameter = row.parameters[i];
    const bool is_color = parameter.kind == ParameterKind::kColor;  // in place of numbers
    const bool implied = !parameter.required &&
                         (is_color ? count > 1 : parameter.kind == ParameterKind::kWord) &&
                         action.arguments[i] == parameter.default_value;
    if (!implied) texts.push_back(TextOf(action.arguments[i], parameter.kind));
  }
  for (const Successor& successor : action.successors) {
    const auto* name = std::get_if<std::string>(&successor.key);
    if (name != nullptr) texts.push_back(QuotedText(*name));
  }
  return fmt::format("({})", fmt::join(texts, ", "));
}

std::string TextOf(const std::vector<Successor>& successors) {
  std::vector<std::string> texts;
  for (const Successor& successor : successors) texts.push_back(grammar::TextOf(successor));
  return texts.empty() ? "{ }" : fmt::format("{{ {} }}", fmt::join(texts, " | "));
}

}  // namespace

std::string TextOf(const Size& size) {
  const std::string_view mark = size.kind == Size::Kind::kFloating   ? "~"
                                : size.kind == Size::Kind::kRelative ? "'"
                                                                     : "";
  return fmt::format("{}{}", mark, NumberText(size.value));
}

std::string TextOf(const Selector& selector) {
  if (selector.kind == Selector::Kind::kIndex) return fmt::format("{}", selector.index);
  return std::string(NameOf(selector.kind));
}

std::string TextOf(const Successor& successor) {
  if (!successor.repeat.empty()) return TextOf(successor.repeat) + "*";
  std::string text;
  if (const Size* size = std::get_if<Size>(&successor.key)) text = TextOf(*size) + ":";
  if (const Selector* selector = std::get_if<Selector>(&successor.key)) {
    text = TextOf(*selector) + ":";
  }
  for (const Action& action : successor.actions) text += " " + TextOf(action);
  if (!successor.symbol.empty()) {
    text += (successor.deferred ? " @" : " ") + NameText(successor.symbol);
  }
  return text.starts_with(' ') ? text.substr(1) : text;
}

std::string TextOf(const Action& action) {
  CHECK(action.operation != nullptr, "an action of the table");
  const Operation& row = *action.operation;
  const bool repeat = row.name == kRepeatName;
  std::string text = std::string(repeat ? kSplitName : row.name) + ArgumentsText(action);
  const bool group = row.name == kSegmentName && action.successors.size() == 1 &&
                     !action.successors[0].repeat.empty();
  if (group) return text + " " + grammar::TextOf(action.successors[0]);
  if (row.braces != Braces::kNone) text += " " + TextOf(action.successors) + (repeat ? "*" : "");
  if (!action.symbol.empty()) text += " " + NameText(action.symbol);
  return text;
}

}  // namespace parti::grammar
