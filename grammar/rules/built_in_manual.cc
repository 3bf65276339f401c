#include "grammar/rules/built_in_manual.h"

#include <fmt/format.h>

#include <vector>

#include "grammar/rules/built_ins.h"

namespace parti::grammar {
namespace {

/// "atan2(number, number)", "scope.sx", "rand()".
std::string FormText(const BuiltIn& row) {
  const bool is_name = row.operands.empty() && row.name != "rand";
  if (is_name) return std::string(row.name);
  std::vector<std::string_view> types;
  for (const auto& type : row.operands) types.push_back(type ? NameOf(*type) : "any");
  return fmt::format("{}({})", row.name, fmt::join(types, ", "));
}

}  // namespace

std::string FunctionsManual() {
  std::string text =
      "# Functions\n\nWritten from the table of built-in functions by the tests; "
      "[language.md](language.md) says how values are written. Angles are degrees, lengths "
      "metres.\n\n| function | gives | what |\n| --- | --- | --- |\n";
  for (const BuiltIn& row : BuiltIns()) {
    text += fmt::format("| `{}` | {} | {} |\n", FormText(row),
                        row.prints ? "the same" : NameOf(row.result), row.doc);
  }
  return text;
}

}  // namespace parti::grammar
