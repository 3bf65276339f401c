#include "grammar/rules/rule_names.h"

namespace parti::grammar {
namespace {

using Counted = std::map<std::pair<std::string, size_t>, uint32_t>;

uint32_t Find(const Counted& names, const std::string& name, size_t count) {
  const auto found = names.find({name, count});
  return found == names.end() ? RuleNames::kNone : found->second;
}

std::vector<size_t> CountsOf(const Counted& names, const std::string& name) {
  std::vector<size_t> counts;
  for (auto i = names.lower_bound({name, 0}); i != names.end() && i->first.first == name; ++i) {
    counts.push_back(i->first.second);
  }
  return counts;
}

void AddWithout(std::string_view prefix, const std::string& name, std::vector<std::string>* list) {
  if (name.starts_with(prefix)) list->push_back(name.substr(prefix.size()));
}

}  // namespace

bool RuleNames::AddAttribute(const std::string& name, uint32_t index) {
  return attributes_.try_emplace(name, index).second;
}

bool RuleNames::AddFunction(const std::string& name, size_t parameters, uint32_t index) {
  return functions_.try_emplace({name, parameters}, index).second;
}

bool RuleNames::AddRule(const std::string& name, size_t parameters, uint32_t index) {
  return rules_.try_emplace({name, parameters}, index).second;
}

uint32_t RuleNames::Attribute(const std::string& name) const {
  const auto found = attributes_.find(name);
  return found == attributes_.end() ? kNone : found->second;
}

uint32_t RuleNames::Function(const std::string& name, size_t arguments) const {
  return Find(functions_, name, arguments);
}

uint32_t RuleNames::Rule(const std::string& name, size_t arguments) const {
  return Find(rules_, name, arguments);
}

std::vector<size_t> RuleNames::FunctionsNamed(const std::string& name) const {
  return CountsOf(functions_, name);
}

std::vector<size_t> RuleNames::RulesNamed(const std::string& name) const {
  return CountsOf(rules_, name);
}

std::vector<std::string> RuleNames::Values(std::string_view prefix) const {
  std::vector<std::string> names;
  for (const auto& [name, index] : attributes_) AddWithout(prefix, name, &names);
  for (const auto& [key, index] : functions_) AddWithout(prefix, key.first, &names);
  return names;
}

std::vector<std::string> RuleNames::Rules(std::string_view prefix) const {
  std::vector<std::string> names;
  for (const auto& [key, index] : rules_) AddWithout(prefix, key.first, &names);
  return names;
}

}  // namespace parti::grammar
