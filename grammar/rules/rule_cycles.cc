#include "grammar/rules/rule_cycles.h"

#include <algorithm>

namespace parti::grammar {
namespace {

/// Attributes, then functions, as one row of numbers.
using Edges = std::vector<std::vector<uint32_t>>;

void AddNeeds(const Expression& expression, uint32_t attributes, std::vector<uint32_t>* needs) {
  if (expression.kind == Expression::Kind::kAttribute) needs->push_back(expression.index);
  if (expression.kind == Expression::Kind::kCall) needs->push_back(attributes + expression.index);
  for (const Expression& operand : expression.operands) AddNeeds(operand, attributes, needs);
}

Edges NeedsOf(const RuleSet& rules) {
  const auto attributes = static_cast<uint32_t>(rules.attributes.size());
  Edges edges(attributes + rules.functions.size());
  for (uint32_t i = 0; i < edges.size(); ++i) {
    const Expression& value =
        i < attributes ? rules.attributes[i].value : rules.functions[i - attributes].value;
    AddNeeds(value, attributes, &edges[i]);
  }
  return edges;
}

/// Strongly connected components (Tarjan 1972), without recursion.
class Components {
 public:
  explicit Components(const Edges& edges)
      : edges_(edges), order_(edges.size(), 0), low_(edges.size(), 0), on_path_(edges.size()) {
    for (uint32_t i = 0; i < edges.size(); ++i) {
      if (order_[i] == 0) Visit(i);
    }
  }

  /// Those of more than one, and those that lead to themselves.
  const std::vector<std::vector<uint32_t>>& cycles() const { return cycles_; }

 private:
  struct Step {
    uint32_t node;
    size_t next;  ///< of its edges
  };

  void Enter(uint32_t node) {
    order_[node] = low_[node] = ++count_;
    on_path_[node] = true;
    path_.push_back(node);
    steps_.push_back({node, 0});
  }

  void Visit(uint32_t root) {
    Enter(root);
    while (!steps_.empty()) {
      Step& step = steps_.back();
      const uint32_t node = step.node;
      if (step.next < edges_[node].size()) {
        const uint32_t to = edges_[node][step.next++];
        if (order_[to] == 0) {
          Enter(to);
        } else if (on_path_[to]) {
          low_[node] = std::min(low_[node], order_[to]);
        }
        continue;
      }
      steps_.pop_back();
      if (!steps_.empty())
        low_[steps_.back().node] = std::min(low_[steps_.back().node], low_[node]);
      if (low_[node] == order_[node]) Leave(node);
    }
  }

  void Leave(uint32_t root) {
    std::vector<uint32_t> component;
    do {
      component.push_back(path_.back());
      on_path_[path_.back()] = false;
      path_.pop_back();
    } while (component.back() != root);
    const auto& own = edges_[root];
    const bool is_loop = std::find(own.begin(), own.end(), root) != own.end();
    if (component.size() > 1 || is_loop) cycles_.push_back(std::move(component));
  }

  const Edges& edges_;
  std::vector<uint32_t> order_, low_;
  std::vector<bool> on_path_;
  std::vector<uint32_t> path_;
  std::vector<Step> steps_;
  std::vector<std::vector<uint32_t>> cycles_;
  uint32_t count_ = 0;
};

}  // namespace

std::vector<uint32_t> AttributesThatNeedThemselves(const RuleSet& rules) {
  std::vector<uint32_t> found;
  const Edges needs = NeedsOf(rules);
  const Components components(needs);
  for (const auto& cycle : components.cycles()) {
    for (const uint32_t node : cycle) {
      if (node < rules.attributes.size()) found.push_back(node);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace parti::grammar
