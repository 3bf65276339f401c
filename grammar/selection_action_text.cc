// Selection-action trees as text (language.md): a parser that goes on at the next node after an
// error, and the printer that it reads back.
#include <fmt/format.h>

#include "grammar/action_text.h"
#include "grammar/lexer.h"
#include "grammar/query_text.h"
#include "grammar/selection_action.h"
#include "grammar/tree_text.h"

namespace parti::grammar {
namespace {

constexpr size_t kMostErrors = 50;
constexpr std::string_view kTree = "tree";
constexpr std::string_view kVersion = "version";

class TreesReader {
 public:
  TreesReader(Lexer* lexer, std::vector<Error>* errors) : lexer_(lexer), errors_(errors) {}

  Trees Read() {
    Trees trees;
    while (!lexer_->At(Token::Kind::kEnd) && !TooMany()) {
      if (AtTree()) {
        trees.push_back(ReadTree());
      } else if (lexer_->AcceptWord(kVersion)) {
        if (!lexer_->At(Token::Kind::kText)) Report(lexer_->Unexpected("a version in quotes"));
        if (lexer_->At(Token::Kind::kText)) lexer_->Next();
      } else {
        RefuseStatement();
      }
    }
    return trees;
  }

  SelectionActionTree ReadTree() {
    SelectionActionTree tree;
    const Token start = lexer_->Next();
    tree.name = lexer_->Next().text;
    tree.enabled = !lexer_->AcceptWord(kOff);
    if (!lexer_->Expect('{', "'{' and the tree's nodes")) {
      Report(lexer_->Unexpected("'{' and the tree's nodes"));
      while (!lexer_->At(Token::Kind::kEnd) && !AtTree()) lexer_->Next();
      return tree;
    }
    lexer_->SetHash(Lexer::Hash::kTag);
    tree.nodes = ReadNodes(1);
    lexer_->SetHash(Lexer::Hash::kComment);
    if (!lexer_->Accept('}')) {
      Report(
          lexer_->ErrorAt(start, ErrorCode::kBadText, "this tree is not closed", "end it with }"));
    }
    return tree;
  }

 private:
  /// Where a node began.
  struct Start {
    Token token;
    size_t previous_end;
    int open_braces;
  };

  bool TooMany() const { return errors_->size() >= kMostErrors; }
  void Report(Error error) {
    if (!TooMany()) errors_->push_back(std::move(error));
  }

  bool AtTree() const { return grammar::AtTree(*lexer_); }

  /// A rule, an attribute, or something that is neither; up to the next line that starts a tree.
  void RefuseStatement() {
    const Token token = lexer_->Peek();
    Lexer ahead = *lexer_;
    ahead.Next();
    const bool rule =
        token.kind == Token::Kind::kName &&
        (ahead.At(Token::Kind::kArrow) || ahead.At('(') || ahead.At(Token::Kind::kName));
    Report(rule ? lexer_->ErrorAt(token, ErrorCode::kBadText, "rules are not read yet, only trees",
                                  "tree NAME { .Symbol --> operation(…) }")
                : lexer_->Unexpected("tree NAME { … }"));
    do {
      lexer_->Next();
    } while (!lexer_->At(Token::Kind::kEnd) && !(AtTree() && lexer_->Peek().starts_line));
  }

  /// Up to the brace that closes them, or the end.
  std::vector<SelectionActionNode> ReadNodes(int depth) {
    std::vector<SelectionActionNode> nodes;
    while (!lexer_->At('}') && !lexer_->At(Token::Kind::kEnd) && !TooMany()) {
      if (lexer_->Accept(';')) continue;
      const size_t before = lexer_->previous_end();
      nodes.push_back(ReadNode(depth));
      if (lexer_->previous_end() == before) lexer_->Next();
    }
    return nodes;
  }

  SelectionActionNode ReadNode(int depth) {
    SelectionActionNode node;
    const Start start{lexer_->Peek(), lexer_->previous_end(), lexer_->open_braces()};
    node.enabled = !lexer_->AcceptWord(kOff);
    if (!ReadSelection(&node, start) || !ReadOperation(&node)) GoToChildrenOrNext(start);
    lexer_->Accept(';');
    if (lexer_->At('{')) ReadChildren(&node, start.token, depth);
    return node;
  }

  /// Goes on to the arrow after an error, so that the action is checked too.
  bool ReadSelection(SelectionActionNode* node, const Start& start) {
    auto query = ReadQuery(lexer_);
    if (query) {
      node->query = std::move(*query);
    } else {
      Report(query.error());
      GoToChildrenOrNext(start, /*stop_at_arrow=*/true);
    }
    if (lexer_->At(Token::Kind::kArrow)) {
      lexer_->Next();
      return true;
    }
    if (query) Report(lexer_->Unexpected("'-->' and an operation"));
    return false;
  }

