#include "sketch/actions.h"

#include <algorithm>

#include "grammar/operation.h"

namespace parti::sketch {
namespace {

grammar::Successor Part(grammar::Size size) {
  grammar::Successor part;
  part.key = size;
  return part;
}

grammar::Successor Part(grammar::Selector::Kind kind) {
  grammar::Successor part;
  part.key = grammar::Selector{kind};
  return part;
}

void SetAxis(grammar::Axis axis, grammar::Action* action) {
  for (grammar::Argument& argument : action->arguments) {
    if (auto* value = std::get_if<grammar::Axis>(&argument)) *value = axis;
  }
}

}  // namespace

grammar::Action ActionOfLength(const grammar::Operation& operation, double length_m) {
  grammar::Action action = grammar::Default(operation);
  for (const grammar::Dial& dial : grammar::Dials(&action)) {
    if (dial.kind != grammar::ParameterKind::kLength) continue;
    *dial.value = std::clamp(length_m, dial.low, dial.high);
    break;
  }
  return action;
}

grammar::Action OffsetAction(const grammar::Operation& offset, double distance_m) {
  grammar::Action action = ActionOfLength(offset, distance_m);
  action.successors = {Part(grammar::Selector::Kind::kInside),
                       Part(grammar::Selector::Kind::kBorder)};
  return action;
}

grammar::Action CompAction(const grammar::Operation& comp,
                           const std::vector<grammar::Selector::Kind>& selectors) {
  grammar::Action action = grammar::Default(comp);
  action.successors.clear();
  for (const auto kind : selectors) action.successors.push_back(Part(kind));
  return action;
}

grammar::Action SplitAction(const grammar::Operation& split, grammar::Axis axis,
                            const std::vector<double>& sizes_m, const std::vector<int>& groups) {
  grammar::Action action = grammar::Default(split);
  SetAxis(axis, &action);
  action.successors.clear();
  const auto largest = std::max_element(sizes_m.begin(), sizes_m.end()) - sizes_m.begin();
  const int floating = groups[static_cast<size_t>(largest)];
  for (size_t i = 0; i < sizes_m.size(); ++i) {
    using Kind = grammar::Size::Kind;
    action.successors.push_back(groups[i] == floating ? Part({Kind::kFloating, 1})
                                                      : Part({Kind::kAbsolute, sizes_m[i]}));
  }
  return action;
}

grammar::Action RepeatAction(const grammar::Operation& repeat, grammar::Axis axis, double size_m) {
  grammar::Action action = grammar::Default(repeat);
  SetAxis(axis, &action);
  action.successors = {Part({grammar::Size::Kind::kFloating, size_m})};
  return action;
}

grammar::Action RoofAction(const grammar::Operation& roof, double height_m) {
  grammar::Action action = grammar::Default(roof);
  action.arguments[0] = std::string(roof.parameters[0].words[1]);
  action.arguments[1] = height_m;
  return action;
}

grammar::Action ShapeAction(const grammar::Operation& shape) {
  grammar::Action action = grammar::Default(shape);
  action.successors = {Part(grammar::Selector::Kind::kShape),
                       Part(grammar::Selector::Kind::kRemainder)};
  return action;
}

grammar::Axis AxisOf(const grammar::Action& action) {
  for (const grammar::Argument& argument : action.arguments) {
    if (const auto* axis = std::get_if<grammar::Axis>(&argument)) return *axis;
  }
  return grammar::Axis::kX;
}

}  // namespace parti::sketch
