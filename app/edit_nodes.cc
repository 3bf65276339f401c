#include "app/edit_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/check.h"

namespace parti::app {
namespace {

using grammar::SelectionActionNode;

std::vector<SelectionActionNode>& ChildrenAt(grammar::Trees* trees, const std::vector<int>& path) {
  CHECK(!path.empty() && static_cast<size_t>(path[0]) < trees->size(), "a path names a tree");
  std::vector<SelectionActionNode>* nodes = &(*trees)[static_cast<size_t>(path[0])].nodes;
  for (size_t i = 1; i < path.size(); ++i) {
    CHECK(static_cast<size_t>(path[i]) < nodes->size(), "a path names a node");
    nodes = &(*nodes)[static_cast<size_t>(path[i])].children;
  }
  return *nodes;
}

/// Every symbol that an action gives, in reading order.
std::vector<std::string*> SymbolsOf(grammar::Action* action);

void CollectSymbols(std::vector<grammar::Successor>* successors, std::vector<std::string*>* found) {
  for (grammar::Successor& s : *successors) {
    CollectSymbols(&s.repeat, found);
    for (grammar::Action& a : s.actions) {
      for (std::string* symbol : SymbolsOf(&a)) found->push_back(symbol);
    }
    if (!s.symbol.empty() && s.symbol != grammar::kNil) found->push_back(&s.symbol);
  }
}

std::vector<std::string*> SymbolsOf(grammar::Action* action) {
  std::vector<std::string*> found;
  CollectSymbols(&action->successors, &found);
  if (!action->symbol.empty()) found.push_back(&action->symbol);
  return found;
}

bool IsIdentifier(const std::string& text) {
  const auto is_word = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  return !text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), is_word);
}

}  // namespace

std::vector<int> InsertNode(grammar::Trees* trees, std::vector<int> path,
                            SelectionActionNode node) {
  if (static_cast<size_t>(path[0]) == trees->size()) trees->push_back({"structure", true, {}});
  std::vector<SelectionActionNode>& siblings = ChildrenAt(trees, path);
  siblings.push_back(std::move(node));
  path.push_back(static_cast<int>(siblings.size()) - 1);
  return path;
}

SelectionActionNode& NodeAt(grammar::Trees* trees, const std::vector<int>& path) {
  CHECK(path.size() >= 2, "a tree is not a node");
  std::vector<int> parent(path.begin(), path.end() - 1);
  return ChildrenAt(trees, parent)[static_cast<size_t>(path.back())];
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

Result<void> Rename(grammar::Action* action, const std::string& from, const std::string& to) {
  if (!IsIdentifier(to)) {
    return Fail(ErrorCode::kBadText, fmt::format("'{}' can't be a symbol", to),
                "letters, digits and _, not beginning with a digit");
  }
  bool found = false;
  std::vector<std::string> names;
  for (std::string* symbol : SymbolsOf(action)) {
    names.push_back(*symbol);
    if (*symbol != from) continue;
    *symbol = to;
    found = true;
  }
  if (found) return {};
  return Fail(ErrorCode::kUnknownName, fmt::format("this node gives no symbol '{}'", from),
              names.empty() ? "it gives none" : fmt::format("it gives {}", fmt::join(names, ", ")));
}

Result<void> Requery(SelectionActionNode* node, const std::string& text) {
  auto query = grammar::ParseQuery(text);
  if (!query) return Fail(query);
  node->query = std::move(*query);
  return {};
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
