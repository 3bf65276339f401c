#include "grammar/operation_manual.h"

#include <fmt/format.h>

#include <vector>

#include "grammar/action_text.h"
#include "grammar/operation.h"

namespace parti::grammar {
namespace {

std::string TypesText(ItemTypes types) {
  std::vector<std::string_view> names;
  for (const ItemType type :
       {ItemType::kPlanar, ItemType::kVolume, ItemType::kLayer, ItemType::kShape2D}) {
    if ((types & Types(type)) != 0) names.push_back(NameOf(type));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string RangeText(const Parameter& p) {
  switch (p.kind) {
    case ParameterKind::kLength:
      return fmt::format("{:g} to {:g} m", p.low, p.high);
    case ParameterKind::kAngle:
      return fmt::format("{:g} to {:g} degrees", p.low, p.high);
    case ParameterKind::kFactor:
      return fmt::format("{:g} to {:g}", p.low, p.high);
    case ParameterKind::kAxis:
      return "x, y or z";
    case ParameterKind::kText:
      return p.words.empty() ? "text in quotes"
                             : fmt::format("\"{}\"", fmt::join(p.words, "\", \""));
    case ParameterKind::kColor:
      return "\"#rrggbb\"";
    case ParameterKind::kWord:
      return fmt::format("{}", fmt::join(p.words, ", "));
    case ParameterKind::kBool:
      return "true or false";
    case ParameterKind::kValue:
      return "a number, true or false, or a text";
    case ParameterKind::kSize:
      return fmt::format("{:g} to {:g} m, or a part as '0.5", p.low, p.high);
  }
  return "";
}

std::string DefaultText(const Parameter& parameter) {
  const Argument& argument = parameter.default_value;
  if (const double* number = std::get_if<double>(&argument)) {
    return *number < parameter.low ? "none" : fmt::format("{:g}", *number);
  }
  if (const Axis* axis = std::get_if<Axis>(&argument)) return std::string(NameOf(*axis));
  if (const auto* text = std::get_if<std::string>(&argument)) return *text;
  if (const Size* size = std::get_if<Size>(&argument)) return TextOf(*size);
  return std::get<bool>(argument) ? "true" : "false";
}

/// "split(axis) { size: Symbol | … }"
std::string FormText(const Operation& row) {
  std::vector<std::string_view> names;
  for (const Parameter& p : row.parameters) {
    names.push_back(p.kind == ParameterKind::kWord ? p.words.front() : p.name);
  }
  if (row.braces == Braces::kNames) names.emplace_back("\"name\", …");
  const bool repeats = row.name == kRepeatName;  // written as a split (language.md)
  std::string text = fmt::format("{}({})", repeats ? "split" : row.name, fmt::join(names, ", "));
  if (row.braces == Braces::kSizes) text += " { size: Symbol | … }";
  if (row.braces == Braces::kSelectors) text += " { selector: Symbol | … }";
  if (row.braces == Braces::kNames) text += " { Symbol | … }";
  if (row.braces == Braces::kNone && !row.in_place) text += " Symbol";
  return repeats ? text + "*" : text;
}

std::string SectionText(const Operation& row, const std::string& example) {
  std::string text = fmt::format("## {}\n\n`{}`\n\n{}\n\n", row.name, FormText(row), row.doc);
  if (!row.parameters.empty()) {
    text += "| argument | values | default | meaning |\n| --- | --- | --- | --- |\n";
  }
  for (const Parameter& p : row.parameters) {
    text += fmt::format("| {} | {} | {} | {} |\n", p.name, RangeText(p), DefaultText(p), p.doc);
  }
  if (!row.selectors.empty()) {
    std::vector<std::string_view> names;
    for (const Selector::Kind kind : row.selectors) {
      names.push_back(kind == Selector::Kind::kIndex ? "a number, from 0" : NameOf(kind));
    }
    text += fmt::format("\nSelectors: {}.\n", fmt::join(names, ", "));
  }
  text += row.in_place
              ? fmt::format("\nChanges a {} in place; makes no child.", TypesText(row.takes))
              : fmt::format("\nTakes {}; gives {}.", TypesText(row.takes), TypesText(row.gives));
  text += fmt::format(" In queries: `{}`. Source: {}.\n\n", row.word, row.source);
  return text + fmt::format("```cga\n{0}```\n\n![{1}](operations/{1}.png)\n\n", example, row.name);
}

}  // namespace

std::string OperationsManual(const std::function<std::string(std::string_view name)>& example) {
  std::string text =
      "# Operations\n\nWritten from the operation table by the tests; see [shapes.md](shapes.md) "
      "for scopes, sizes and offsets in full. The picture of an operation shows what its rules "
      "make of the lot in their first line.\n\n";
  for (const Operation& row : Operations()) text += SectionText(row, example(row.name));
  text.pop_back();
  return text;
}

}  // namespace parti::grammar
