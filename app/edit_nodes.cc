#include "app/edit_nodes.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "base/utf8.h"

namespace parti::app {
namespace {

using grammar::SelectionActionNode;

std::vector<SelectionActionNode>& ChildrenAt(grammar::Trees* trees, const NodePath& path) {
  CHECK(!path.empty() && static_cast<size_t>(path[0]) < trees->size(), "a path names a tree");
  std::vector<SelectionActionNode>* nodes = &(*trees)[static_cast<size_t>(path[0])].nodes;
  for (size_t i = 1; i < path.size(); ++i) {
    CHECK(static_cast<size_t>(path[i]) < nodes->size(), "a path names a node");
    nodes = &(*nodes)[static_cast<size_t>(path[i])].children;
  }
  return *nodes;
}

}  // namespace

NodePath InsertNode(grammar::Trees* trees, NodePath path, SelectionActionNode node) {
  if (static_cast<size_t>(path[0]) == trees->size()) trees->push_back({"structure", true, {}});
  std::vector<SelectionActionNode>& siblings = ChildrenAt(trees, path);
  siblings.push_back(std::move(node));
  path.push_back(static_cast<int>(siblings.size()) - 1);
  return path;
}

SelectionActionNode& NodeAt(grammar::Trees* trees, const NodePath& path) {
  CHECK(path.size() >= 2, "a tree is not a node");
  const NodePath parent(path.begin(), path.end() - 1);
  return ChildrenAt(trees, parent)[static_cast<size_t>(path.back())];
}

Result<void> CheckNodeOrTree(const grammar::Trees& trees, const NodePath& path) {
  const auto refused = [&](const std::string& above, const char* what, size_t count) {
    return Fail(ErrorCode::kUnknownName, fmt::format("there is nothing at {}", PathText(path)),
                count == 0 ? fmt::format("{} has no nodes", above)
                           : fmt::format("{} has {} {}, from 0", above, count, what));
  };
  CHECK(!path.empty(), "a path names a tree");
  if (static_cast<size_t>(path[0]) >= trees.size()) {
    return refused("the building", "trees", trees.size());
  }
  const std::vector<SelectionActionNode>* nodes = &trees[static_cast<size_t>(path[0])].nodes;
  for (size_t i = 1; i < path.size(); ++i) {
    if (static_cast<size_t>(path[i]) >= nodes->size()) {
      return refused(PathText({path.begin(), path.begin() + static_cast<ptrdiff_t>(i)}), "nodes",
                     nodes->size());
    }
    nodes = &(*nodes)[static_cast<size_t>(path[i])].children;
  }
  return {};
}

Result<void> CheckNode(const grammar::Trees& trees, const NodePath& path) {
  if (path.size() >= 2) return CheckNodeOrTree(trees, path);
  return Fail(ErrorCode::kUnknownName, fmt::format("{} is a tree, not a node", PathText(path)),
              "name one of its nodes: 0/1");
}

Result<void> SwitchAt(grammar::Trees* trees, const NodePath& path, bool on) {
  if (const auto there = CheckNodeOrTree(*trees, path); !there) return there;
  bool& enabled = path.size() == 1 ? (*trees)[static_cast<size_t>(path[0])].enabled
                                   : NodeAt(trees, path).enabled;
  enabled = on;
  return {};
}

Result<void> DeleteAt(grammar::Trees* trees, const NodePath& path) {
  if (const auto there = CheckNodeOrTree(*trees, path); !there) return there;
  if (path.size() == 1) {
    trees->erase(trees->begin() + path[0]);
  } else {
    auto& siblings = ChildrenAt(trees, {path.begin(), path.end() - 1});
    siblings.erase(siblings.begin() + path.back());
  }
  return {};
}

namespace {

/// Moves the element at `from` of one vector to place `to`, counted without it.
template <typename T>
Result<void> MoveWithin(std::vector<T>* items, int from, int to) {
  T item = std::move((*items)[static_cast<size_t>(from)]);
  items->erase(items->begin() + from);
  if (static_cast<size_t>(to) > items->size()) {
    return Fail(ErrorCode::kUnknownName, fmt::format("the last tree is {}", items->size()));
  }
  items->insert(items->begin() + to, std::move(item));
  return {};
}

}  // namespace

Result<void> MoveNode(grammar::Trees* trees, const NodePath& from, const NodePath& to) {
  if (const auto there = CheckNodeOrTree(*trees, from); !there) return there;
  if ((from.size() == 1) != (to.size() == 1)) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{} can't move to {}", PathText(from), PathText(to)),
                "trees stay trees (1), and nodes stay nodes (1/0)");
  }
  grammar::Trees edited = *trees;
  if (from.size() == 1) {
    if (const auto moved = MoveWithin(&edited, from[0], to[0]); !moved) return moved;
  } else {
    SelectionActionNode node = NodeAt(&edited, from);
    if (const auto gone = DeleteAt(&edited, from); !gone) return gone;
    const NodePath parent(to.begin(), to.end() - 1);
    if (const auto there = CheckNodeOrTree(edited, parent); !there) return there;
    auto& siblings = ChildrenAt(&edited, parent);
    if (static_cast<size_t>(to.back()) > siblings.size()) {
      return Fail(ErrorCode::kUnknownName, fmt::format("nothing can stand at {}", PathText(to)),
                  fmt::format("the last place there is {}/{}", PathText(parent), siblings.size()));
    }
    siblings.insert(siblings.begin() + to.back(), std::move(node));
  }
  *trees = std::move(edited);
  return {};
}

