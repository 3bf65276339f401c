#include "grammar/layers/interactive_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "grammar/lexer.h"
#include "grammar/operation.h"

namespace parti::grammar {
namespace {

/// A number of the text.
struct Written {
  double value = 0;
  TextRange range;
};

/// A segment that lays out one thing: segment(axis, before, extent, ~1) { NIL | symbol | NIL }.
struct Placing {
  Written before, extent;
  const Statement* symbol = nullptr;
};

const Statement* OnlyStatement(const Body& body) {
  const bool one = body.kind == Body::Kind::kSequence && body.statements.size() == 1;
  return one ? &body.statements[0] : nullptr;
}

/// The one symbol, not deferred and without arguments, that the successor makes; kNil for nothing.
const Statement* OnlySymbol(const SuccessorRule& successor) {
  const Statement* only = OnlyStatement(successor.body);
  if (only == nullptr || only->kind != Statement::Kind::kSymbol) return nullptr;
  return only->deferred || !only->arguments.empty() ? nullptr : only;
}

bool MakesNothing(const SuccessorRule& successor) {
  const Statement* symbol = OnlySymbol(successor);
  return symbol != nullptr && symbol->symbol == kNil;
}

std::optional<Written> WrittenIn(const RuleSet& rules, const Expression& expression) {
  const bool named = expression.kind == Expression::Kind::kAttribute;
  const Expression& value = named ? rules.attributes[expression.index].value : expression;
  const double* number = std::get_if<double>(&value.constant);
  if (value.kind != Expression::Kind::kConstant || number == nullptr) return std::nullopt;
  if (value.range.to <= value.range.from) return std::nullopt;
  return Written{*number, value.range};
}

bool IsSized(const SuccessorRule& successor, Size::Kind kind) {
  const Size* size = std::get_if<Size>(&successor.key);
  return successor.repeat.empty() && size != nullptr && size->kind == kind;
}

std::optional<Placing> PlacingOf(const RuleSet& rules, const Rule& rule, Axis axis) {
  const Statement* segment = OnlyStatement(rule.body);
  if (!rule.parameters.empty() || segment == nullptr || segment->operation == nullptr ||
      segment->operation->name != kSegmentName || segment->successors.size() != 3) {
    return std::nullopt;
  }
  const auto* along = std::get_if<std::string>(&segment->arguments[0].value.constant);
  const auto& parts = segment->successors;
  const bool form =
      along != nullptr && *along == NameOf(axis) && IsSized(parts[0], Size::Kind::kAbsolute) &&
      IsSized(parts[1], Size::Kind::kAbsolute) && IsSized(parts[2], Size::Kind::kFloating) &&
      MakesNothing(parts[0]) && MakesNothing(parts[2]) && parts[0].size && parts[1].size;
  const Statement* symbol = form ? OnlySymbol(parts[1]) : nullptr;
  if (symbol == nullptr || symbol->symbol == kNil) return std::nullopt;
  const auto before = WrittenIn(rules, *parts[0].size), extent = WrittenIn(rules, *parts[1].size);
  if (!before || !extent) return std::nullopt;
  return Placing{*before, *extent, symbol};
}

/// A number of a layer that becomes another.
struct Change {
  TextRange range;
  double from, to;
};
using Changes = std::array<Change, 4>;

Changes ChangesOf(const InteractiveRules& found, const InteractiveLayer& layer) {
  const InteractiveLayer& old = found.layer;
  return {{{found.bottom, old.bottom, layer.bottom},
           {found.left, old.left, layer.left},
           {found.width, old.width, layer.width},
           {found.height, old.height, layer.height}}};
}

/// Millimetres are finer than any hand.
std::string Rounded(double metres) { return NumberText(std::round(metres * 1000) / 1000); }

}  // namespace

std::vector<InteractiveRules> InteractiveLayersOf(const RuleSet& rules) {
  std::vector<InteractiveRules> found;
  for (const Rule& rule : rules.rules) {
    const auto across = PlacingOf(rules, rule, Axis::kX);
    if (!across || across->symbol->index == kNoRule) continue;
    const auto up = PlacingOf(rules, rules.rules[across->symbol->index], Axis::kY);
    if (!up) continue;
    InteractiveRules one;
    one.layer = {rule.symbol,          up->symbol->symbol,   up->before.value,
                 across->before.value, across->extent.value, up->extent.value};
    one.left = across->before.range;
    one.width = across->extent.range;
    one.bottom = up->before.range;
    one.height = up->extent.range;
    const uint32_t file = one.left.file;
    if (one.width.file != file || one.bottom.file != file || one.height.file != file) continue;
    found.push_back(std::move(one));
  }
  return found;
}

std::string TextWith(const RuleSet& rules, const InteractiveRules& found,
                     const InteractiveLayer& layer) {
  std::string text = rules.files[found.left.file].text;
  Changes changes = ChangesOf(found, layer);
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.range.from > b.range.from; });
  std::optional<uint32_t> done;  // where a number stands that two of them share
  for (const Change& change : changes) {
    if (change.from == change.to || change.range.from == done) continue;
    text.replace(change.range.from, change.range.to - change.range.from, Rounded(change.to));
    done = change.range.from;
  }
  return text;
}

InteractiveLayer Following(const InteractiveRules& one, const InteractiveRules& changed,
                           const InteractiveLayer& layer) {
  const Changes changes = ChangesOf(changed, layer);
  const auto now = [&](const TextRange& range, double number) {
    for (const Change& change : changes) {
      const bool same = change.range.file == range.file && change.range.from == range.from;
      if (same && change.from != change.to) return change.to;
    }
    return number;
  };
  InteractiveLayer then = one.layer;
  then.bottom = now(one.bottom, then.bottom);
  then.left = now(one.left, then.left);
  then.width = now(one.width, then.width);
  then.height = now(one.height, then.height);
  return then;
}

std::string RulesTextOf(const InteractiveLayer& layer) {
  const std::string name = NameText(layer.name), tile = NameText(layer.name + "VTile");
  return fmt::format(
      "{} --> segment(x, {}, {}, ~1) {{ NIL | {} | NIL }}\n"
      "{} --> segment(y, {}, {}, ~1) {{ NIL | {} | NIL }}\n",
      name, Rounded(layer.left), Rounded(layer.width), tile, tile, Rounded(layer.bottom),
      Rounded(layer.height), NameText(layer.payload));
}

}  // namespace parti::grammar
