#include "grammar/rules/layer_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "grammar/operation.h"
#include "grammar/rules/visit_statements.h"

namespace parti::grammar {
namespace {

bool LaysOut(const Statement& statement) {
  return statement.kind == Statement::Kind::kOperation &&
         statement.operation->braces == Braces::kNames;
}

std::string NameOf(const SuccessorRule& layer) {
  const auto* name = std::get_if<std::string>(&layer.key);
  return name != nullptr ? *name : std::string();
}

/// The edits that concern one rule.
struct RuleEdits {
  std::vector<std::string> off;
  std::vector<std::pair<std::string, std::string>> rules;
  std::vector<std::string> order;
};

void MakeSymbol(const RuleSet& rules, const std::string& symbol, SuccessorRule* layer) {
  Statement statement;
  statement.kind = Statement::Kind::kSymbol;
  statement.symbol = symbol;
  statement.index = RuleFor(rules, symbol);
  statement.range = layer->range;
  layer->body = Body();
  layer->body.range = layer->range;
  layer->body.statements.push_back(std::move(statement));
}

class Editor {
 public:
  Editor(const RuleSet& rules, const RuleEdits& edits) : rules_(rules), edits_(edits) {}

  void Edit(Body* body) const {
    for (Statement& statement : body->statements) {
      if (LaysOut(statement)) EditLayers(&statement.successors);
      for (SuccessorRule& one : statement.successors) Edit(&one);
    }
    std::erase_if(body->statements,
                  [](const Statement& one) { return LaysOut(one) && one.successors.empty(); });
    for (Body::Alternative& one : body->alternatives) {
      auto edited = std::make_shared<Body>(*one.body);
      Edit(edited.get());
      one.body = std::move(edited);
    }
  }

 private:
  void Edit(SuccessorRule* successor) const {
    Edit(&successor->body);
    for (SuccessorRule& one : successor->repeat) Edit(&one);
  }

  void EditLayers(std::vector<SuccessorRule>* layers) const {
    std::erase_if(*layers, [&](const SuccessorRule& layer) {
      return std::find(edits_.off.begin(), edits_.off.end(), NameOf(layer)) != edits_.off.end();
    });
    for (SuccessorRule& layer : *layers) {
      for (const auto& [name, symbol] : edits_.rules) {
        if (name == NameOf(layer)) MakeSymbol(rules_, symbol, &layer);
      }
    }
    std::stable_sort(
        layers->begin(), layers->end(),
        [&](const SuccessorRule& a, const SuccessorRule& b) { return RankOf(a) < RankOf(b); });
  }

  std::ptrdiff_t RankOf(const SuccessorRule& layer) const {
    return std::find(edits_.order.begin(), edits_.order.end(), NameOf(layer)) -
           edits_.order.begin();
  }

  const RuleSet& rules_;
  const RuleEdits& edits_;
};

/// "Facade.door" as rule and layer; imported rules have dots in their own names.
std::pair<std::string, std::string> Parts(const std::string& name) {
  const size_t dot = name.rfind('.');
  if (dot == std::string::npos) return {name, ""};
  return {name.substr(0, dot), name.substr(dot + 1)};
}

RuleEdits EditsOf(const LayerEdits& edits, const std::string& rule) {
  RuleEdits own;
  for (const std::string& name : edits.off) {
    if (Parts(name).first == rule) own.off.push_back(Parts(name).second);
  }
  for (const auto& [name, symbol] : edits.rules) {
    if (Parts(name).first == rule) own.rules.emplace_back(Parts(name).second, symbol);
  }
  for (const auto& [name, order] : edits.order) {
    if (name == rule) own.order = order;
  }
  return own;
}

Result<void> CheckEdits(const RuleSet& rules, const LayerEdits& edits) {
  const auto known = LayerNames(rules);
  std::vector<std::string> names = edits.off;
  std::vector<std::string> symbols;
  for (const Rule& rule : rules.rules) symbols.push_back(rule.symbol);
  for (const auto& [name, symbol] : edits.rules) {
    names.push_back(name);
    if (RuleFor(rules, symbol) != kNoRule) continue;
    const auto meant = DidYouMean(symbol, symbols);
    return Fail(ErrorCode::kUnknownName, fmt::format("there is no rule for '{}'", symbol),
                meant ? fmt::format("did you mean '{}'?", *meant) : "");
  }
  for (const auto& [rule, order] : edits.order) {
    for (const std::string& layer : order) names.push_back(LayerName(rule, layer));
  }
  for (const std::string& name : names) {
    if (const auto good = CheckLayer(name, known); !good) return good;
  }
  return {};
}

}  // namespace

std::string LayerName(const std::string& rule, const std::string& layer) {
  return fmt::format("{}.{}", rule, layer);
}

std::vector<std::string> LayerNames(const RuleSet& rules) {
  std::vector<std::string> names;
  for (const Rule& rule : rules.rules) {
    VisitStatements(rule.body, [&](const Statement& statement) {
      if (!LaysOut(statement)) return;
      for (const SuccessorRule& layer : statement.successors) {
        names.push_back(LayerName(rule.symbol, NameOf(layer)));
      }
    });
  }
  return names;
}

Result<void> CheckLayer(const std::string& name, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return {};
  const auto meant = DidYouMean(name, known);
  return Fail(ErrorCode::kUnknownName, fmt::format("there is no layer '{}'", name),
              meant           ? fmt::format("did you mean '{}'?", *meant)
              : known.empty() ? "the rules have no layers"
                              : fmt::format("layers are {}", fmt::join(known, ", ")));
}

Result<RuleSet> WithLayers(RuleSet rules, const LayerEdits& edits) {
  if (const auto good = CheckEdits(rules, edits); !good) return Fail(good);
  const RuleSet known = rules;
  for (Rule& rule : rules.rules) {
    const RuleEdits own = EditsOf(edits, rule.symbol);
    Editor(known, own).Edit(&rule.body);
  }
  return rules;
}

}  // namespace parti::grammar
