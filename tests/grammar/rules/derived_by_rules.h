// Rules as text derived on a rectangle: what tests of derivation read like.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/rules/rule_derivation.h"
#include "grammar/rules/rule_text.h"
#include "tests/grammar/derived.h"

namespace parti::grammar {

inline RuleSet RulesFrom(std::string_view text) {
  auto rules = ParseRules(text, "test.cga");
  if (rules) return std::move(*rules);
  for (const Error& error : rules.error()) ADD_FAILURE() << FormatError(error);
  return {};
}

/// On a lot of 20 by 10.
inline Result<ShapeTree> TryRules(std::string_view text, const RuleSettings& settings = {}) {
  const Item lot = LotOf(20, 10)[0].item;
  auto trees = DeriveRules(RulesFrom(text), settings, {&lot, 1}, {});
  if (!trees) return Fail(trees);
  return std::move(trees->front());
}

inline ShapeTree ByRules(std::string_view text, const RuleSettings& settings = {}) {
  auto tree = TryRules(text, settings);
  if (tree) return std::move(*tree);
  ADD_FAILURE() << FormatError(tree.error());
  return LotOf(20, 10);
}

/// The tree as ids with symbols, one line: ". Lot, 0 Mass, 0/0 Facade"; "-" where there is none.
inline std::string Outline(const ShapeTree& tree) {
  std::string text;
  std::vector<ShapeIndex> stack = {0};
  while (!stack.empty()) {
    const ShapeIndex i = stack.back();
    stack.pop_back();
    const Shape& shape = tree[i];
    const std::string_view symbol = tree.Name(shape.symbol);
    text += (text.empty() ? "" : ", ") + tree.IdOf(i) + " " +
            std::string(symbol.empty() ? "-" : symbol);
    std::vector<ShapeIndex> children;
    for (ShapeIndex c = tree.node(i).first_child; c != kNoShape; c = tree.node(c).next_sibling) {
      children.push_back(c);
    }
    stack.insert(stack.end(), children.rbegin(), children.rend());
  }
  return text;
}

/// Symbols of the visible shapes, in the tree's order.
inline std::vector<std::string> Visible(const ShapeTree& tree) {
  std::vector<std::string> symbols;
  for (const ShapeIndex i : tree.Leaves()) symbols.emplace_back(tree.Name(tree[i].symbol));
  return symbols;
}

/// Everything that a tree holds, exactly: equal texts are equal trees.
inline std::string Bytes(const ShapeTree& tree) {
  std::string text;
  const auto add = [&](const auto& value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  const auto add_vec = [&](const Vec3& v) { add(v.x), add(v.y), add(v.z); };
  for (ShapeIndex i = 0; i < tree.size(); ++i) {
    const Shape& s = tree[i];
    const ShapeNode& node = tree.node(i);
    text += tree.Name(s.symbol);
    for (const NameId tag : s.tags) text += tree.Name(tag);
    add(s.operation), add(s.is_hidden), add(s.item.type), add(s.item.color_rgb);
    add(node.parent), add(node.first_child), add(node.last_child), add(node.next_sibling);
    add(node.ordinal), add(node.is_visible);
    add_vec(s.item.scope.origin), add_vec(s.item.scope.x), add_vec(s.item.scope.size);
    if (s.item.polygon) {
      for (const Vec2& p : s.item.polygon->outer) add(p.x), add(p.y);
    }
    if (s.item.mesh) {
      for (const Vec3& p : s.item.mesh->points) add_vec(p);
    }
  }
  return text;
}

}  // namespace parti::grammar
