// The parser's parts: expressions, bodies and declarations share one lexer. For rule_parser*.cc
// only; ReadRules (rule_syntax.h) is what others call.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grammar/lexer.h"
#include "grammar/rules/rule_operators.h"
#include "grammar/rules/rule_syntax.h"

namespace parti::grammar {

/// Words of the language: no symbol, attribute, function or parameter has such a name.
bool IsRuleWord(std::string_view name);
/// Annotations that CGA has, whether or not they mean something here.
bool IsAnnotation(std::string_view name);

/// One more level of what calls itself while it lives.
class Nesting {
 public:
  explicit Nesting(int* depth) : depth_(depth) { ++*depth_; }
  ~Nesting() { --*depth_; }
  Nesting(const Nesting&) = delete;
  Nesting& operator=(const Nesting&) = delete;
  int depth() const { return *depth_; }

 private:
  int* depth_;
};

/// Reads one text. Every Read… returns false, or nothing, after it has reported an error; whoever
/// can go on then skips to where its next part starts.
class RuleParser {
 public:
  RuleParser(std::string_view text, uint32_t file, RuleErrors* errors);
  /// To the end of the text; once.
  WrittenRules Read();

 private:
  // rule_parser.cc: declarations
  void ReadStatement();
  bool ReadAnnotations(std::vector<WrittenAnnotation>* annotations);
  bool ReadAnnotation(WrittenAnnotation* annotation);
  bool ReadVersion();
  void ReadTreeBlock();
  bool ReadImport();
  bool ReadImportAttributes(WrittenImport* import);
  bool ReadStyle();
  void EndStyle(size_t offset);
  bool ReadAttribute(WrittenDeclaration* declaration);
  bool ReadRuleOrFunction(WrittenDeclaration* declaration);
  bool ReadParameters(std::vector<WrittenParameter>* parameters);
  bool ReadName(std::string* name, TextRange* range, std::string_view wanted);
  void Add(WrittenDeclaration declaration);
  void SkipToDeclaration();
  bool AtDeclaration() const;
  static bool DeclarationFollows(Lexer ahead, bool or_function);
  bool AtAnnotation() const;

  // rule_parser_body.cc: bodies and what stands in braces
  bool ReadBody(WrittenBody* body);
  bool ReadCases(WrittenBody* body);
  bool ReadChances(WrittenBody* body);
  bool ReadChosen(WrittenBody::Alternative* alternative);
  bool ReadSequence(WrittenBody* body);
  bool ReadStep(WrittenStatement* statement);
  bool ReadArguments(std::vector<WrittenArgument>* arguments);
  bool ReadArgument(WrittenArgument* argument);
  bool ReadBranch(WrittenBody* body);
  bool ReadBraces(std::vector<WrittenAlternative>* alternatives);
  bool ReadAlternatives(std::vector<WrittenAlternative>* alternatives);
  bool ReadAlternative(WrittenAlternative* alternative);
  bool AtKey() const;
  static bool AtEqualsAlone(Lexer at);
  bool AtBodyEnd() const;
  bool SkipToAlternative(int braces);

  // rule_parser_expression.cc: values
  bool ReadValue(WrittenExpression* value);
  bool ReadCaseValue(WrittenExpression* value);
  bool ReadChanceValue(WrittenExpression* value);
  bool ReadElse();
  bool ReadWeight(WrittenExpression* weight);
  bool AtWeight() const;
  bool ReadExpression(WrittenExpression* expression, int above = 0);
  bool ReadOperand(WrittenExpression* operand);
  bool ReadNamed(WrittenExpression* operand);
  bool RefuseArray(TextRange range);
  bool ReadOperands(WrittenExpression* call);
  bool ReadSigned(WrittenExpression* operand);
  const RuleOperator* AtOperator() const;
  void ReadDotted(std::string* name);
  bool Deepen(WrittenExpression* parent);

  // all
  bool Expect(char mark, std::string_view wanted);
  bool Unexpected(std::string_view wanted);
  bool Fail(TextRange range, ErrorCode code, std::string message, std::string hint = {});
  TextRange RangeOf(const Token& token) const;
  TextRange RangeFrom(size_t from) const;
  bool Enter(const Nesting& nesting, int deepest, std::string_view what);

  std::string_view text_;
  uint32_t file_;
  RuleErrors* errors_;
  Lexer lexer_;
  WrittenRules rules_;
  bool in_style_ = false;
  const WrittenDeclaration* rule_ = nullptr;  ///< whose body is being read
  bool in_brackets_ = false;                  ///< of a choice: a ] ends it
  int branches_ = 0;                          ///< rules made of choices in brackets
  bool first_ = false;                        ///< nothing of the rule's body has been read
  int rule_braces_ = 0;                       ///< braces that were open before the rule
  size_t failures_ = 0;
  int expression_depth_ = 0;
  int body_depth_ = 0;
};

}  // namespace parti::grammar
