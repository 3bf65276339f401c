// The names that modules declare, in full ("roof.slope"), and what they stand for in a RuleSet.
// The language's own names are built_ins.h's and the operation table's.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace parti::grammar {

/// Attributes by name; functions and rules by name and number of parameters.
class RuleNames {
 public:
  static constexpr uint32_t kNone = 0xffffffff;

  /// False where the name is taken.
  bool AddAttribute(const std::string& name, uint32_t index);
  bool AddFunction(const std::string& name, size_t parameters, uint32_t index);
  bool AddRule(const std::string& name, size_t parameters, uint32_t index);

  /// kNone where there is none.
  uint32_t Attribute(const std::string& name) const;
  uint32_t Function(const std::string& name, size_t arguments) const;
  uint32_t Rule(const std::string& name, size_t arguments) const;
  /// How many parameters something of this name takes; empty where nothing has it.
  std::vector<size_t> FunctionsNamed(const std::string& name) const;
  std::vector<size_t> RulesNamed(const std::string& name) const;

  /// Without `prefix`: what a module calls them. For "did you mean".
  std::vector<std::string> Values(std::string_view prefix) const;
  std::vector<std::string> Rules(std::string_view prefix) const;

 private:
  using Counted = std::map<std::pair<std::string, size_t>, uint32_t>;
  std::map<std::string, uint32_t> attributes_;
  Counted functions_, rules_;
};

}  // namespace parti::grammar
