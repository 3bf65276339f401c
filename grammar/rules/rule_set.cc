#include "grammar/rules/rule_set.h"

#include <algorithm>
#include <tuple>

#include "grammar/rules/built_ins.h"

namespace parti::grammar {
namespace {

/// A body's alternatives are shared; what they hold counts.
bool SameBody(const std::shared_ptr<const Body>& a, const std::shared_ptr<const Body>& b) {
  return a == b || (a != nullptr && b != nullptr && *a == *b);
}

bool SameAlternative(const Body::Alternative& a, const Body::Alternative& b) {
  return a.condition == b.condition && SameBody(a.body, b.body);
}

}  // namespace

std::string_view NameOf(ValueType type) {
  switch (type) {
    case ValueType::kNumber:
      return "number";
    case ValueType::kBool:
      return "boolean";
    case ValueType::kText:
      break;
  }
  return "text";
}

bool operator==(const Expression& a, const Expression& b) {
  return std::tie(a.kind, a.type, a.constant, a.index, a.built_in, a.symbol, a.operands) ==
         std::tie(b.kind, b.type, b.constant, b.index, b.built_in, b.symbol, b.operands);
}

bool operator==(const Attribute& a, const Attribute& b) {
  const auto parts = [](const Attribute& x) {
    return std::tie(x.name, x.value, x.constant, x.group, x.order, x.low, x.high, x.step,
                    x.restricted, x.choices, x.description, x.use, x.hidden);
  };
  return parts(a) == parts(b);
}

bool operator==(const RuleParameter& a, const RuleParameter& b) {
  return a.name == b.name && a.type == b.type;
}

bool operator==(const RuleFunction& a, const RuleFunction& b) {
  return a.name == b.name && a.parameters == b.parameters && a.value == b.value;
}

bool operator==(const Body& a, const Body& b) {
  return a.kind == b.kind && a.statements == b.statements &&
         std::equal(a.alternatives.begin(), a.alternatives.end(), b.alternatives.begin(),
                    b.alternatives.end(), SameAlternative);
}

bool operator==(const SuccessorRule& a, const SuccessorRule& b) {
  return a.key == b.key && a.size == b.size && a.body == b.body && a.repeat == b.repeat;
}

bool operator==(const RuleArgument& a, const RuleArgument& b) {
  return a.size == b.size && a.value == b.value;
}

bool operator==(const Statement& a, const Statement& b) {
  const auto parts = [](const Statement& x) {
    return std::tie(x.kind, x.operation, x.arguments, x.successors, x.symbol, x.deferred, x.index);
  };
  return parts(a) == parts(b);
}

bool operator==(const Rule& a, const Rule& b) {
  return a.symbol == b.symbol && a.parameters == b.parameters && a.start == b.start &&
         a.body == b.body;
}

bool operator==(const RuleImport& a, const RuleImport& b) {
  return std::tie(a.prefix, a.path, a.style, a.attributes, a.protects) ==
         std::tie(b.prefix, b.path, b.style, b.attributes, b.protects);
}

bool operator==(const RuleStyle& a, const RuleStyle& b) {
  return a.name == b.name && a.base == b.base && a.text == b.text;
}

bool operator==(const RuleSet& a, const RuleSet& b) {
  const auto parts = [](const RuleSet& x) {
    return std::tie(x.version, x.imports, x.attributes, x.functions, x.rules, x.styles, x.trees);
  };
  return parts(a) == parts(b);
}

uint32_t RuleFor(const RuleSet& rules, std::string_view symbol) {
  const auto found = std::find_if(rules.rules.begin(), rules.rules.end(), [&](const Rule& rule) {
    return rule.parameters.empty() && rule.symbol == symbol;
  });
  return found == rules.rules.end() ? kNoRule : static_cast<uint32_t>(found - rules.rules.begin());
}

SourcePlace PlaceOf(const RuleSet& rules, const TextRange& range) {
  const RuleFile& file = rules.files.at(range.file);
  return PlaceIn(file.text, file.name, range.from,
                 range.to > range.from ? range.to - range.from : 1);
}

}  // namespace parti::grammar
