// What statements of bodies mean: a symbol, an operation, or something unknown.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "grammar/rules/plain_offset.h"
#include "grammar/rules/rule_checker.h"
#include "grammar/rules/scatter_body.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kSet = "set";
constexpr std::string_view kOffset = "offset";
constexpr auto kPush = Statement::Kind::kPush;
constexpr std::string_view kMaterial = "material.", kSetMaterial = "setMaterial";

/// Every operation of the table and every rule, for "did you mean".
std::vector<std::string> Callables(const RuleNames& names, std::string_view prefix) {
  std::vector<std::string> known = names.Rules(prefix);
  for (const Operation& row : Operations()) known.emplace_back(row.name);
  known.emplace_back(kSet);
  return known;
}

/// Whether an operation can do without its parentheses: reverseNormals, alignScopeToAxes.
bool MayStandAlone(const Operation& row) {
  return row.braces == Braces::kNone &&
         std::none_of(row.parameters.begin(), row.parameters.end(),
                      [](const Parameter& parameter) { return parameter.required; });
}

/// set(trim.vertical, false): that what is inserted is not cut off where faces meet. It never is.
bool SwitchesTrimOff(const WrittenStatement& set) {
  const std::string& name = set.arguments[0].value.name;
  const WrittenExpression& value = set.arguments[1].value;
  return (name == "trim.vertical" || name == "trim.horizontal") &&
         value.kind == WrittenExpression::Kind::kConstant && value.constant == Value(false);
}

bool EndsIn(const std::vector<Statement>& steps, Statement::Kind kind) {
  return !steps.empty() && steps.back().kind == kind;
}

/// Whether brackets that end here do without themselves: [ ], and [ offset(1) { … } ], which keeps
/// the shape at hand as it is. CityEngine, whose offset has no braces, needs those brackets.
bool AreNeedless(const std::vector<Statement>& steps) {
  if (EndsIn(steps, kPush)) return true;
  return steps.size() > 1 && EndsIn(steps, Statement::Kind::kOperation) &&
         steps[steps.size() - 2].kind == kPush && steps.back().operation->name == kOffset;
}

std::string Arguments(size_t count) {
  return fmt::format("{} argument{}", count, count == 1 ? "" : "s");
}

}  // namespace

Body RuleChecker::Resolve(const WrittenBody& written) {
  Body body;
  body.kind = written.kind;
  body.range = written.range;
  CheckBrackets(written.statements);
  const auto bracketed = WithScatterInBrackets(written.statements);
  const auto braced = WithBracedOffsets(bracketed ? *bracketed : written.statements);
  const auto& statements = braced ? *braced : bracketed ? *bracketed : written.statements;
  for (const WrittenStatement& statement : statements) {
    auto resolved = Resolve(statement);
    const bool is_pop = resolved && resolved->kind == Statement::Kind::kPop;
    if (is_pop && AreNeedless(body.statements)) {
      body.statements.erase(body.statements.end() - (EndsIn(body.statements, kPush) ? 1 : 2));
    } else if (resolved) {
      body.statements.push_back(std::move(*resolved));
    }
  }
  const Expected condition = body.kind == Body::Kind::kCase
                                 ? Expected{ValueType::kBool, "condition"}
                                 : Expected{ValueType::kNumber, "weight"};
  for (const WrittenBody::Alternative& alternative : written.alternatives) {
    Body::Alternative& added = body.alternatives.emplace_back();
    if (!alternative.condition.empty()) {
      added.condition = Resolve(alternative.condition[0], condition);
    }
    Body inner = alternative.body.empty() ? Body() : Resolve(alternative.body[0]);
    added.body = std::make_shared<const Body>(std::move(inner));
  }
  if (body.kind == Body::Kind::kChance) CheckWeights(&body);
  return body;
}

void RuleChecker::CheckBrackets(const std::vector<WrittenStatement>& statements) {
  std::vector<TextRange> open;
  for (const WrittenStatement& statement : statements) {
    if (statement.kind == WrittenStatement::Kind::kPush) open.push_back(statement.range);
    if (statement.kind != WrittenStatement::Kind::kPop) continue;
    if (open.empty()) {
      Report(statement.range, ErrorCode::kBadText, "']' closes nothing",
             "[ before it keeps the shape that ] goes back to");
    } else {
      open.pop_back();
    }
  }
  for (const TextRange& range : open) {
    Report(range, ErrorCode::kBadText, "'[' is never closed",
           "] goes back to the shape as it was, within the same braces");
  }
}

