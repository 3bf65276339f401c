// Taking the product of a query: selectors as tests, relations as passes over parents.
#include "grammar/query.h"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/operation.h"
#include "grammar/query_filter.h"

namespace parti::grammar {
namespace {

using Mask = std::vector<uint8_t>;  ///< one per shape of the tree: 0 or 1

/// A selector with its names looked up in one tree.
struct Matcher {
  bool hopeless = false;                     ///< asks for a name that no shape of the tree has
  std::vector<const Operation*> operations;  ///< rows with the word; empty: any
  NameId symbol = kNoName;
  std::vector<NameId> tags;
  std::vector<ShapeTest> tests;

  bool operator()(const ShapeTree& tree, ShapeIndex i) const {
    const Shape& shape = tree[i];
    const auto has = [&](NameId tag) {
      return std::binary_search(shape.tags.begin(), shape.tags.end(), tag);
    };
    if (symbol != kNoName && shape.symbol != symbol) return false;
    if (!operations.empty() &&
        std::find(operations.begin(), operations.end(), shape.operation) == operations.end()) {
      return false;
    }
    return std::all_of(tags.begin(), tags.end(), has) &&
           std::all_of(tests.begin(), tests.end(), [&](const ShapeTest& t) { return t(i); });
  }
};

Result<Matcher> MatcherOf(const QuerySelector& selector, const ShapeTree& tree) {
  Matcher matcher;
  for (const Operation& row : Operations()) {
    if (row.word == selector.operation) matcher.operations.push_back(&row);
  }
  if (!selector.operation.empty() && matcher.operations.empty()) {
    return Fail(ErrorCode::kUnknownName,
                fmt::format("there is no operation '{}'", selector.operation));
  }
  matcher.symbol = tree.Find(selector.symbol);
  matcher.hopeless = !selector.symbol.empty() && matcher.symbol == kNoName;
  for (const std::string& tag : selector.tags) {
    matcher.tags.push_back(tree.Find(tag));
    matcher.hopeless |= matcher.tags.back() == kNoName;
  }
  for (const Filter& filter : selector.filters) {
    auto test = TestOf(filter, tree);
    if (!test) return Fail(test);
    matcher.tests.push_back(std::move(*test));
  }
  return matcher;
}

Mask MaskOf(const std::vector<ShapeIndex>& shapes, uint32_t size) {
  Mask mask(size, 0);
  for (const ShapeIndex i : shapes) mask[i] = 1;
  return mask;
}

/// The shapes below any of `roots`, in creation order. cost  linear in what is below them.
std::vector<ShapeIndex> Below(const ShapeTree& tree, const std::vector<ShapeIndex>& roots) {
  Mask seen(tree.size(), 0);
  std::vector<ShapeIndex> found;
  for (const ShapeIndex root : roots) {
    size_t next = found.size();
    for (ShapeIndex above = root;; above = found[next++]) {
      ShapeIndex child = tree.node(above).first_child;
      // Whatever has one child seen has all of them seen, and what is below them.
      if (child != kNoShape && seen[child] == 0) {
        for (; child != kNoShape; child = tree.node(child).next_sibling) {
          seen[child] = 1;
          found.push_back(child);
        }
      }
      if (next == found.size()) break;
    }
  }
  if (!std::is_sorted(found.begin(), found.end())) std::sort(found.begin(), found.end());
  return found;
}

/// (5.9)
std::vector<ShapeIndex> ChildrenOf(const ShapeTree& tree, const std::vector<ShapeIndex>& parents) {
  std::vector<ShapeIndex> children;
  for (const ShapeIndex parent : parents) {
    for (ShapeIndex i = tree.node(parent).first_child; i != kNoShape;
         i = tree.node(i).next_sibling) {
      children.push_back(i);
    }
  }
  std::sort(children.begin(), children.end());
  return children;
}

/// (5.11): shapes that share a parent with one of `shapes` and are not among them.
std::vector<ShapeIndex> SiblingsOf(const ShapeTree& tree, const std::vector<ShapeIndex>& shapes) {
  const Mask given = MaskOf(shapes, tree.size());
  Mask taken(tree.size(), 0);
  std::vector<ShapeIndex> parents;
  for (const ShapeIndex i : shapes) {
    const ShapeIndex parent = tree.node(i).parent;
    if (parent == kNoShape || taken[parent] != 0) continue;
    taken[parent] = 1;
    parents.push_back(parent);
  }
  std::vector<ShapeIndex> siblings = ChildrenOf(tree, parents);
  std::erase_if(siblings, [&](ShapeIndex i) { return given[i] != 0; });
  return siblings;
}

std::vector<ShapeIndex> Related(const ShapeTree& tree, Query::Relation relation,
                                const std::vector<ShapeIndex>& shapes) {
  switch (relation) {
    case Query::Relation::kDescendants:
      return Below(tree, shapes);
    case Query::Relation::kChildren:
      return ChildrenOf(tree, shapes);
    case Query::Relation::kSiblings:
      break;
  }
  return SiblingsOf(tree, shapes);
}

std::vector<ShapeIndex> AllOf(const ShapeTree& tree) {
  std::vector<ShapeIndex> all(tree.size());
  for (ShapeIndex i = 0; i < tree.size(); ++i) all[i] = i;
  return all;
}

}  // namespace

Result<std::vector<ShapeIndex>> ProductOf(const Query& query, const ShapeTree& tree,
                                          const std::vector<ShapeIndex>* within) {
  std::vector<ShapeIndex> shapes;
  for (size_t i = 0; i < query.selectors.size(); ++i) {
    const auto matcher = MatcherOf(query.selectors[i], tree);
    if (!matcher) return Fail(matcher);
    const bool alone = query.selectors.size() == 1;
    shapes = i > 0                        ? Related(tree, query.relations[i - 1], shapes)
             : alone && within != nullptr ? Below(tree, *within)
                                          : AllOf(tree);
    if (matcher->hopeless) shapes.clear();
    std::erase_if(shapes, [&](ShapeIndex s) { return !(*matcher)(tree, s); });
  }
  if (within != nullptr && query.selectors.size() > 1) {
    // (5.14): the product is taken over the whole tree, then cut down to the subtrees.
    const Mask below = MaskOf(Below(tree, *within), tree.size());
    std::erase_if(shapes, [&](ShapeIndex s) { return below[s] == 0; });
  }
  return shapes;
}

}  // namespace parti::grammar