  bool ReadOperation(SelectionActionNode* node) {
    auto action = ReadAction(lexer_);
    if (!action) {
      Report(action.error());
      return false;
    }
    node->action = std::move(*action);
    Lexer ahead = *lexer_;
    const Token name = ahead.Next();
    if (name.kind != Token::Kind::kName || !ahead.At('(')) return true;
    Report(lexer_->ErrorAt(name, ErrorCode::kBadText, "a node has one operation",
                           "give the second a node of its own"));
    return false;
  }

  void ReadChildren(SelectionActionNode* node, const Token& start, int depth) {
    const int braces = lexer_->open_braces();
    const Token open = lexer_->Next();
    if (depth >= kDeepestNode) {
      Report(lexer_->ErrorAt(open, ErrorCode::kLimitReached,
                             fmt::format("nodes are nested more than {} deep here", kDeepestNode)));
      while (!lexer_->At(Token::Kind::kEnd) && lexer_->open_braces() > braces) lexer_->Next();
      return;
    }
    node->children = ReadNodes(depth + 1);
    if (lexer_->Accept('}') || TooMany()) return;
    Report(lexer_->ErrorAt(start, ErrorCode::kBadText, "the children of this node are not closed",
                           "end them with }"));
  }

  /// Skips to where reading can go on after an error in a node: its children's brace, a semicolon,
  /// the next node, or the brace that closes the list it stands in.
  void GoToChildrenOrNext(const Start& start, bool stop_at_arrow = false) {
    for (; !lexer_->At(Token::Kind::kEnd); lexer_->Next()) {
      if (lexer_->open_braces() > start.open_braces) continue;
      if (lexer_->At(';') || lexer_->At('}')) return;
      if (stop_at_arrow && lexer_->At(Token::Kind::kArrow)) return;
      const bool moved = lexer_->previous_end() > start.previous_end;
      if (moved && lexer_->Peek().starts_line && AtNode()) return;
      if (lexer_->At('{') && OpensNodes()) return;
    }
  }

  /// A node starts here, rather than the rest of one.
  bool AtNode() const {
    if (lexer_->AtWord(kOff)) return true;
    if (!lexer_->At(Token::Kind::kName)) return AtQuery(*lexer_);
    Lexer ahead = *lexer_;
    ahead.Next();
    const bool part = ahead.At('.') || ahead.At('#') || ahead.At(':');
    return part || ahead.At('>') || ahead.At('/') || ahead.At('~') || ahead.At(Token::Kind::kArrow);
  }

  bool OpensNodes() const {
    Lexer ahead = *lexer_;
    ahead.Next();
    return ahead.AtWord(kOff) || (AtQuery(ahead) && !ahead.At(Token::Kind::kName));
  }

  Lexer* lexer_;
  std::vector<Error>* errors_;
};

void Print(const std::vector<SelectionActionNode>& nodes, size_t indent, std::string* text) {
  for (const SelectionActionNode& node : nodes) {
    text->append(indent, ' ');
    *text += TextOf(node);
    if (!node.children.empty()) {
      *text += " {\n";
      Print(node.children, indent + 2, text);
      text->append(indent, ' ');
      *text += "}";
    }
    *text += "\n";
  }
}

}  // namespace

tl::expected<Trees, std::vector<Error>> ParseTrees(std::string_view text, std::string_view file) {
  Lexer lexer(text, file, Lexer::Hash::kComment);
  std::vector<Error> errors;
  Trees trees = TreesReader(&lexer, &errors).Read();
  if (!errors.empty()) return tl::unexpected<std::vector<Error>>(std::move(errors));
  return trees;
}

bool AtTree(const Lexer& lexer) {
  Lexer ahead = lexer;
  return ahead.AcceptWord(kTree) && (ahead.At(Token::Kind::kName) || ahead.At(Token::Kind::kText));
}

SelectionActionTree ReadTree(Lexer* lexer, std::vector<Error>* errors) {
  return TreesReader(lexer, errors).ReadTree();
}

std::string TextOf(const SelectionActionNode& node) {
  return fmt::format("{}{} --> {}", node.enabled ? "" : "off ", TextOf(node.query),
                     TextOf(node.action));
}

std::string TextOf(const Trees& trees) {
  std::string text;
  for (const SelectionActionTree& tree : trees) {
    text += fmt::format("tree {}{} {{\n", NameText(tree.name), tree.enabled ? "" : " off");
    Print(tree.nodes, 2, &text);
    text += "}\n";
  }
  return text;
}

}  // namespace parti::grammar
