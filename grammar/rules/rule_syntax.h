// A rule file as it is written: what the parser makes of a text before names and types are known.
// Responsible neither for what names mean (rule_check.h) nor for what files are imported.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grammar/rules/rule_errors.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// "height / 2", "p.area(w, 3)", "scope.sx".
struct WrittenExpression {
  enum class Kind : uint8_t {
    kConstant,  ///< `constant`
    kName,      ///< `name`, with its dots
    kCall,      ///< `name` of the operands
    kOperator,  ///< `name` of one or two operands
    kCase,      ///< as Expression's
    kChance,    ///< as Expression's
  };
  Kind kind = Kind::kConstant;
  Value constant = 0.0;
  std::string name;
  std::vector<WrittenExpression> operands;
  int depth = 1;  ///< of the tree that this is the root of
  TextRange range;
};

/// What stands between two commas, or before the colon in braces: "3", "'0.5", "~h", "side".
struct WrittenArgument {
  Size::Kind size = Size::Kind::kAbsolute;
  WrittenExpression value;
  TextRange range;
};

struct WrittenAlternative;
struct WrittenStatement;

/// Statements one after the other, or one of several bodies.
struct WrittenBody {
  struct Alternative {
    std::vector<WrittenExpression> condition;  ///< one, or none: else
    std::vector<WrittenBody> body;             ///< one
  };
  Body::Kind kind = Body::Kind::kSequence;
  std::vector<WrittenStatement> statements;
  std::vector<Alternative> alternatives;
  TextRange range;
};

/// "split(y) { … }*", "Tower(3)", "Wall.", "[".
struct WrittenStatement {
  enum class Kind : uint8_t { kNamed, kPush, kPop };
  Kind kind = Kind::kNamed;
  std::string name;
  bool deferred = false;  ///< "@Symbol"
  bool ends = false;      ///< "Symbol.": no rule is looked for
  bool called = false;    ///< parentheses
  std::vector<WrittenArgument> arguments;
  bool braces = false;
  bool repeated = false;  ///< a star after the braces
  std::vector<WrittenAlternative> alternatives;
  bool broken = false;  ///< an error in its braces has been reported
  TextRange range;      ///< of the name
};

/// "~1: Wall", "{ … }*", "Wall" (sizes stand in the parentheses).
struct WrittenAlternative {
  std::vector<WrittenArgument> key;  ///< one, or none
  WrittenBody body;
  std::vector<WrittenAlternative> repeat;  ///< a group; all else is unused
  bool group = false;
  TextRange range;
};

/// "@Range(min=2, max=6)"
struct WrittenAnnotation {
  struct Argument {
    std::string name;  ///< "" without one
    WrittenExpression value;
  };
  std::string name;
  std::vector<Argument> arguments;
  TextRange range;
};

/// Its type is not written: the checker infers it.
struct WrittenParameter {
  std::string name;
  TextRange range;
};

/// An attr, a const, a function or a rule.
struct WrittenDeclaration {
  enum class Kind : uint8_t { kAttribute, kConstant, kFunction, kRule };
  Kind kind = Kind::kRule;
  std::string name;
  std::vector<WrittenParameter> parameters;
  WrittenExpression value;
  WrittenBody body;
  std::vector<WrittenAnnotation> annotations;
  bool broken = false;  ///< an error in it has been reported: some of it is missing
  TextRange range;      ///< of the name
};

/// `import roof ( Steep ) : "roof.cga" ( slope = 30, eaves )`
struct WrittenImport {
  struct Attribute {
    std::string name;
    std::vector<WrittenExpression> value;  ///< one, or none: it keeps its own
    TextRange range;
  };
  std::string prefix;
  std::string path;
  std::string style;
  std::vector<Attribute> attributes;
  bool protects = false;
  TextRange range;  ///< of the path
};

/// `style Modern extends Default` and what follows it.
struct WrittenStyle {
  std::string name;
  std::string base = "Default";
  std::vector<WrittenDeclaration> declarations;
  TextRange range;  ///< of its name
  TextRange text;   ///< of its declarations
  TextRange base_range;
};

/// One text.
struct WrittenRules {
  std::string version;
  std::vector<WrittenImport> imports;
  std::vector<WrittenDeclaration> declarations;
  std::vector<WrittenStyle> styles;
  Trees trees;
};

/// Nesting of expressions, and of bodies and braces, that a text may have.
inline constexpr int kDeepestExpression = 256;
inline constexpr int kDeepestBody = 64;
/// Bytes, styles, and attributes of one import that a text may have.
inline constexpr size_t kLargestRules = size_t{16} << 20;
inline constexpr size_t kMostStyles = 64;
inline constexpr size_t kMostImportAttributes = 1000;

/// Reads all of a text, going on at the next declaration, or the next alternative in braces, after
/// an error. `file` is its number in the rule set.
/// errors  to `errors`: kBadText, kLimitReached.
/// cost  linear in the text.
WrittenRules ReadRules(std::string_view text, uint32_t file, RuleErrors* errors);

}  // namespace parti::grammar
