#include "grammar/rules/built_ins.h"

#include <algorithm>

#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar {
namespace {

std::vector<BuiltIn> Sorted() {
  std::vector<BuiltIn> rows;
  for (const auto part :
       {built_ins::Maths(), built_ins::Chance(), built_ins::Conversions(), built_ins::Texts(),
        built_ins::Lists(), built_ins::Places(), built_ins::Geometries(), built_ins::Colors(),
        built_ins::Faces(), built_ins::Paints(), built_ins::Paths()}) {
    rows.insert(rows.end(), part.begin(), part.end());
  }
  std::sort(rows.begin(), rows.end(), [](const BuiltIn& a, const BuiltIn& b) {
    return a.name != b.name ? a.name < b.name : a.operands.size() < b.operands.size();
  });
  return rows;
}

}  // namespace

std::span<const BuiltIn> BuiltIns() {
  static const std::vector<BuiltIn> rows = Sorted();
  return rows;
}

const BuiltIn* FindBuiltIn(std::string_view name, size_t operands) {
  for (const BuiltIn& row : BuiltIns()) {
    if (row.name == name && row.operands.size() == operands) return &row;
  }
  return nullptr;
}

}  // namespace parti::grammar
