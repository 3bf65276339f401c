// Renaming symbols in selection-action trees: the RenameAt and RenameAll of edit_nodes.h.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/edit_nodes.h"

namespace parti::app {
namespace {

using grammar::SelectionActionNode;

constexpr std::string_view kLotSymbol = "Lot";
constexpr std::string_view kSymbolOperation = "symbol";

using Texts = std::vector<std::string*>;

/// Every symbol that an action gives, in reading order.
void CollectGiven(grammar::Action* action, Texts* found);

void CollectGiven(std::vector<grammar::Successor>* successors, Texts* found) {
  for (grammar::Successor& s : *successors) {
    CollectGiven(&s.repeat, found);
    for (grammar::Action& a : s.actions) CollectGiven(&a, found);
    if (!s.symbol.empty() && s.symbol != grammar::kNil) found->push_back(&s.symbol);
  }
}

void CollectGiven(grammar::Action* action, Texts* found) {
  CollectGiven(&action->successors, found);
  if (action->operation->name == kSymbolOperation) {
    found->push_back(&std::get<std::string>(action->arguments.at(0)));
  }
  if (!action->symbol.empty()) found->push_back(&action->symbol);
}

Texts GivenBy(grammar::Action* action) {
  Texts found;
  CollectGiven(action, &found);
  return found;
}

void CollectGiven(std::vector<SelectionActionNode>* nodes, Texts* found) {
  for (SelectionActionNode& node : *nodes) {
    CollectGiven(&node.action, found);
    CollectGiven(&node.children, found);
  }
}

Texts GivenBy(grammar::Trees* trees) {
  Texts found;
  for (auto& tree : *trees) CollectGiven(&tree.nodes, &found);
  return found;
}

void RenameIn(grammar::Query* query, const std::string& from, const std::string& to) {
  for (grammar::QuerySelector& selector : query->selectors) {
    if (selector.symbol == from) selector.symbol = to;
    for (grammar::Filter& filter : selector.filters) {
      for (grammar::Query& inner : filter.queries) RenameIn(&inner, from, to);
    }
  }
}

void RenameInQueries(std::vector<SelectionActionNode>* nodes, const std::string& from,
                     const std::string& to) {
  for (SelectionActionNode& node : *nodes) {
    RenameIn(&node.query, from, to);
    RenameInQueries(&node.children, from, to);
  }
}

void RenameInQueries(grammar::Trees* trees, const std::string& from, const std::string& to) {
  for (auto& tree : *trees) RenameInQueries(&tree.nodes, from, to);
}

bool RenameAmong(const Texts& symbols, const std::string& from, const std::string& to) {
  bool found = false;
  for (std::string* symbol : symbols) {
    if (*symbol != from) continue;
    *symbol = to;
    found = true;
  }
  return found;
}

std::vector<std::string> Names(const Texts& symbols) {
  std::vector<std::string> names;
  for (const std::string* symbol : symbols) {
    if (std::find(names.begin(), names.end(), *symbol) == names.end()) names.push_back(*symbol);
  }
  return names;
}

Result<void> CheckSymbol(const std::string& text) {
  const auto is_word = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  if (text == grammar::kNil) {
    return Fail(ErrorCode::kBadText, "NIL makes nothing and can't be a symbol",
                "delete the node, or choose another name");
  }
  if (!text.empty() && !std::isdigit(static_cast<unsigned char>(text[0])) &&
      std::all_of(text.begin(), text.end(), is_word)) {
    return {};
  }
  return Fail(ErrorCode::kBadText, fmt::format("'{}' can't be a symbol", text),
              "letters, digits and _, not beginning with a digit");
}

}  // namespace

Result<void> RenameAt(grammar::Trees* trees, const NodePath& path, const std::string& from,
                      const std::string& to) {
  if (const auto fit = CheckSymbol(to); !fit) return fit;
  SelectionActionNode& node = NodeAt(trees, path);
  const std::vector<std::string> names = Names(GivenBy(&node.action));
  if (!RenameAmong(GivenBy(&node.action), from, to)) {
    return Fail(
        ErrorCode::kUnknownName, fmt::format("this node gives no symbol '{}'", from),
        names.empty() ? "it gives none" : fmt::format("it gives {}", fmt::join(names, ", ")));
  }
  RenameInQueries(&node.children, from, to);
  const std::vector<std::string> left = Names(GivenBy(trees));
  const bool given_elsewhere = std::find(left.begin(), left.end(), from) != left.end();
  if (!given_elsewhere && from != kLotSymbol) RenameInQueries(trees, from, to);
  return {};
}

Result<void> RenameAll(grammar::Trees* trees, const std::string& from, const std::string& to) {
  if (const auto fit = CheckSymbol(to); !fit) return fit;
  if (from == kLotSymbol) {
    return Fail(ErrorCode::kBadText, "the lot keeps its symbol",
                "give what is made of it another name: name Mass Tower");
  }
  const std::vector<std::string> names = Names(GivenBy(trees));
  if (!RenameAmong(GivenBy(trees), from, to)) {
    const auto meant = DidYouMean(from, names);
    return Fail(ErrorCode::kUnknownName, fmt::format("no node gives the symbol '{}'", from),
                meant           ? fmt::format("did you mean '{}'?", *meant)
                : names.empty() ? "there are no symbols yet"
                                : fmt::format("there are {}", fmt::join(names, ", ")));
  }
  RenameInQueries(trees, from, to);
  return {};
}

}  // namespace parti::app
