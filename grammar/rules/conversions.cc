#include "grammar/rules/conversions.h"

#include <algorithm>
#include <charconv>

#include "grammar/lexer.h"

namespace parti::grammar {

std::string TextOf(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  return NumberText(std::get<double>(value));
}

double NumberOf(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? 1 : 0;
  const auto& text = std::get<std::string>(value);
  const size_t from = std::min(text.find_first_not_of(" \t+"), text.size());
  double number = 0;
  const auto read = std::from_chars(text.data() + from, text.data() + text.size(), number);
  return read.ec == std::errc() ? number : 0;
}

bool TruthOf(const Value& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth;
  if (const auto* number = std::get_if<double>(&value)) return *number != 0;
  const auto& text = std::get<std::string>(value);
  return !text.empty() && text != "false";
}

}  // namespace parti::grammar