void RuleChecker::CheckWeights(Body* body) {
  std::vector<const Expression*> weights;
  for (const Body::Alternative& alternative : body->alternatives) {
    if (alternative.condition) weights.push_back(&*alternative.condition);
  }
  const bool has_else = weights.size() < body->alternatives.size();
  if (!CheckWeights(weights, has_else, body->range) || has_else) return;
  body->alternatives.back().condition.reset();
}

std::optional<Statement> RuleChecker::Resolve(const WrittenStatement& written) {
  Statement statement;
  statement.range = written.range;
  if (written.kind != WrittenStatement::Kind::kNamed) {
    statement.kind = written.kind == WrittenStatement::Kind::kPush ? Statement::Kind::kPush
                                                                   : Statement::Kind::kPop;
    return statement;
  }
  const bool plain = (!written.called && !written.braces) || written.ends;
  const std::string name = FullName(written.name);
  const bool is_rule = names_.Rule(name, written.arguments.size()) != RuleNames::kNone;
  const Operation* row = FindOperation(written.name);
  if (plain || is_rule || written.deferred) return ResolveSymbol(written);
  if (written.name == kSet) return ResolveSet(written);
  if (row != nullptr) return ResolveOperation(written, *row);
  CheckParts(written);
  if (const auto counts = names_.RulesNamed(name); !counts.empty()) {
    RefuseSymbol(written, counts);
  } else {
    RefuseUnknown(written);
  }
  return std::nullopt;
}

std::optional<Statement> RuleChecker::ResolveSymbol(const WrittenStatement& written) {
  Statement statement;
  statement.kind = Statement::Kind::kSymbol;
  statement.range = written.range;
  statement.deferred = written.deferred;
  statement.symbol = written.name;
  const std::string name = FullName(written.name);
  statement.index = written.ends ? kNoRule : names_.Rule(name, written.arguments.size());
  if (written.ends && !written.called && !written.braces) return statement;
  if (written.braces) {
    CheckParts(written);
    Report(written.range, ErrorCode::kBadText,
           fmt::format("{} is a symbol and has no braces", written.name));
    return std::nullopt;
  }
  if (statement.index != kNoRule) {
    Declared& rule = rules_[statement.index];
    if (inside_ != &rule) rule.is_named = true;
    statement.symbol = name;
    for (size_t i = 0; i < written.arguments.size(); ++i) {
      const WrittenArgument& argument = written.arguments[i];
      MaybeType got;
      Expression value =
          Resolve(argument.value,
                  {rule.parameters[i], rule.written->parameters[i].name, written.name}, &got);
      if (learns_from_calls_) Set(&rule.parameters[i], got);
      if (argument.size != Size::Kind::kAbsolute) {
        Report(argument.range, ErrorCode::kBadArguments, "a rule takes plain values",
               "sizes as '0.5 and ~1 stand in operations");
      }
      statement.arguments.push_back({std::move(value)});
    }
    return statement;
  }
  const bool is_nil = written.name == kNil;
  if (is_nil && !written.called && !written.deferred) return statement;
  const std::vector<size_t> counts = names_.RulesNamed(name);
  const Operation* row = FindOperation(written.name);
  const bool is_dotted = written.name.find('.') != std::string::npos;
  if (counts.empty() && row != nullptr && !written.deferred && MayStandAlone(*row)) {
    return ResolveOperation(written, *row);
  }
  if (counts.empty() && row == nullptr && !written.called && !is_nil && !is_dotted) {
    if (reporting_) terminals_.try_emplace(written.name, Terminal{written.range, module_->prefix});
    return statement;
  }
  CheckParts(written);
  if (row != nullptr && !written.deferred) {
    Report(written.range, ErrorCode::kBadText, fmt::format("{} is an operation", written.name),
           fmt::format("write {}(…)", written.name));
  } else if (!counts.empty()) {
    RefuseSymbol(written, counts);
  } else {
    RefuseUnknown(written);
  }
  return std::nullopt;
}

void RuleChecker::RefuseSymbol(const WrittenStatement& written, const std::vector<size_t>& counts) {
  for (const size_t count : counts) {
    rules_[names_.Rule(FullName(written.name), count)].is_named = true;
  }
  Report(written.range, ErrorCode::kBadArguments,
         fmt::format("{} takes {}, got {}", written.name, Arguments(counts[0]),
                     written.arguments.size()));
}

