// Actions against their row of the table (Check), and applying them (Apply).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "grammar/color_text.h"
#include "grammar/lexer.h"
#include "grammar/operation.h"
#include "grammar/operations/split_sizes.h"
#include "grammar/part_number.h"
#include "grammar/texture_extent.h"

namespace parti::grammar {
namespace {

constexpr double kLargestSize_m = 1e9;

std::string_view Name(const Action& action) { return action.operation->name; }

Result<void> CheckNumber(const Operation& row, const Parameter& parameter, double value) {
  if (std::isfinite(value) && value >= parameter.low && value <= parameter.high) return {};
  if (!parameter.required && parameter.default_value == Argument(value)) return {};
  return Fail(ErrorCode::kBadNumber,
              fmt::format("{}: {} is {}", row.name, parameter.name, RoundedText(value)),
              fmt::format("give a number from {:.6g} to {:.6g}", parameter.low, parameter.high));
}

/// Of relative sizes only that they are numbers: what they come to depends on the item.
Result<void> CheckSize(const Operation& row, const Parameter& parameter, const Size& size) {
  if (size.kind == Size::Kind::kAbsolute) return CheckNumber(row, parameter, size.value);
  const bool is_part = size.kind == Size::Kind::kRelative || TakesFloating(parameter);
  if (is_part && std::isfinite(size.value)) return {};
  return Fail(ErrorCode::kBadNumber,
              fmt::format("{}: {} is neither metres nor a part", row.name, parameter.name),
              "write 3 or '0.5");
}

Result<void> CheckText(const Operation& row, const Parameter& parameter, std::string_view text) {
  const auto fail = [&](std::string hint) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{}: {} is '{}'", row.name, parameter.name, text), std::move(hint));
  };
  if (parameter.kind == ParameterKind::kColor && !ColorFrom(text)) {
    const auto meant = ColorMeant(text);
    return fail(meant ? fmt::format("did you mean \"{}\"?", *meant)
                      : "give a color as \"#rrggbb\", or by its name in CSS");
  }
  const bool is_file =
      row.file >= 0 && row.parameters[static_cast<size_t>(row.file)].name == parameter.name;
  if (parameter.kind == ParameterKind::kText && text.empty() && !is_file) {
    return fail("give a name");
  }
  const std::span<const std::string_view> words = parameter.words;
  if (PartNumber(text) && TakesNumbers(words)) return {};
  if (!words.empty() && std::find(words.begin(), words.end(), text) == words.end()) {
    return fail(fmt::format("give {}", fmt::join(words, " or ")));
  }
  return {};
}

bool IsNumber(ParameterKind kind) {
  return kind == ParameterKind::kLength || kind == ParameterKind::kAngle ||
         kind == ParameterKind::kFactor;
}

bool IsText(ParameterKind kind) {
  return kind == ParameterKind::kText || kind == ParameterKind::kColor ||
         kind == ParameterKind::kWord;
}

Result<void> CheckArguments(const Action& action) {
  const size_t wanted = action.operation->parameters.size();
  if (action.arguments.size() != wanted) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{} takes {} argument{}, got {}", Name(action), wanted,
                            wanted == 1 ? "" : "s", action.arguments.size()));
  }
  for (size_t i = 0; i < wanted; ++i) {
    if (auto good =
            CheckArgument(*action.operation, action.operation->parameters[i], action.arguments[i]);
        !good) {
      return good;
    }
  }
  return {};
}

Result<void> CheckKey(const Action& action, const Successor& successor) {
  const Size* size = std::get_if<Size>(&successor.key);
  if (size == nullptr) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{}: a successor without a size", Name(action)),
                "write size: Symbol, as in 3: Door or ~1: Wall");
  }
  if (std::isfinite(size->value) && std::abs(size->value) <= kLargestSize_m) return {};
  return Fail(ErrorCode::kBadNumber,
              fmt::format("{}: a size is {}", Name(action), RoundedText(size->value)),
              fmt::format("give a number up to {:.0g}", kLargestSize_m));
}

Result<void> CheckSelector(const Action& action, const Successor& successor) {
  const auto& known = action.operation->selectors;
  std::vector<std::string_view> names;
  for (const Selector::Kind kind : known) {
    names.push_back(kind == Selector::Kind::kIndex ? "a face's number" : NameOf(kind));
  }
  const std::string hint = fmt::format("selectors are {}", fmt::join(names, ", "));
  const Selector* selector = std::get_if<Selector>(&successor.key);
  if (selector == nullptr || !successor.repeat.empty()) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{}: a successor without a selector", Name(action)), hint);
  }
  if (std::find(known.begin(), known.end(), selector->kind) == known.end()) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{} has no selector '{}'", Name(action), NameOf(selector->kind)), hint);
  }
  if (selector->kind == Selector::Kind::kIndex && selector->index < 0) {
    return Fail(ErrorCode::kBadNumber,
                fmt::format("{}: a face's number is {}", Name(action), selector->index),
                "faces count from 0");
  }
  return {};
}

/// In-place actions before a successor's symbol.
Result<void> CheckLeaf(const Action& action, const Successor& successor) {
  for (const Action& in_place : successor.actions) {
    if (auto good = Check(in_place); !good) return good;
    if (in_place.operation->in_place) continue;
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{}: {} makes shapes and can't stand before a symbol", Name(action),
                            Name(in_place)),
                "give it a node or rule of its own");
  }
  return {};
}

