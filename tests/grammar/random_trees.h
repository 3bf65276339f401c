// rapidcheck generators of queries, actions and trees that their parsers accept.
#pragma once

#include <rapidcheck.h>

#include "grammar/operation.h"
#include "grammar/query_filter.h"
#include "grammar/selection_action.h"

namespace parti::grammar {

inline rc::Gen<std::string> AnyName() {
  return rc::gen::element<std::string>("Floor", "Wall", "Střecha", "tree", "off", "x", "two words",
                                       "\"quoted\\\"", "2nd", "a\nb");
}

inline rc::Gen<double> AnyNumber(double low, double high) {
  return rc::gen::map(rc::gen::inRange<int64_t>(0, 1'000'000'007), [=](int64_t n) {
    return low + (high - low) * static_cast<double>(n) / 1'000'000'007.0;
  });
}

inline Query RandomQuery(int depth);

inline Filter RandomFilter(int depth) {
  const auto& row = Filters()[*rc::gen::inRange<size_t>(0, Filters().size())];
  Filter filter;
  filter.name = row.name;
  const bool nest = depth < 2;
  switch (row.arguments) {
    case FilterArguments::kNone:
      break;
    case FilterArguments::kOneOrTwoCounts:
      filter.numbers = {static_cast<double>(*rc::gen::inRange(1, 9))};
      if (*rc::gen::arbitrary<bool>()) filter.numbers.push_back(*rc::gen::inRange(1, 9));
      break;
    case FilterArguments::kArea:
      filter.numbers = {*AnyNumber(0, 1000)};
      break;
    case FilterArguments::kVolume:
      if (nest && *rc::gen::arbitrary<bool>()) {
        filter.queries = {RandomQuery(depth + 1)};
        break;
      }
      filter.volume = *rc::gen::element<std::string>("sphere", "box", "cylinder");
      for (size_t i = 0; i < NumbersOfVolume(filter.volume); ++i) {
        filter.numbers.push_back(i < 3 ? *AnyNumber(-50, 50) : *AnyNumber(0, 50));
      }
      break;
    case FilterArguments::kQueryAndMetres:
      filter.numbers = {*AnyNumber(0, 100)};
      [[fallthrough]];
    case FilterArguments::kQuery:
      filter.queries = {nest ? RandomQuery(depth + 1) : Query{{QuerySelector{}}, {}}};
      break;
  }
  return filter;
}

inline QuerySelector RandomSelector(int depth) {
  QuerySelector selector;
  const auto& row = Operations()[*rc::gen::inRange<size_t>(0, Operations().size())];
  if (*rc::gen::inRange(0, 4) == 0) selector.operation = row.word;
  if (*rc::gen::arbitrary<bool>()) selector.symbol = *AnyName();
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) selector.tags.push_back(*AnyName());
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) selector.filters.push_back(RandomFilter(depth));
  return selector;
}

inline Query RandomQuery(int depth = 0) {
  using Relation = Query::Relation;
  Query query{{RandomSelector(depth)}, {}};
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    query.selectors.push_back(RandomSelector(depth));
    query.relations.push_back(
        *rc::gen::element(Relation::kDescendants, Relation::kChildren, Relation::kSiblings));
  }
  return query;
}

inline Argument RandomArgument(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::kAxis:
      return *rc::gen::element(Axis::kX, Axis::kY, Axis::kZ);
    case ParameterKind::kText:
      return parameter.words.empty() ? *AnyName() : std::string(parameter.words.front());
    case ParameterKind::kBool:
      return *rc::gen::arbitrary<bool>();
    case ParameterKind::kSize:
      return Size{*rc::gen::element(Size::Kind::kAbsolute, Size::Kind::kRelative),
                  *AnyNumber(parameter.low, parameter.high)};
    case ParameterKind::kColor:
    case ParameterKind::kWord:
      return parameter.default_value;
    default:
      return *AnyNumber(parameter.low, parameter.high);
  }
}

inline Action RandomAction(bool in_place);

inline Successor RandomSuccessor(const Operation& row, int depth) {
  Successor successor;
  successor.deferred = *rc::gen::inRange(0, 4) == 0;
  if (row.braces == Braces::kSizes && depth < 2 && *rc::gen::inRange(0, 4) == 0) {
    for (int i = *rc::gen::inRange(1, 3); i > 0; --i) {
      successor.repeat.push_back(RandomSuccessor(row, depth + 1));
    }
    successor.deferred = false;
    return successor;
  }
  if (row.braces == Braces::kSizes) {
    using Kind = Size::Kind;
    successor.key = Size{*rc::gen::element(Kind::kAbsolute, Kind::kRelative, Kind::kFloating),
                         *AnyNumber(0.1, 10)};
  } else if (row.braces == Braces::kNames) {
    successor.key = *AnyName();
  } else {
    const auto kind = row.selectors[*rc::gen::inRange<size_t>(0, row.selectors.size())];
    successor.key = Selector{kind, kind == Selector::Kind::kIndex ? *rc::gen::inRange(0, 9) : 0};
  }
  for (int i = *rc::gen::inRange(0, 3); i > 1; --i) {
    successor.actions.push_back(RandomAction(true));
  }
  successor.symbol = *rc::gen::element<std::string>("", "NIL", "A", "two words");
  if (successor.symbol.empty() || successor.symbol == kNil) successor.deferred = false;
  return successor;
}

inline Action RandomAction(bool in_place = false) {
  std::vector<const Operation*> rows;
  for (const Operation& row : Operations()) {
    if (!row.notes && (!in_place || row.in_place)) rows.push_back(&row);
  }
  const Operation& row = *rows[*rc::gen::inRange<size_t>(0, rows.size())];
  Action action;
  action.operation = &row;
  for (const Parameter& p : row.parameters) action.arguments.push_back(RandomArgument(p));
  if (row.braces == Braces::kNone) {
    if (!in_place) action.symbol = *rc::gen::element<std::string>("", "A", "two words");
    return action;
  }
  for (int i = *rc::gen::inRange(1, 4); i > 0; --i) {
    action.successors.push_back(RandomSuccessor(row, 0));
    auto* name = std::get_if<std::string>(&action.successors.back().key);
    if (name != nullptr) *name += std::to_string(i);  // each has its own
  }
  return action;
}

inline std::vector<SelectionActionNode> RandomNodes(int depth) {
  std::vector<SelectionActionNode> nodes;
  for (int i = *rc::gen::inRange(0, 4 - depth); i > 0; --i) {
    nodes.push_back({RandomQuery(), RandomAction(), *rc::gen::arbitrary<bool>(), {}});
    if (depth < 2) nodes.back().children = RandomNodes(depth + 1);
  }
  return nodes;
}

inline Trees RandomTrees() {
  Trees trees;
  for (int i = *rc::gen::inRange(0, 3); i > 0; --i) {
    trees.push_back({*AnyName(), *rc::gen::arbitrary<bool>(), RandomNodes(0)});
  }
  return trees;
}

}  // namespace parti::grammar
