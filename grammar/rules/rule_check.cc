// Declarations of rules: which hold, what their names are, and the walks over them.
#include "grammar/rules/rule_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "grammar/rules/rule_checker.h"
#include "grammar/rules/rule_cycles.h"

namespace parti::grammar {
namespace {

using Kind = WrittenDeclaration::Kind;

/// Names that are held against each other at most, to find what is misspelt.
constexpr size_t kMostComparisons = 200'000;

bool IsValue(Kind kind) { return kind == Kind::kAttribute || kind == Kind::kConstant; }

const WrittenImport::Attribute* ImportedAs(const WrittenImport& import, std::string_view name) {
  for (const WrittenImport::Attribute& attribute : import.attributes) {
    if (attribute.name == name) return &attribute;
  }
  return nullptr;
}

/// Floor and Floors are two things that rules often have.
bool IsPlural(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  return b.size() == a.size() + 1 && b.starts_with(a) && b.ends_with('s') && !a.ends_with('s');
}

/// The names differ in nothing but a number: Window1 and Window2.
bool IsNumbered(std::string_view a, std::string_view b) {
  const auto stem = [](std::string_view name) {
    while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) != 0) {
      name.remove_suffix(1);
    }
    return name;
  };
  return stem(a) == stem(b);
}

}  // namespace

RuleChecker::RuleChecker(const std::deque<RuleModule>& modules, std::string_view style,
                         RuleErrors* errors)
    : modules_(modules), style_(style), errors_(errors) {}

RuleSet RuleChecker::Check() {
  for (const RuleModule& module : modules_) {
    Declare(module, module.import != nullptr ? std::string_view(module.import->style) : style_);
  }
  for (const bool from_calls : {false, true}) {
    learns_from_calls_ = from_calls;
    changed_ = true;
    for (int pass = 0; pass < kMostPasses && changed_; ++pass) {
      changed_ = false;
      Pass();
    }
  }
  reporting_ = true;
  Pass();
  for (const RuleModule& module : modules_) CheckImport(module);
  CheckTerminals();
  CheckCycles();
  return std::move(set_);
}

void RuleChecker::Declare(const RuleModule& module, std::string_view style) {
  for (const WrittenDeclaration* written : DeclarationsIn(module.rules, style)) {
    Declare(module, *written);
  }
}

void RuleChecker::Declare(const RuleModule& module, const WrittenDeclaration& written) {
  Declared declared{&module, &written, std::vector<MaybeType>(written.parameters.size()), {}};
  const std::string name = module.prefix + written.name;
  const size_t count = written.parameters.size();
  auto& list = IsValue(written.kind)             ? attributes_
               : written.kind == Kind::kFunction ? functions_
                                                 : rules_;
  const auto index = static_cast<uint32_t>(list.size());
  bool is_new = false;
  if (IsValue(written.kind)) {
    is_new = names_.Function(name, 0) == RuleNames::kNone && names_.AddAttribute(name, index);
  } else if (written.kind == Kind::kFunction) {
    const bool is_free = count > 0 || names_.Attribute(name) == RuleNames::kNone;
    is_new = is_free && names_.AddFunction(name, count, index);
  } else {
    is_new = names_.AddRule(name, count, index);
  }
  if (!is_new) {
    errors_->Report(written.range, ErrorCode::kBadText,
                    fmt::format("'{}' is declared twice", written.name),
                    "rules and functions of one name differ in how many parameters they have");
    return;
  }
  if (written.kind == Kind::kRule && FindOperation(written.name) != nullptr) {
    errors_->Report(written.range, ErrorCode::kBadText,
                    fmt::format("'{}' is an operation, and no name for a rule", written.name));
  }
  list.push_back(std::move(declared));
}

void RuleChecker::Pass() {
  set_ = RuleSet();
  set_.attributes.resize(attributes_.size());
  set_.functions.resize(functions_.size());
  set_.rules.resize(rules_.size());
  for (size_t i = 0; i < attributes_.size(); ++i) {
    CheckAttribute(&attributes_[i], &set_.attributes[i]);
  }
  for (size_t i = 0; i < functions_.size(); ++i) CheckFunction(&functions_[i], &set_.functions[i]);
  for (size_t i = 0; i < rules_.size(); ++i) CheckRule(&rules_[i], &set_.rules[i]);
}

void RuleChecker::CheckAttribute(Declared* declared, Attribute* attribute) {
  module_ = declared->module;
  inside_ = nullptr;
  attribute->name = FullName(declared->written->name);
  attribute->range = declared->written->range;
  attribute->constant = declared->written->kind == Kind::kConstant;
  MaybeType type;
  if (declared->written->broken) return;
  Expression own = Resolve(declared->written->value, {{}, "value"}, &type);
  Set(&declared->type, type);
  if (!ImportedValue(*declared, &attribute->value)) attribute->value = std::move(own);
  module_ = declared->module;
  if (reporting_) Annotate(*declared, attribute);
}

