// The numbers of actions that may be turned (Dials), and actions spread over the parameter space of
// a row (Samples; Jesus 2018, Listing 6.1).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grammar/operation.h"
#include "grammar/operations/roof_parts.h"

namespace parti::grammar {
namespace {

constexpr double kLargestDialSize_m = 1e4;

bool IsNumber(ParameterKind kind) {
  return kind == ParameterKind::kLength || kind == ParameterKind::kAngle ||
         kind == ParameterKind::kFactor;
}

void AddSizeDials(std::vector<Successor>* list, int* number, std::vector<Dial>* dials) {
  for (Successor& s : *list) {
    if (!s.repeat.empty()) {
      AddSizeDials(&s.repeat, number, dials);
      continue;
    }
    const int i = (*number)++;
    Size* size = std::get_if<Size>(&s.key);
    if (size == nullptr) continue;
    const bool is_relative = size->kind == Size::Kind::kRelative;
    dials->push_back({fmt::format("sizes[{}]", i), &size->value, 0,
                      is_relative ? 1 : kLargestDialSize_m,
                      is_relative ? ParameterKind::kFactor : ParameterKind::kLength});
  }
}

Successor SizeSuccessor(Size::Kind kind, double value, std::string symbol) {
  Successor s;
  s.key = Size{kind, value};
  s.symbol = std::move(symbol);
  return s;
}

Successor SelectorSuccessor(Selector::Kind kind, std::string symbol) {
  Successor s;
  s.key = Selector{kind, 0};
  s.symbol = std::move(symbol);
  return s;
}

/// Axes along which the item has an extent.
int AxesOf(const Item& item) { return IsFlat(item.type) ? 2 : 3; }

/// One cut, or one repeated size, along each axis for each length that fits.
void AddSplitSamples(const Operation& row, const Item& item, std::span<const double> lengths_m,
                     std::vector<Action>* samples) {
  const bool repeats = row.name == kRepeatName;
  for (int axis = 0; axis < AxesOf(item); ++axis) {
    for (const double length : lengths_m) {
      if (!(length > 0) || length >= item.scope.size[axis]) continue;
      Action action = Default(row);
      action.arguments[0] = static_cast<Axis>(axis);
      if (repeats) {
        action.successors = {SizeSuccessor(Size::Kind::kFloating, length, "A")};
      } else {
        action.successors = {SizeSuccessor(Size::Kind::kAbsolute, length, "A"),
                             SizeSuccessor(Size::Kind::kFloating, 1, "B")};
      }
      samples->push_back(std::move(action));
    }
  }
}

/// The selectors of a sample: all there is, each product once.
std::vector<Successor> SelectorsOf(const Operation& row) {
  if (row.selectors.empty()) return {};
  if (row.selectors[0] == Selector::Kind::kAll) {
    return {SelectorSuccessor(Selector::Kind::kAll, "A")};
  }
  std::vector<Successor> successors;
  for (const Selector::Kind kind : row.selectors) {
    successors.push_back(
        SelectorSuccessor(kind, std::string(1, static_cast<char>('A' + successors.size()))));
  }
  return successors;
}

/// Where the row's length stands: its first argument of that kind. Roofs are told their height,
/// which the argument before says. The number of parameters where there is none.
size_t LengthOf(const Operation& row, Action* action) {
  for (size_t i = 0; i < row.parameters.size(); ++i) {
    const Parameter& parameter = row.parameters[i];
    if (parameter.kind == ParameterKind::kLength) return i;
    if (parameter.words.data() != kPitchWords.data()) continue;
    action->arguments[i] = std::string(kPitchWords[1]);
    return i + 1;
  }
  return row.parameters.size();
}

/// Rows with one length, or none.
void AddLengthSamples(const Operation& row, std::span<const double> lengths_m,
                      std::vector<Action>* samples) {
  Action action = Default(row);
  action.successors = SelectorsOf(row);
  if (row.braces == Braces::kNone) action.symbol = "A";
  const size_t length_at = LengthOf(row, &action);
  if (length_at == row.parameters.size()) {
    samples->push_back(std::move(action));
    return;
  }
  const Parameter& parameter = row.parameters[length_at];
  for (const double length : lengths_m) {
    for (const double value : {length, -length}) {
      if (value == 0 || value < parameter.low || value > parameter.high) continue;
      action.arguments[length_at] = value;
      samples->push_back(action);
    }
  }
}

}  // namespace

std::vector<Dial> Dials(Action* action) {
  std::vector<Dial> dials;
  for (size_t i = 0; i < action->arguments.size(); ++i) {
    const Parameter& p = action->operation->parameters[i];
    double* value = std::get_if<double>(&action->arguments[i]);
    if (value == nullptr || !IsNumber(p.kind) || *value < p.low) continue;  // left out
    const ParameterKind kind = IsHeight(*action, i) ? ParameterKind::kLength : p.kind;
    dials.push_back({std::string(p.name), value, p.low, p.high, kind});
  }
  int number = 0;
  AddSizeDials(&action->successors, &number, &dials);
  return dials;
}

std::vector<Action> Samples(const Operation& operation, const Item& item,
                            std::span<const double> lengths_m) {
  std::vector<Action> samples;
  if (operation.in_place || !operation.sampled) return samples;
  if ((operation.takes & Types(item.type)) == 0) return samples;
  // The faces of what has one are the shape itself.
  const bool takes_apart =
      !operation.selectors.empty() && operation.selectors[0] == Selector::Kind::kAll;
  if (takes_apart && item.type != ItemType::kVolume) return samples;
  if (operation.braces == Braces::kSizes) {
    AddSplitSamples(operation, item, lengths_m, &samples);
  } else {
    AddLengthSamples(operation, lengths_m, &samples);
  }
  return samples;
}

}  // namespace parti::grammar
