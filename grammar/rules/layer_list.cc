#include "grammar/rules/layer_list.h"

#include <algorithm>
#include <set>

#include "grammar/operation.h"
#include "grammar/rules/visit_statements.h"

namespace parti::grammar {
namespace {

std::string SymbolOf(const Body& body) {
  const bool one = body.kind == Body::Kind::kSequence && body.statements.size() == 1;
  if (!one || body.statements[0].kind != Statement::Kind::kSymbol) return "";
  return body.statements[0].symbol;
}

/// Adds the layers of a body and of all in it, deepest first, those of equal names once.
void AddLayers(const Body& body, std::vector<ListedLayer>* layers) {
  VisitStatements(body, [&](const Statement& statement) {
    for (const SuccessorRule& one : statement.successors) {
      const auto* name = std::get_if<std::string>(&one.key);
      if (name == nullptr || statement.operation->braces != Braces::kNames) continue;
      const bool known = std::any_of(layers->begin(), layers->end(),
                                     [&](const auto& l) { return l.name == *name; });
      if (!known) layers->push_back({*name, SymbolOf(one.body), SymbolOf(one.body)});
    }
  });
}

/// All symbols that a body gives, at any depth.
std::set<std::string> SymbolsIn(const Body& body) {
  std::set<std::string> symbols;
  VisitStatements(body, [&](const Statement& statement) {
    if (statement.kind == Statement::Kind::kSymbol) symbols.insert(statement.symbol);
  });
  return symbols;
}

/// A symbol, and those whose rules may come to it. O(rules squared), at worst.
std::set<std::string> LeadingTo(const RuleSet& rules, const std::string& symbol) {
  std::vector<std::set<std::string>> given;
  for (const Rule& rule : rules.rules) given.push_back(SymbolsIn(rule.body));
  std::set<std::string> leading = {symbol};
  for (size_t before = 0; before != leading.size();) {
    before = leading.size();
    for (size_t i = 0; i < given.size(); ++i) {
      const bool leads = std::any_of(given[i].begin(), given[i].end(),
                                     [&](const auto& one) { return leading.contains(one); });
      if (leads) leading.insert(rules.rules[i].symbol);
    }
  }
  return leading;
}

void Apply(const LayerEdits& edits, LayeredRule* listed) {
  for (ListedLayer& layer : listed->layers) {
    const std::string full = LayerName(listed->rule, layer.name);
    layer.on = std::find(edits.off.begin(), edits.off.end(), full) == edits.off.end();
    for (const auto& [name, symbol] : edits.rules) {
      if (name == full) layer.symbol = symbol;
    }
  }
  for (const auto& [rule, order] : edits.order) {
    if (rule != listed->rule) continue;
    const auto rank = [&order = order](const ListedLayer& layer) {
      return std::find(order.begin(), order.end(), layer.name) - order.begin();
    };
    std::stable_sort(listed->layers.begin(), listed->layers.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  }
}

/// The names of a rule's layers from the deepest up.
std::vector<std::string> OrderOf(const LayeredRule& listed) {
  std::vector<std::string> order;
  for (const ListedLayer& layer : listed.layers) order.insert(order.begin(), layer.name);
  return order;
}

}  // namespace

std::vector<LayeredRule> ListLayers(const RuleSet& rules, const LayerEdits& edits) {
  std::vector<LayeredRule> all;
  for (const Rule& rule : rules.rules) {
    auto listed = std::find_if(all.begin(), all.end(),
                               [&](const LayeredRule& one) { return one.rule == rule.symbol; });
    if (listed == all.end()) listed = all.insert(all.end(), LayeredRule{rule.symbol, {}});
    AddLayers(rule.body, &listed->layers);
  }
  std::erase_if(all, [](const LayeredRule& one) { return one.layers.empty(); });
  for (LayeredRule& listed : all) {
    Apply(edits, &listed);
    std::reverse(listed.layers.begin(), listed.layers.end());
  }
  return all;
}

std::vector<std::string> SymbolsForLayers(const RuleSet& rules, const std::string& rule) {
  const std::set<std::string> leading = LeadingTo(rules, rule);
  std::vector<std::string> symbols;
  for (const Rule& one : rules.rules) {
    if (one.parameters.empty() && !leading.contains(one.symbol)) symbols.push_back(one.symbol);
  }
  return symbols;
}

LayerEdits Switched(LayerEdits edits, const std::string& rule, const std::string& layer, bool on) {
  std::erase(edits.off, LayerName(rule, layer));
  if (!on) edits.off.push_back(LayerName(rule, layer));
  return edits;
}

LayerEdits Given(LayerEdits edits, const std::string& rule, const std::string& layer,
                 const std::string& symbol) {
  const std::string full = LayerName(rule, layer);
  std::erase_if(edits.rules, [&](const auto& one) { return one.first == full; });
  if (!symbol.empty()) edits.rules.emplace_back(full, symbol);
  return edits;
}

LayerEdits Moved(LayerEdits edits, const RuleSet& rules, const LayeredRule& listed, size_t from,
                 size_t to) {
  LayeredRule moved = listed;
  const auto at = [&](size_t i) { return moved.layers.begin() + static_cast<std::ptrdiff_t>(i); };
  if (from < to) std::rotate(at(from), at(from + 1), at(to + 1));
  if (to < from) std::rotate(at(to), at(from), at(from + 1));
  std::erase_if(edits.order, [&](const auto& one) { return one.first == listed.rule; });
  for (const LayeredRule& own : ListLayers(rules, {})) {
    if (own.rule != listed.rule || OrderOf(own) == OrderOf(moved)) continue;
    edits.order.emplace_back(listed.rule, OrderOf(moved));
  }
  return edits;
}

}  // namespace parti::grammar