Result<void> CheckSizes(const Action& action, std::span<const Successor> list, int depth) {
  if (depth > kDeepestRepeat) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{}: repeat groups more than {} deep", Name(action), kDeepestRepeat));
  }
  for (const Successor& s : list) {
    auto good = s.repeat.empty() ? CheckKey(action, s) : CheckSizes(action, s.repeat, depth + 1);
    if (!good) return good;
    if (auto leaf = CheckLeaf(action, s); !leaf) return leaf;
  }
  return {};
}

/// Layers: each successor has a name of its own.
Result<void> CheckNames(const Action& action) {
  std::set<std::string_view> names;
  for (const Successor& s : action.successors) {
    const auto* name = std::get_if<std::string>(&s.key);
    if (name == nullptr || name->empty() || !s.repeat.empty()) {
      return Fail(ErrorCode::kBadArguments,
                  fmt::format("{}: a successor without a name", Name(action)),
                  R"(write layers("floors", "door") { Floors | Door })");
    }
    if (!names.insert(*name).second) {
      return Fail(ErrorCode::kBadArguments,
                  fmt::format("{}: two successors are named '{}'", Name(action), *name),
                  "give each a name of its own");
    }
    if (auto good = CheckLeaf(action, s); !good) return good;
  }
  return {};
}

Result<void> CheckBraces(const Action& action) {
  const bool has_braces = action.operation->braces != Braces::kNone;
  if (has_braces == action.successors.empty()) {
    return Fail(ErrorCode::kBadArguments,
                has_braces ? fmt::format("{} needs successors in braces", Name(action))
                           : fmt::format("{} takes no successors in braces", Name(action)));
  }
  if (!action.symbol.empty() && (has_braces || action.operation->in_place)) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{} takes no symbol after it, got '{}'", Name(action), action.symbol));
  }
  if (action.operation->braces == Braces::kSizes) return CheckSizes(action, action.successors, 0);
  if (action.operation->braces == Braces::kNames) return CheckNames(action);
  for (const Successor& s : action.successors) {
    if (auto good = CheckSelector(action, s); !good) return good;
    if (auto good = CheckLeaf(action, s); !good) return good;
  }
  return {};
}

std::string_view RemedyFor(const Item& item) {
  switch (item.type) {
    case ItemType::kVolume:
      return "take its faces with comp(f) first";
    case ItemType::kPlanar:
      return "extrude it first";
    case ItemType::kLayer:
      return "lay 2D shapes out in it first, with segment or vectorial";
    case ItemType::kShape2D:
      return "it needs the planar shape that the scene's normalisation makes of a 2D shape";
    case ItemType::kEdge:
    case ItemType::kPoint:
      return "put something there first: a primitive, or an asset with i()";
  }
  return "";
}

}  // namespace

std::string_view Wanted(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::kLength:
      return "a length in metres";
    case ParameterKind::kAngle:
      return "an angle in degrees";
    case ParameterKind::kFactor:
      return "a number";
    case ParameterKind::kAxis:
      return "an axis: x, y or z";
    case ParameterKind::kText:
      return "a text in quotes";
    case ParameterKind::kColor:
      return R"(a color: "#rrggbb")";
    case ParameterKind::kWord:
      return "a word";
    case ParameterKind::kBool:
      return "true or false";
    case ParameterKind::kValue:
      return "a number, true or false, or a text in quotes";
    case ParameterKind::kSize:
      break;
  }
  return "a length in metres, or a part as in '0.5";
}

Result<void> CheckArgument(const Operation& row, const Parameter& parameter,
                           const Argument& argument) {
  const ParameterKind kind = parameter.kind;
  if (const double* number = std::get_if<double>(&argument); number && IsNumber(kind)) {
    return CheckNumber(row, parameter, *number);
  }
  if (const Size* size = std::get_if<Size>(&argument); size && kind == ParameterKind::kSize) {
    return CheckSize(row, parameter, *size);
  }
  if (const auto* text = std::get_if<std::string>(&argument); text && IsText(kind)) {
    return CheckText(row, parameter, *text);
  }
  if (kind == ParameterKind::kAxis && std::holds_alternative<Axis>(argument)) return {};
  if (kind == ParameterKind::kBool && std::holds_alternative<bool>(argument)) return {};
  const bool is_value = std::holds_alternative<double>(argument) ||
                        std::holds_alternative<bool>(argument) ||
                        std::holds_alternative<std::string>(argument);
  if (kind == ParameterKind::kValue && is_value) return {};
  return Fail(ErrorCode::kBadArguments,
              fmt::format("{}: {} is of another kind", row.name, parameter.name),
              fmt::format("give {}", Wanted(kind)));
}

Result<void> Check(const Action& action) {
  if (action.operation == nullptr) {
    return Fail(ErrorCode::kBadArguments, "an action without an operation");
  }
  if (auto good = CheckArguments(action); !good) return good;
  return CheckBraces(action);
}

Result<std::vector<Product>> Apply(const Action& action, const Item& item) {
  if (auto good = Check(action); !good) return Fail(good);
  if ((action.operation->takes & Types(item.type)) == 0) {
    return Fail(ErrorCode::kWrongItemType,
                fmt::format("{} can't be applied to a {}", Name(action), NameOf(item.type)),
                std::string(RemedyFor(item)));
  }
  return action.operation->apply(item, action);
}

}  // namespace parti::grammar