Result<void> CheckName(const std::string& name) {
  constexpr size_t kLongest = 200;
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  const bool blank = name.find_first_not_of(' ') == std::string::npos;
  if (!blank && name.size() <= kLongest && IsUtf8(name) &&
      std::none_of(name.begin(), name.end(), is_control) && name.front() != ' ' &&
      name.back() != ' ') {
    return {};
  }
  return Fail(ErrorCode::kBadText, "this can't be a name",
              fmt::format("one line of at most {} letters, in UTF-8", kLongest));
}

Result<void> AddTreeNamed(grammar::Trees* trees, const std::string& name) {
  if (const auto fit = CheckName(name); !fit) return fit;
  trees->push_back({name, true, {}});
  return {};
}

Result<void> RenameTreeAt(grammar::Trees* trees, int tree, const std::string& name) {
  if (const auto there = CheckNodeOrTree(*trees, {tree}); !there) return there;
  if (const auto fit = CheckName(name); !fit) return fit;
  (*trees)[static_cast<size_t>(tree)].name = name;
  return {};
}

grammar::Query QueryFor(const grammar::ShapeTree& tree, grammar::ShapeIndex shape) {
  const grammar::Shape& s = tree[shape];
  grammar::QuerySelector selector;
  if (s.symbol != grammar::kNoName) {
    selector.symbol = std::string(tree.Name(s.symbol));
  } else {
    if (s.operation) selector.operation = std::string(s.operation->word);
    selector.filters.push_back({"leaf", {}, {}, {}});
  }
  return {{selector}, {}};
}

Result<SelectionActionNode> ParseNode(std::string_view text) {
  auto trees = grammar::ParseTrees(fmt::format("tree typed {{\n{}\n}}", text));
  if (!trees) {
    Error error = trees.error().front();
    if (error.place) error.place->line = std::max(1, error.place->line - 1);
    return tl::unexpected<Error>(std::move(error));
  }
  if (trees->size() != 1 || trees->front().nodes.size() != 1) {
    return Fail(ErrorCode::kBadText, "one node is wanted",
                "for example: .Lot --> extrude(12) Mass");
  }
  return std::move(trees->front().nodes.front());
}

Result<void> Turn(grammar::Action* action, const std::string& name, double value) {
  std::vector<std::string> names;
  for (const grammar::Dial& dial : grammar::Dials(action)) {
    names.push_back(dial.name);
    if (dial.name != name) continue;
    if (!(value >= dial.low && value <= dial.high)) {
      return Fail(ErrorCode::kBadNumber,
                  fmt::format("{} is outside {} to {}", value, dial.low, dial.high));
    }
    *dial.value = value;
    return {};
  }
  return Fail(ErrorCode::kUnknownName, fmt::format("this node has no number '{}'", name),
              names.empty() ? "it has none" : fmt::format("it has {}", fmt::join(names, ", ")));
}

}  // namespace parti::app