bool RuleChecker::ImportedValue(const Declared& declared, Expression* value) {
  const RuleModule& module = *declared.module;
  if (module.importer == nullptr || declared.written->kind == Kind::kConstant) return false;
  module_ = module.importer;
  const std::string& name = declared.written->name;
  if (const auto* given = ImportedAs(*module.import, name)) {
    if (given->value.empty()) return false;
    *value = Resolve(given->value[0], {declared.type, "value", name});
    return true;
  }
  const uint32_t outer = names_.Attribute(FullName(name));
  if (module.import->protects || outer == RuleNames::kNone) return false;
  // An attribute of the same name and of another type is another matter.
  if (attributes_[outer].type != declared.type) return false;
  value->kind = Expression::Kind::kAttribute;
  value->index = outer;
  value->type = declared.type.value_or(ValueType::kNumber);
  value->range = module.import->range;
  return true;
}

void RuleChecker::CheckImport(const RuleModule& module) {
  if (module.import == nullptr) return;
  for (const WrittenImport::Attribute& attribute : module.import->attributes) {
    const std::string name = module.prefix + attribute.name;
    if (names_.Attribute(name) != RuleNames::kNone) continue;
    if (errors_->Full()) return;
    const auto meant = DidYouMean(attribute.name, names_.Values(module.prefix));
    Report(attribute.range, ErrorCode::kUnknownName,
           fmt::format("'{}' has no attribute '{}'", module.import->path, attribute.name),
           meant ? fmt::format("did you mean '{}'?", *meant) : "");
  }
}

std::vector<RuleParameter> RuleChecker::ParametersOf(const Declared& declared) const {
  std::vector<RuleParameter> parameters;
  for (size_t i = 0; i < declared.parameters.size(); ++i) {
    parameters.push_back({declared.written->parameters[i].name,
                          declared.parameters[i].value_or(ValueType::kNumber)});
  }
  return parameters;
}

void RuleChecker::CheckFunction(Declared* declared, RuleFunction* function) {
  module_ = declared->module;
  inside_ = declared;
  function->name = FullName(declared->written->name);
  function->range = declared->written->range;
  MaybeType type;
  if (!declared->written->broken) {
    function->value = Resolve(declared->written->value, {declared->type, "value"}, &type);
  }
  Set(&declared->type, type);
  function->parameters = ParametersOf(*declared);
  if (reporting_) CheckAnnotations(*declared->written);
}

void RuleChecker::CheckRule(Declared* declared, Rule* rule) {
  module_ = declared->module;
  inside_ = declared;
  rule->symbol = FullName(declared->written->name);
  rule->range = declared->written->range;
  rule->body = Resolve(declared->written->body);
  rule->parameters = ParametersOf(*declared);
  for (const WrittenAnnotation& annotation : declared->written->annotations) {
    rule->start = rule->start || annotation.name == "StartRule";
  }
  if (reporting_) CheckAnnotations(*declared->written);
}

void RuleChecker::CheckTerminals() {
  // The first of the rules that nothing refers to is where a derivation usually starts.
  bool is_first = true;
  std::vector<std::string> unused;
  for (size_t i = 0; i < rules_.size(); ++i) {
    if (rules_[i].is_named || set_.rules[i].start) continue;
    if (!is_first) unused.push_back(set_.rules[i].symbol);
    is_first = false;
  }
  if (unused.size() * terminals_.size() > kMostComparisons) return;
  for (const auto& [name, terminal] : terminals_) {
    std::vector<std::string> near;
    for (const std::string& symbol : unused) {
      const bool is_other = IsPlural(name, symbol) || IsNumbered(name, symbol);
      if (!is_other && symbol.starts_with(terminal.prefix)) {
        near.push_back(symbol.substr(terminal.prefix.size()));
      }
    }
    const auto meant = DidYouMean(name, near);
    if (!meant) continue;
    // It may be meant, above all where what was skipped used the rule.
    ReportUnknown(terminal.range, fmt::format("rule '{}'", name),
                  fmt::format("did you mean '{}'? No rule uses it", *meant),
                  /*can_be_skipped=*/true);
  }
}

void RuleChecker::CheckCycles() {
  for (const uint32_t index : AttributesThatNeedThemselves(set_)) {
    Report(set_.attributes[index].range, ErrorCode::kBadText,
           fmt::format("the value of '{}' depends on itself", set_.attributes[index].name));
  }
}

bool RuleChecker::IsLost(std::string_view name) const {
  return std::any_of(module_->lost.begin(), module_->lost.end(),
                     [&](const std::string& prefix) { return name.starts_with(prefix); });
}

void RuleChecker::Report(TextRange range, ErrorCode code, std::string message, std::string hint) {
  if (reporting_) errors_->Report(range, code, std::move(message), std::move(hint));
}

void RuleChecker::Report(TextRange range, Error error) {
  if (reporting_) errors_->Report(range, std::move(error));
}

void RuleChecker::ReportUnknown(TextRange range, const std::string& what, std::string hint,
                                bool can_be_skipped) {
  if (reporting_) errors_->ReportUnknown(range, what, std::move(hint), can_be_skipped);
}

RuleSet CheckRules(const std::deque<RuleModule>& modules, std::string_view style,
                   RuleErrors* errors) {
  return RuleChecker(modules, style, errors).Check();
}

}  // namespace parti::grammar