void RuleChecker::RefuseUnknown(const WrittenStatement& written) {
  if (!reporting_ || IsLost(written.name)) return;
  const bool is_symbol = !written.called || written.deferred;
  const std::string what = fmt::format("operation '{}'", written.name);
  const bool is_told = is_symbol ? !errors_->Full() : errors_->WantsHint(what);
  const auto meant = is_told ? DidYouMean(written.name, Callables(names_, module_->prefix))
                             : std::optional<std::string>();
  const std::string hint = meant ? fmt::format("did you mean '{}'?", *meant) : "";
  if (!is_symbol) {
    constexpr std::string_view kList =
        "operations are listed in docs/operations.md; --skip-unknown leaves it out";
    ReportUnknown(written.range, what, meant ? hint : std::string(kList), /*can_be_skipped=*/true);
    return;
  }
  Report(written.range, ErrorCode::kUnknownName,
         written.name == kNil ? "there is no 'NIL' to defer"
                              : fmt::format("there is no rule '{}'", written.name),
         hint);
}

void RuleChecker::CheckParts(const WrittenStatement& written) {
  for (const WrittenArgument& argument : written.arguments) {
    // Of an unknown operation a bare name may be a word of its own: world.up, yUp.
    if (argument.value.kind != WrittenExpression::Kind::kName) {
      Resolve(argument.value, {{}, "argument", written.name});
    }
  }
  for (const WrittenAlternative& alternative : written.alternatives) CheckParts(alternative);
}

void RuleChecker::CheckParts(const WrittenAlternative& written) {
  Resolve(written.body);
  for (const WrittenAlternative& inner : written.repeat) CheckParts(inner);
}

/// set(material.opacity, 0.5) is setMaterial(opacity, 0.5), as far as that knows the property.
std::optional<Statement> RuleChecker::ResolveMaterial(const WrittenStatement& written) {
  const Operation& row = *FindOperation(kSetMaterial);
  WrittenStatement as_operation = written;
  std::string& property = as_operation.arguments[0].value.name;
  property.erase(0, kMaterial.size());
  const auto& words = row.parameters[0].words;
  if (std::find(words.begin(), words.end(), property) == words.end()) return std::nullopt;
  return ResolveOperation(as_operation, row);
}

std::optional<Statement> RuleChecker::ResolveSet(const WrittenStatement& written) {
  const auto& arguments = written.arguments;
  const bool is_named = arguments.size() == 2 && !written.braces &&
                        arguments[0].value.kind == WrittenExpression::Kind::kName;
  if (!is_named) {
    CheckParts(written);
    Report(written.range, ErrorCode::kBadArguments, "set takes an attribute and its value",
           "set(height, 3)");
    return std::nullopt;
  }
  const std::string& name = arguments[0].value.name;
  Statement statement;
  statement.kind = Statement::Kind::kSet;
  statement.range = written.range;
  statement.index = names_.Attribute(FullName(name));
  if (statement.index == RuleNames::kNone && name.starts_with(kMaterial)) {
    if (auto material = ResolveMaterial(written)) return material;
  }
  if (statement.index == RuleNames::kNone && SwitchesTrimOff(written)) return std::nullopt;
  if (statement.index == RuleNames::kNone) {
    CheckParts(written);
    const std::string what = fmt::format("attribute '{}' to set", name);
    const auto meant = reporting_ && errors_->WantsHint(what)
                           ? DidYouMean(name, names_.Values(module_->prefix))
                           : std::nullopt;
    ReportUnknown(arguments[0].range, what, meant ? fmt::format("did you mean '{}'?", *meant) : "",
                  /*can_be_skipped=*/name.find('.') != std::string::npos);
    return std::nullopt;
  }
  Declared& attribute = attributes_[statement.index];
  if (attribute.written->kind == WrittenDeclaration::Kind::kConstant) {
    Report(arguments[0].range, ErrorCode::kBadArguments,
           fmt::format("{} is a const and stays as it is", name), "declare it as attr");
  }
  statement.arguments.push_back(
      {Resolve(arguments[1].value, {attribute.type, "value", name}, nullptr)});
  return statement;
}

}  // namespace parti::grammar
