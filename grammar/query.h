// Semantic queries over a shape tree (Jesus 2018, 5.3; errata 10, 11; docs/language.md, Queries).
// Not responsible for guessing the query that a few selected shapes mean.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "grammar/shape_tree.h"

namespace parti::grammar {

struct Query;

/// A filter as it was written: ":nth(2,3)", ":inside(sphere(3,1,5,5))", ":facing(#Road)".
struct Filter {
  std::string name;
  std::vector<double> numbers;  ///< of the filter, or of its volume
  std::string volume;           ///< "sphere", "box", "cylinder"; "" when there is none
  std::vector<Query> queries;   ///< at most one
  bool operator==(const Filter&) const;
};

/// One step of a query: what a shape has to have. Empty parts ask for nothing.
struct QuerySelector {
  std::string operation;  ///< a table row's word; "" any
  std::string symbol;     ///< "" any
  std::vector<std::string> tags;
  std::vector<Filter> filters;
  bool operator==(const QuerySelector&) const = default;
};

/// Selectors joined by relations; the shapes selected are the last selector's.
struct Query {
  enum class Relation : char { kDescendants = '>', kChildren = '/', kSiblings = '~' };
  std::vector<QuerySelector> selectors;  ///< n >= 1
  std::vector<Relation> relations;       ///< n - 1
  bool operator==(const Query&) const = default;
};

/// errors  kBadText  with the place and what was wanted;  kUnknownName  an operation word or filter
///         that does not exist, with "did you mean";  kBadArguments  a filter's arguments.
Result<Query> ParseQuery(std::string_view text, std::string_view file = {});
std::string TextOf(const Query& query);

/// The matching shapes in creation order (5.13). `within`: only descendants of these (5.14); null
/// for the whole tree. Linear in the tree for each selector; facing and within take the product of
/// their inner query once.
/// errors  kUnknownName  a filter that is not available here.
Result<std::vector<ShapeIndex>> ProductOf(const Query& query, const ShapeTree& tree,
                                          const std::vector<ShapeIndex>* within = nullptr);

}  // namespace parti::grammar
