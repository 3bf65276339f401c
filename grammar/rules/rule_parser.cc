// Declarations of a rule file: attributes, functions, rules, imports, styles and trees.
#include "grammar/rules/rule_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "grammar/tree_text.h"

namespace parti::grammar {
namespace {

using Kind = Token::Kind;

constexpr std::array<std::string_view, 12> kWords = {"attr",    "case",      "const", "else",
                                                     "extends", "extension", "false", "import",
                                                     "style",   "tree",      "true",  "version"};
constexpr std::array<std::string_view, 20> kAnnotations = {
    "Angle", "Color",  "Description", "Directory", "Distance",  "Enum",  "File",
    "Group", "Handle", "Hidden",      "In",        "Inline",    "InOut", "Local",
    "Order", "Out",    "Percent",     "Range",     "StartRule", "Vector"};

bool IsOneOf(std::span<const std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The byte of `text` that a place names.
size_t OffsetOf(std::string_view text, const SourcePlace& place) {
  size_t start = 0;
  for (int line = 1; line < place.line; ++line) {
    const size_t end = text.find('\n', start);
    if (end == std::string_view::npos) break;
    start = end + 1;
  }
  return start + static_cast<size_t>(place.column - 1);
}

}  // namespace

bool IsRuleWord(std::string_view name) { return IsOneOf(kWords, name); }
bool IsAnnotation(std::string_view name) { return IsOneOf(kAnnotations, name); }

RuleParser::RuleParser(std::string_view text, uint32_t file, RuleErrors* errors)
    : text_(text), file_(file), errors_(errors), lexer_(text, {}, Lexer::Hash::kComment) {}

WrittenRules RuleParser::Read() {
  while (!lexer_.At(Kind::kEnd) && !errors_->Full()) {
    if (!lexer_.Accept(';')) ReadStatement();
  }
  EndStyle(text_.size());
  return std::move(rules_);
}

void RuleParser::ReadStatement() {
  const size_t start = lexer_.Peek().offset;
  const size_t failures = failures_;
  WrittenDeclaration declaration;
  bool good = ReadAnnotations(&declaration.annotations);
  if (good && AtTree(lexer_)) {
    EndStyle(start);
    return ReadTreeBlock();
  }
  if (good && lexer_.AtWord("style")) {
    EndStyle(start);
    good = ReadStyle();
  } else if (good && lexer_.AtWord("version")) {
    good = ReadVersion();
  } else if (good && lexer_.AtWord("import")) {
    good = ReadImport();
  } else if (good) {
    const bool value = lexer_.AtWord("attr") || lexer_.AtWord("const");
    good = value ? ReadAttribute(&declaration) : ReadRuleOrFunction(&declaration);
    declaration.broken = failures_ != failures;
    if (!declaration.name.empty()) Add(std::move(declaration));
  }
  if (!good) SkipToDeclaration();
}

void RuleParser::Add(WrittenDeclaration declaration) {
  auto& list = in_style_ ? rules_.styles.back().declarations : rules_.declarations;
  list.push_back(std::move(declaration));
}

bool RuleParser::ReadVersion() {
  lexer_.Next();
  if (!lexer_.At(Kind::kText)) return Unexpected("a version in quotes");
  rules_.version = lexer_.Next().text;
  return true;
}

void RuleParser::ReadTreeBlock() {
  std::vector<Error> errors;
  rules_.trees.push_back(ReadTree(&lexer_, &errors));
  for (Error& error : errors) {
    const auto from = static_cast<uint32_t>(OffsetOf(text_, *error.place));
    const auto length = static_cast<uint32_t>(error.place->length);
    errors_->Report({file_, from, from + length}, std::move(error));
  }
}

bool RuleParser::ReadAttribute(WrittenDeclaration* declaration) {
  declaration->kind = lexer_.AtWord("const") ? WrittenDeclaration::Kind::kConstant
                                             : WrittenDeclaration::Kind::kAttribute;
  lexer_.Next();
  return ReadName(&declaration->name, &declaration->range, "a name") &&
         Expect('=', "'=' and a value") && ReadValue(&declaration->value);
}

bool RuleParser::ReadRuleOrFunction(WrittenDeclaration* declaration) {
  lexer_.AcceptWord("extension");  // CGA: an importing file may replace this rule
  if (!ReadName(&declaration->name, &declaration->range, "a rule: Symbol --> …")) return false;
  if (lexer_.At('(') && !ReadParameters(&declaration->parameters)) return false;
  if (lexer_.Accept('=')) {
    declaration->kind = WrittenDeclaration::Kind::kFunction;
    return ReadValue(&declaration->value);
  }
  if (!lexer_.At(Kind::kArrow)) return Unexpected("'-->' after the symbol of a rule");
  lexer_.Next();
  rule_braces_ = lexer_.open_braces();
  first_ = true;
  rule_ = declaration;
  in_brackets_ = false;
  if (!ReadBody(&declaration->body)) return false;
  if (lexer_.At(Kind::kEnd) || lexer_.Accept(';') || AtDeclaration() || AtAnnotation()) return true;
  return Unexpected("an operation, a symbol or the next rule");
}

bool RuleParser::ReadParameters(std::vector<WrittenParameter>* parameters) {
  lexer_.Next();
  if (lexer_.Accept(')')) return true;
  do {
    WrittenParameter parameter;
    if (!ReadName(&parameter.name, &parameter.range, "the name of a parameter")) return false;
    const bool again = std::any_of(parameters->begin(), parameters->end(),
                                   [&](const auto& other) { return other.name == parameter.name; });
    if (again) {
      return Fail(parameter.range, ErrorCode::kBadText,
                  fmt::format("two parameters have the name '{}'", parameter.name));
    }
    parameters->push_back(std::move(parameter));
  } while (lexer_.Accept(','));
  return Expect(')', "',' or ')'");
}

bool RuleParser::ReadName(std::string* name, TextRange* range, std::string_view wanted) {
  if (!lexer_.At(Kind::kName)) return Unexpected(wanted);
  const Token token = lexer_.Next();
  *range = RangeOf(token);
  if (IsRuleWord(token.text) || token.text == kNil) {
    return Fail(*range, ErrorCode::kBadText,
                fmt::format("'{}' is a word of the language", token.text), "choose another name");
  }
  *name = token.text;
  return true;
}

bool RuleParser::ReadImport() {
  const Token import = lexer_.Next();
  if (in_style_) {
    return Fail(RangeOf(import), ErrorCode::kBadText, "an import stands before the styles");
  }
  WrittenImport result;
  if (!ReadName(&result.prefix, &result.range, "a prefix: import roof : \"roof.cga\""))
    return false;
  if (lexer_.Accept('(')) {
    TextRange range;
    if (!ReadName(&result.style, &range, "the name of a style") || !Expect(')', "')'"))
      return false;
  }
  if (!Expect(':', "':' and the file in quotes")) return false;
  if (!lexer_.At(Kind::kText)) return Unexpected("the file in quotes");
  result.range = RangeOf(lexer_.Peek());
  result.path = lexer_.Next().text;
  if (lexer_.Accept('(') && !ReadImportAttributes(&result)) return false;
  rules_.imports.push_back(std::move(result));
  return true;
}

bool RuleParser::ReadImportAttributes(WrittenImport* import) {
  import->protects = lexer_.Accept(')');
  if (import->protects) return true;
  do {
    WrittenImport::Attribute attribute;
    const size_t from = lexer_.Peek().offset;
    if (!lexer_.At(Kind::kName)) return Unexpected("an attribute of the imported file");
    ReadDotted(&attribute.name);
    attribute.range = RangeFrom(from);
    if (lexer_.Accept('=') && !ReadExpression(&attribute.value.emplace_back())) return false;
    if (import->attributes.size() == kMostImportAttributes) {
      return Fail(attribute.range, ErrorCode::kLimitReached,
                  fmt::format("an import has {} attributes at most", kMostImportAttributes));
    }
    import->attributes.push_back(std::move(attribute));
  } while (lexer_.Accept(','));
  return Expect(')', "',' or ')'");
}

bool RuleParser::ReadStyle() {
  lexer_.Next();
  WrittenStyle style;
  if (!ReadName(&style.name, &style.range, "the name of a style")) return false;
  style.base_range = style.range;
  if (rules_.styles.size() == kMostStyles) {
    return Fail(style.range, ErrorCode::kLimitReached,
                fmt::format("a file has {} styles at most", kMostStyles));
  }
  if (lexer_.AcceptWord("extends") &&
      !ReadName(&style.base, &style.base_range, "the name of a style")) {
    return false;
  }
  style.text = {file_, static_cast<uint32_t>(lexer_.previous_end()), 0};
  rules_.styles.push_back(std::move(style));
  in_style_ = true;
  return true;
}

void RuleParser::EndStyle(size_t offset) {
  if (in_style_) rules_.styles.back().text.to = static_cast<uint32_t>(offset);
  in_style_ = false;
}

bool RuleParser::ReadAnnotations(std::vector<WrittenAnnotation>* annotations) {
  while (lexer_.At('@')) {
    if (!ReadAnnotation(&annotations->emplace_back())) return false;
  }
  return true;
}

bool RuleParser::ReadAnnotation(WrittenAnnotation* annotation) {
  const size_t from = lexer_.Next().offset;
  if (!lexer_.At(Kind::kName)) return Unexpected("the name of an annotation");
  annotation->name = lexer_.Next().text;
  annotation->range = RangeFrom(from);
  if (!lexer_.Accept('(') || lexer_.Accept(')')) return true;
  do {
    WrittenAnnotation::Argument& argument = annotation->arguments.emplace_back();
    Lexer ahead = lexer_;
    if (ahead.Next().kind == Kind::kName && ahead.At('=')) {
      argument.name = lexer_.Next().text;
      lexer_.Next();
    }
    if (!ReadExpression(&argument.value)) return false;
  } while (lexer_.Accept(','));
  return Expect(')', "',' or ')'");
}

void RuleParser::SkipToDeclaration() {
  for (; !lexer_.At(Kind::kEnd); lexer_.Next()) {
    const bool starts = lexer_.Peek().starts_line;
    if (starts && (AtTree(lexer_) || DeclarationFollows(lexer_, /*or_function=*/true))) return;
    if (starts && lexer_.At('@') && AtAnnotation()) return;
  }
}

bool RuleParser::AtDeclaration() const {
  const bool outside = lexer_.open_braces() <= rule_braces_;
  if (!outside && !lexer_.Peek().starts_line) return false;
  return AtTree(lexer_) || DeclarationFollows(lexer_, outside);
}

bool RuleParser::DeclarationFollows(Lexer ahead, bool or_function) {
  if (!ahead.At(Kind::kName)) return false;
  const std::string first = ahead.Next().text;
  if (first == "version") return ahead.At(Kind::kText);
  if (IsRuleWord(first)) {
    return first != "case" && first != "else" && ahead.At(Kind::kName);
  }
  if (ahead.Accept('(')) {
    while (ahead.At(Kind::kName) || ahead.At(',')) ahead.Next();
    if (!ahead.Accept(')')) return false;
  }
  if (ahead.At(Kind::kArrow)) return true;
  if (!or_function || !ahead.Accept('=')) return false;
  return !(ahead.At('=') && ahead.Touching());
}

bool RuleParser::AtAnnotation() const {
  if (!lexer_.At('@') || lexer_.open_braces() > rule_braces_) return false;
  Lexer ahead = lexer_;
  ahead.Next();
  const bool known = ahead.At(Kind::kName) && IsAnnotation(ahead.Peek().text);
  // "A --> @B" defers B wherever the line breaks; elsewhere a line that starts with @ annotates.
  return known || (lexer_.Peek().starts_line && !first_);
}

bool RuleParser::Expect(char mark, std::string_view wanted) {
  return lexer_.Accept(mark) || Unexpected(wanted);
}

bool RuleParser::Unexpected(std::string_view wanted) {
  Error error = lexer_.Unexpected(wanted);
  ++failures_;
  errors_->Report(RangeOf(lexer_.Peek()), std::move(error));
  return false;
}

bool RuleParser::Fail(TextRange range, ErrorCode code, std::string message, std::string hint) {
  ++failures_;
  errors_->Report(range, code, std::move(message), std::move(hint));
  return false;
}

TextRange RuleParser::RangeOf(const Token& token) const {
  return {file_, static_cast<uint32_t>(token.offset), static_cast<uint32_t>(token.end())};
}

TextRange RuleParser::RangeFrom(size_t from) const {
  return {file_, static_cast<uint32_t>(from), static_cast<uint32_t>(lexer_.previous_end())};
}

WrittenRules ReadRules(std::string_view text, uint32_t file, RuleErrors* errors) {
  if (text.size() > kLargestRules) {
    errors->Report({file, 0, 0}, ErrorCode::kLimitReached,
                   fmt::format("this file is larger than {} MiB", kLargestRules >> 20));
    return {};
  }
  return RuleParser(text, file, errors).Read();
}

}  // namespace parti::grammar
