// The checker's parts: declarations, bodies and expressions share names and types. For
// rule_check*.cc only; CheckRules (rule_check.h) is what others call.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/operation.h"
#include "grammar/rules/rule_check.h"
#include "grammar/rules/rule_names.h"

namespace parti::grammar {

/// Nothing: not known yet.
using MaybeType = std::optional<ValueType>;

/// What a value is for: its type, and words for messages: "the distance of extrude".
struct Expected {
  MaybeType type;
  std::string_view role;
  std::string_view of = {};
};

/// Walks all declarations, several times over.
class RuleChecker {
 public:
  RuleChecker(const std::deque<RuleModule>& modules, std::string_view style, RuleErrors* errors);
  /// All walks; once.
  RuleSet Check();

 private:
  /// A declaration that holds.
  struct Declared {
    const RuleModule* module;
    const WrittenDeclaration* written;
    std::vector<MaybeType> parameters;
    MaybeType type;         ///< of an attribute's or a function's value
    bool is_named = false;  ///< a rule: something refers to it
  };
  /// A terminal symbol: where it stands first.
  struct Terminal {
    TextRange range;
    std::string_view prefix;
  };

  // rule_check.cc: declarations
  void Declare(const RuleModule& module, std::string_view style);
  void Declare(const RuleModule& module, const WrittenDeclaration& written);
  void Pass();
  void CheckAttribute(Declared* declared, Attribute* attribute);
  bool ImportedValue(const Declared& declared, Expression* value);
  void CheckImport(const RuleModule& module);
  void CheckFunction(Declared* declared, RuleFunction* function);
  void CheckRule(Declared* declared, Rule* rule);
  std::vector<RuleParameter> ParametersOf(const Declared& declared) const;
  void CheckTerminals();
  void CheckCycles();

  // rule_annotations.cc
  void CheckAnnotations(const WrittenDeclaration& written);
  void Annotate(const Declared& declared, Attribute* attribute);
  void AnnotateWith(const WrittenAnnotation& annotation, Attribute* attribute);
  void AnnotateRange(const WrittenAnnotation& annotation, Attribute* attribute);
  void AddChoice(const WrittenExpression& written, Attribute* attribute);
  std::optional<Value> Plain(const WrittenExpression& written);

  // rule_check_body.cc: bodies, statements, symbols
  Body Resolve(const WrittenBody& written);
  void CheckBrackets(const std::vector<WrittenStatement>& statements);
  void CheckWeights(Body* body);
  std::optional<Statement> Resolve(const WrittenStatement& written);
  std::optional<Statement> ResolveSymbol(const WrittenStatement& written);
  std::optional<Statement> ResolveSet(const WrittenStatement& written);
  std::optional<Statement> ResolveMaterial(const WrittenStatement& written);
  void RefuseSymbol(const WrittenStatement& written, const std::vector<size_t>& counts);
  void RefuseUnknown(const WrittenStatement& written);
  void CheckParts(const WrittenStatement& written);
  void CheckParts(const WrittenAlternative& written);

  // rule_check_operation.cc: operations
  std::optional<Statement> ResolveOperation(const WrittenStatement& written, const Operation& row);
  bool Bind(const WrittenStatement& written, Statement* statement, size_t* used);
  std::optional<RuleArgument> Argue(const WrittenArgument& written, const Operation& row,
                                    const Parameter& parameter);
  std::optional<RuleArgument> ArgueNumber(const WrittenArgument& written, const Operation& row,
                                          const Parameter& parameter);
  bool IsNumber(const WrittenArgument& written);
  void CheckConstant(const WrittenArgument& written, const Operation& row,
                     const Parameter& parameter, const RuleArgument& argument);
  bool RefuseExtra(const WrittenStatement& written, const Operation& row, size_t used);
  bool CheckBraces(const WrittenStatement& written, const Operation& row);
  /// Keys that stand in the parentheses; taken one by one by the alternatives.
  struct Keys {
    const std::vector<WrittenArgument>* list;
    size_t first, next;
    bool complete;  ///< no alternative was lost to an error
    bool given() const { return first < list->size(); }
  };
  std::vector<SuccessorRule> Resolve(const std::vector<WrittenAlternative>& written,
                                     const Operation& row, Keys* keys, int depth);
  void SetKey(const WrittenAlternative& written, const Operation& row, Keys* keys,
              SuccessorRule* successor);
  void RefuseKeyless(const WrittenAlternative& written, const Operation& row);
  void SetSize(const WrittenArgument& key, SuccessorRule* successor);
  void SetSelector(const WrittenArgument& key, const Operation& row, SuccessorRule* successor);

  // rule_check_expression.cc: values
  Expression Resolve(const WrittenExpression& written, const Expected& expected,
                     MaybeType* type = nullptr);
  MaybeType ResolveName(const WrittenExpression& written, Expression* expression);
  MaybeType ResolveCall(const WrittenExpression& written, Expression* expression);
  bool IsWordOf(const BuiltIn& row, const WrittenExpression& operand) const;
  void CheckOperands(const WrittenExpression& call);
  MaybeType ResolveOperator(const WrittenExpression& written, const Expected& expected,
                            Expression* expression);
  MaybeType ResolveComparison(const WrittenExpression& written, Expression* expression);
  MaybeType ResolveChoice(const WrittenExpression& written, const Expected& expected,
                          Expression* expression);
  void CheckWeights(const WrittenExpression& written, Expression* expression);
  bool CheckWeights(const std::vector<const Expression*>& weights, bool has_else, TextRange range);
  void Learn(const Expression& expression, MaybeType type);
  void RefuseName(const WrittenExpression& written);
  std::optional<std::string> ValueLike(std::string_view name) const;
  std::string FullName(const std::string& name) const { return module_->prefix + name; }
  bool IsLost(std::string_view name) const;
  uint32_t ParameterNamed(std::string_view name) const;

  // all
  void Report(TextRange range, ErrorCode code, std::string message, std::string hint = {});
  void Report(TextRange range, Error error);
  void ReportUnknown(TextRange range, const std::string& what, std::string hint,
                     bool can_be_skipped);
  void Set(MaybeType* known, MaybeType type);

  const std::deque<RuleModule>& modules_;
  std::string_view style_;
  RuleErrors* errors_;
  RuleNames names_;
  std::vector<Declared> attributes_, functions_, rules_;
  std::map<std::string, Terminal> terminals_;
  RuleSet set_;
  bool reporting_ = false;
  bool learns_from_calls_ = false;
  bool changed_ = false;
  // Where the walk is:
  const RuleModule* module_ = nullptr;
  Declared* inside_ = nullptr;  ///< whose parameters are seen; null in an attribute
};

}  // namespace parti::grammar
