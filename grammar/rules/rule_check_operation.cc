// Operations of rules against their row of the table: arguments, sizes, selectors, names.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "grammar/lexer.h"
#include "grammar/operations/split_sizes.h"
#include "grammar/part_number.h"
#include "grammar/rules/built_ins.h"
#include "grammar/rules/rule_checker.h"
#include "grammar/texture_extent.h"

namespace parti::grammar {
namespace {

using Kind = ParameterKind;

constexpr std::string_view kExtrude = "extrude", kExtrudeAlong = "extrudeAlong";
constexpr double kLargestSize_m = 1e9;
constexpr double kLargestIndex = 1e6;

/// A bare name or a text: an axis, a word, a selector.
const std::string* WordOf(const WrittenArgument& written) {
  const WrittenExpression& value = written.value;
  if (written.size != Size::Kind::kAbsolute) return nullptr;
  if (value.kind == WrittenExpression::Kind::kName) return &value.name;
  if (value.kind != WrittenExpression::Kind::kConstant) return nullptr;
  return std::get_if<std::string>(&value.constant);
}

/// "x", and as the thesis writes it "X" (Listing 4.3).
std::string AxisOf(std::string word) {
  if (word == "X" || word == "Y" || word == "Z") word[0] = static_cast<char>(word[0] + 'x' - 'X');
  return word == "x" || word == "y" || word == "z" ? word : "";
}

/// The word of the parameter that is written so; "" for none. The thesis writes comp(face, side).
std::string WordFor(const Parameter& parameter, std::string_view written) {
  for (const std::string_view word : parameter.words) {
    const bool is_face = word == "f" && (written == "face" || written == "faces");
    if (word == written || is_face) return std::string(word);
  }
  return "";
}

/// "object.front" is "world.south": a lot's axes are the world's.
std::string_view InWorld(std::string_view selector) {
  constexpr std::array<std::array<std::string_view, 2>, 7> kSame = {{
      {"object.front", "world.south"},
      {"object.back", "world.north"},
      {"object.left", "world.west"},
      {"object.right", "world.east"},
      {"object.top", "world.up"},
      {"object.bottom", "world.down"},
      {"object.side", "world.side"},
  }};
  for (const auto& [object, world] : kSame) {
    if (object == selector) return world;
  }
  return selector;
}

Expression Constant(Value value, TextRange range) {
  Expression expression;
  expression.type = TypeOf(value);
  expression.constant = std::move(value);
  expression.range = range;
  return expression;
}

RuleArgument DefaultOf(const Parameter& parameter, TextRange range) {
  const Argument& argument = parameter.default_value;
  if (const Axis* axis = std::get_if<Axis>(&argument)) {
    return {Constant(std::string(NameOf(*axis)), range)};
  }
  if (const Size* size = std::get_if<Size>(&argument)) {
    return {Constant(size->value, range), size->kind};
  }
  if (const bool* yes = std::get_if<bool>(&argument)) return {Constant(*yes, range)};
  if (const double* number = std::get_if<double>(&argument)) return {Constant(*number, range)};
  return {Constant(std::get<std::string>(argument), range)};
}

MaybeType TypeFor(Kind kind) {
  switch (kind) {
    case Kind::kLength:
    case Kind::kAngle:
    case Kind::kFactor:
    case Kind::kSize:
      return ValueType::kNumber;
    case Kind::kBool:
      return ValueType::kBool;
    case Kind::kValue:
      return std::nullopt;
    default:
      return ValueType::kText;
  }
}

Argument ArgumentFor(const RuleArgument& argument, Kind kind) {
  const Value& value = argument.value.constant;
  if (kind == Kind::kSize) return Size{argument.size, std::get<double>(value)};
  if (const double* number = std::get_if<double>(&value)) return *number;
  if (const bool* yes = std::get_if<bool>(&value)) return *yes;
  return std::get<std::string>(value);
}

/// "split(axis)"
std::string Usage(const Operation& row) {
  std::vector<std::string_view> names;
  for (const Parameter& parameter : row.parameters) names.push_back(parameter.name);
  return fmt::format("{}({})", Written(row), fmt::join(names, ", "));
}

/// split(u, unitSpace, 0) of shapes without coordinates of a street: u is the scope's x, v its y.
std::optional<WrittenStatement> WithoutUvs(const WrittenStatement& written) {
  const auto& arguments = written.arguments;
  const std::string* way = arguments.size() == 3 ? WordOf(arguments[0]) : nullptr;
  const std::string* space = way != nullptr ? WordOf(arguments[1]) : nullptr;
  const bool is_uv = space != nullptr && *space == "unitSpace" && written.name == kSplitName &&
                     (*way == "u" || *way == "v");
  if (!is_uv) return std::nullopt;
  WrittenStatement plain = written;
  plain.arguments.resize(1);
  plain.arguments[0].value.name = *way == "u" ? "x" : "y";
  return plain;
}

size_t LeavesOf(const std::vector<WrittenAlternative>& alternatives) {
  size_t leaves = 0;
  for (const WrittenAlternative& a : alternatives) leaves += a.group ? LeavesOf(a.repeat) : 1;
  return leaves;
}

}  // namespace

std::optional<Statement> RuleChecker::ResolveOperation(const WrittenStatement& written,
                                                       const Operation& found) {
  if (const auto plain = WithoutUvs(written)) return ResolveOperation(*plain, found);
  const bool repeats = written.repeated && found.name == kSplitName;
  const bool has_way = found.name == kExtrude && written.arguments.size() == 2 &&
                       WordOf(written.arguments[0]) != nullptr;
  const Operation& row = repeats   ? *FindOperation(kRepeatName)
                         : has_way ? *FindOperation(kExtrudeAlong)
                                   : found;
  Statement statement;
  statement.operation = &row;
  statement.range = written.range;
  size_t used = 0;
  const bool good = Bind(written, &statement, &used) && RefuseExtra(written, row, used) &&
                    CheckBraces(written, found);
  if (!good) {
    for (const WrittenAlternative& alternative : written.alternatives) CheckParts(alternative);
    return std::nullopt;
  }
  Keys keys{&written.arguments, used, used, !written.broken};
  statement.successors = Resolve(written.alternatives, row, &keys, 0);
  if (written.repeated && !repeats) {
    SuccessorRule group;
    group.repeat = std::move(statement.successors);
    group.range = written.range;
    statement.successors = {std::move(group)};
  }
  return statement;
}

bool RuleChecker::Bind(const WrittenStatement& written, Statement* statement, size_t* used) {
  const Operation& row = *statement->operation;
  for (const Parameter& parameter : row.parameters) {
    const WrittenArgument* next =
        *used < written.arguments.size() ? &written.arguments[*used] : nullptr;
    auto argument = next != nullptr ? Argue(*next, row, parameter) : std::nullopt;
    if (argument) {
      ++*used;
    } else if (!parameter.required) {
      argument = DefaultOf(parameter, written.range);
    } else {
      Report(next != nullptr ? next->range : written.range, ErrorCode::kBadArguments,
             next != nullptr ? fmt::format("expected {} for the {} of {}", Wanted(parameter.kind),
                                           parameter.name, row.name)
                             : fmt::format("{} lacks its {}", row.name, parameter.name),
             fmt::format("write {}", Usage(row)));
      return false;
    }
    statement->arguments.push_back(std::move(*argument));
  }
  return true;
}

std::optional<RuleArgument> RuleChecker::Argue(const WrittenArgument& written, const Operation& row,
                                               const Parameter& parameter) {
  if (parameter.kind == Kind::kAxis || parameter.kind == Kind::kWord) {
    const std::string* word = WordOf(written);
    std::string meant = word == nullptr                 ? ""
                        : parameter.kind == Kind::kAxis ? AxisOf(*word)
                                                        : WordFor(parameter, *word);
    if (meant.empty()) return ArgueNumber(written, row, parameter);
    return RuleArgument{Constant(std::move(meant), written.range)};
  }
  const bool may_be_left_out = parameter.kind == Kind::kColor && !parameter.required;
  if (may_be_left_out && IsNumber(written)) return std::nullopt;
  const bool is_part = parameter.kind == Kind::kSize &&
                       (written.size == Size::Kind::kRelative || TakesFloating(parameter));
  if (written.size != Size::Kind::kAbsolute && !is_part) return std::nullopt;
  RuleArgument argument{Resolve(written.value, {TypeFor(parameter.kind), parameter.name, row.name}),
                        written.size};
  CheckConstant(written, row, parameter, argument);
  return argument;
}

std::optional<RuleArgument> RuleChecker::ArgueNumber(const WrittenArgument& written,
                                                     const Operation& row,
                                                     const Parameter& parameter) {
  const bool is_plain = written.size == Size::Kind::kAbsolute;
  if (!is_plain || !TakesNumbers(parameter.words) || !IsNumber(written)) return std::nullopt;
  Expression number = Resolve(written.value, {ValueType::kNumber, parameter.name, row.name});
  if (number.kind == Expression::Kind::kConstant) {
    RuleArgument argument{Constant(NumberText(std::get<double>(number.constant)), written.range)};
    CheckConstant(written, row, parameter, argument);
    return argument;
  }
  Expression text;
  text.kind = Expression::Kind::kBuiltIn;
  text.type = ValueType::kText;
  text.built_in = FindBuiltIn("str", 1);
  text.range = written.range;
  text.operands.push_back(std::move(number));
  return RuleArgument{std::move(text)};
}

bool RuleChecker::IsNumber(const WrittenArgument& written) {
  const bool reported = std::exchange(reporting_, false);
  MaybeType type;
  Resolve(written.value, {{}, "argument"}, &type);
  reporting_ = reported;
  return type == ValueType::kNumber;
}

void RuleChecker::CheckConstant(const WrittenArgument& written, const Operation& row,
                                const Parameter& parameter, const RuleArgument& argument) {
  if (!reporting_ || argument.value.kind != Expression::Kind::kConstant) return;
  if (TypeOf(argument.value.constant) != TypeFor(parameter.kind)) return;  // reported as such
  const auto checked = CheckArgument(row, parameter, ArgumentFor(argument, parameter.kind));
  if (!checked) Report(written.range, checked.error());
}

bool RuleChecker::RefuseExtra(const WrittenStatement& written, const Operation& row, size_t used) {
  if (used == written.arguments.size() || row.braces != Braces::kNone) return true;
  const size_t takes = row.parameters.size();
  Report(written.arguments[used].range, ErrorCode::kBadArguments,
         fmt::format("{} takes {} argument{}, got {}", row.name, takes, takes == 1 ? "" : "s",
                     written.arguments.size()),
         fmt::format("write {}", Usage(row)));
  return false;
}

bool RuleChecker::CheckBraces(const WrittenStatement& written, const Operation& row) {
  const bool wanted = row.braces != Braces::kNone;
  std::string message;
  std::string hint;
  if (wanted && (written.alternatives.empty() && !written.broken)) {
    message = fmt::format("{} needs alternatives in braces", row.name);
    hint = row.braces == Braces::kSizes ? "{ 3: Door | ~1: Wall }" : "{ side: Facade | top: Roof }";
  } else if (!wanted && written.braces) {
    message = fmt::format("{} takes no alternatives in braces", row.name);
  } else if (row.name == kRepeatName) {
    message = "repeat is written as a split";
    hint = "split(y) { ~3: Floor }*";
  } else if (written.repeated && row.braces != Braces::kSizes) {
    message = fmt::format("{} can't be repeated", row.name);
    hint = "only sizes are";
  }
  if (message.empty()) return true;
  Report(written.range, ErrorCode::kBadArguments, std::move(message), std::move(hint));
  return false;
}

std::vector<SuccessorRule> RuleChecker::Resolve(const std::vector<WrittenAlternative>& written,
                                                const Operation& row, Keys* keys, int depth) {
  std::vector<SuccessorRule> successors;
  const size_t leaves = depth == 0 ? LeavesOf(written) : 0;
  const size_t given = keys->list->size() - keys->next;
  if (depth == 0 && given > 0 && given != leaves && keys->complete) {
    Report((*keys->list)[keys->next].range, ErrorCode::kBadArguments,
           fmt::format("{} has {} alternatives in braces for {} in parentheses", row.name, leaves,
                       given));
  }
  for (const WrittenAlternative& alternative : written) {
    SuccessorRule& successor = successors.emplace_back();
    successor.range = alternative.range;
    if (!alternative.group) {
      SetKey(alternative, row, keys, &successor);
      successor.body = Resolve(alternative.body);
    } else if (row.braces != Braces::kSizes || depth >= kDeepestRepeat) {
      Report(alternative.range, ErrorCode::kBadArguments,
             depth < kDeepestRepeat
                 ? fmt::format("{} has no groups that repeat", row.name)
                 : fmt::format("repeat groups more than {} deep", kDeepestRepeat));
      CheckParts(alternative);
    } else if (alternative.repeat.empty()) {
      Report(alternative.range, ErrorCode::kBadArguments, "this group has nothing to repeat");
    } else {
      successor.repeat = Resolve(alternative.repeat, row, keys, depth + 1);
    }
  }
  return successors;
}

void RuleChecker::SetKey(const WrittenAlternative& written, const Operation& row, Keys* keys,
                         SuccessorRule* successor) {
  const WrittenArgument* key = written.key.empty() ? nullptr : &written.key[0];
  if (keys->given()) {
    if (key != nullptr) {
      Report(key->range, ErrorCode::kBadArguments,
             fmt::format("{} has this in parentheses already", row.name),
             "sizes and selectors stand in the parentheses or in the braces");
      return;
    }
    if (keys->next >= keys->list->size()) return;  // the wrong number of them has been reported
    key = &(*keys->list)[keys->next++];
  }
  if (key == nullptr) {
    RefuseKeyless(written, row);
  } else if (row.braces == Braces::kSizes) {
    SetSize(*key, successor);
  } else if (row.braces == Braces::kSelectors) {
    SetSelector(*key, row, successor);
  } else if (const std::string* name = WordOf(*key)) {
    successor->key = *name;
  } else {
    Report(key->range, ErrorCode::kBadArguments, fmt::format("{} takes names in quotes", row.name));
  }
}

void RuleChecker::RefuseKeyless(const WrittenAlternative& written, const Operation& row) {
  const bool sizes = row.braces == Braces::kSizes;
  const bool names = row.braces == Braces::kNames;
  Report(written.range, ErrorCode::kBadArguments,
         fmt::format("{}: an alternative without a {}", row.name,
                     sizes   ? "size"
                     : names ? "name"
                             : "selector"),
         sizes   ? "write size: Symbol, as in 3: Door or ~1: Wall"
         : names ? fmt::format("write {}(\"name\", …) {{ Symbol | … }}", row.name)
                 : "write selector: Symbol, as in side: Facade");
}

void RuleChecker::SetSize(const WrittenArgument& key, SuccessorRule* successor) {
  Size size{key.size, 1};
  successor->size = Resolve(key.value, {ValueType::kNumber, "size"});
  const Expression& value = *successor->size;
  if (value.kind == Expression::Kind::kConstant) {
    const double* number = std::get_if<double>(&value.constant);
    size.value = number != nullptr ? *number : 0;
    if (!(std::abs(size.value) <= kLargestSize_m)) {
      Report(key.range, ErrorCode::kBadNumber, fmt::format("a size is {:.6g}", size.value),
             fmt::format("give a number up to {:.0g}", kLargestSize_m));
    }
  }
  successor->key = size;
}

void RuleChecker::SetSelector(const WrittenArgument& key, const Operation& row,
                              SuccessorRule* successor) {
  const auto knows = [&](Selector::Kind kind) {
    return std::find(row.selectors.begin(), row.selectors.end(), kind) != row.selectors.end();
  };
  const bool has_index = knows(Selector::Kind::kIndex);
  const double* number = key.value.kind == WrittenExpression::Kind::kConstant
                             ? std::get_if<double>(&key.value.constant)
                             : nullptr;
  if (number != nullptr && has_index && key.size == Size::Kind::kAbsolute) {
    if (*number >= 0 && *number <= kLargestIndex && *number == std::floor(*number)) {
      successor->key = Selector{Selector::Kind::kIndex, static_cast<int>(*number)};
      return;
    }
    Report(key.range, ErrorCode::kBadNumber, "the number of a part is a whole number from 0");
    return;
  }
  const std::string* word = WordOf(key);
  const auto kind = word != nullptr ? SelectorNamed(InWorld(*word)) : std::nullopt;
  if (kind && knows(*kind)) {
    successor->key = Selector{*kind};
    return;
  }
  if (!reporting_ || errors_->Full()) return;
  std::vector<std::string> names;
  for (const Selector::Kind known : row.selectors) {
    if (known != Selector::Kind::kIndex) names.emplace_back(NameOf(known));
  }
  const auto meant = word != nullptr ? DidYouMean(*word, names) : std::nullopt;
  Report(key.range, ErrorCode::kUnknownName,
         word != nullptr ? fmt::format("{} has no selector '{}'", row.name, *word)
                         : fmt::format("expected a selector of {}", row.name),
         meant ? fmt::format("did you mean '{}'?", *meant)
               : fmt::format("selectors are {}", fmt::join(names, ", ")));
}

}  // namespace parti::grammar
