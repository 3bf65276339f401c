// Trees as text derived on a rectangle, and shapes by their ids: what grammar tests read like.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "grammar/selection_action.h"

namespace parti::grammar {

/// width along x, depth along z, minimum corner at the origin, facing up.
inline ShapeTree LotOf(double width, double depth) {
  const Vec3 up(0, 1, 0);
  auto item = PlanarFrom({{{0, 0, depth}, {width, 0, depth}, {width, 0, 0}, {0, 0, 0}}}, &up);
  EXPECT_TRUE(item) << FormatError(item.error());
  return ShapeTree(std::move(*item));
}

inline Trees TreesFrom(std::string_view text) {
  auto trees = ParseTrees(text, "test.cga");
  if (trees) return std::move(*trees);
  for (const Error& error : trees.error()) ADD_FAILURE() << FormatError(error);
  return {};
}

/// The nodes of one tree, on a lot of 20 by 10.
inline Derivation Derived(std::string_view nodes) {
  auto derivation = Derive(TreesFrom("tree t {\n" + std::string(nodes) + "\n}"), LotOf(20, 10));
  if (derivation) return std::move(*derivation);
  ADD_FAILURE() << FormatError(derivation.error());
  return {LotOf(20, 10), LotOf(20, 10), {}, {}, {}};
}

inline std::vector<std::string> IdsOf(const ShapeTree& tree,
                                      const std::vector<ShapeIndex>& shapes) {
  std::vector<std::string> ids;
  for (const ShapeIndex i : shapes) ids.push_back(tree.IdOf(i));
  return ids;
}

/// What the query selects, as ids.
inline std::vector<std::string> Selected(std::string_view query, const ShapeTree& tree) {
  const auto parsed = ParseQuery(query);
  if (!parsed) {
    ADD_FAILURE() << FormatError(parsed.error());
    return {};
  }
  const auto product = ProductOf(*parsed, tree);
  if (product) return IdsOf(tree, *product);
  ADD_FAILURE() << FormatError(product.error());
  return {};
}

}  // namespace parti::grammar
