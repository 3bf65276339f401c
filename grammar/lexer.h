// Tokens of queries, selection-action trees and rules: one lexer for all three.
// Not responsible for what the tokens mean, nor for collecting several errors.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"

namespace parti::grammar {

/// One token, and where it stands.
struct Token {
  enum class Kind : uint8_t { kEnd, kName, kNumber, kText, kArrow, kMark, kBad };
  Kind kind = Kind::kEnd;
  char mark = 0;             ///< kMark: one of  . # : , ; ( ) { } [ ] | & * / ~ > < = ' @ % + - !
  bool starts_line = false;  ///< nothing but blanks and comments before it on its line
  size_t offset = 0;         ///< bytes from the start of the text
  size_t length = 0;         ///< bytes
  double number = 0;         ///< kNumber; finite, not negative
  std::string text;          ///< kName: the name; kText: what stands between the quotes, unescaped
  std::string message;       ///< kBad: what is wrong
  std::string hint;          ///< kBad
  size_t end() const { return offset + length; }
};

/// Reads a text token by token; copies of a Lexer are cheap and stand for a place to come back to.
///
/// Names are letters, digits and _, not starting with a digit; every letter of Unicode is a letter.
/// "-->", "->" and "→" are one token; "ε" is the name NIL. Texts stand in straight double quotes,
/// with \" \' \\ \n \r \t \b \f \uXXXX. Comments are // to the end of the line and /* */; a text
/// that is not UTF-8, a quote or comment that is not closed and a number too large to write give
/// kBad tokens, after which reading goes on. cost  linear in the text; errors are located only when
/// they are made.
class Lexer {
 public:
  /// '#' starts a comment in rules (as in CGA) and a tag in queries and trees (language.md).
  enum class Hash : uint8_t { kTag, kComment };

  /// text and file must outlive the Lexer.
  explicit Lexer(std::string_view text, std::string_view file = {}, Hash hash = Hash::kTag);

  const Token& Peek() const { return token_; }
  Token Next();  ///< the token at hand, moving on; kEnd for ever at the end
  /// From the token at hand on.
  void SetHash(Hash hash);

  bool At(char mark) const { return token_.kind == Token::Kind::kMark && token_.mark == mark; }
  bool At(Token::Kind kind) const { return token_.kind == kind; }
  bool AtWord(std::string_view word) const { return At(Token::Kind::kName) && token_.text == word; }
  /// Moves on if the token at hand is this one.
  bool Accept(char mark);
  bool AcceptWord(std::string_view word);
  /// No blank or comment between the token before and the one at hand.
  bool Touching() const { return token_.offset == previous_end_; }
  size_t previous_end() const { return previous_end_; }
  /// Braces that were opened and not closed before the token at hand; for recovery.
  int open_braces() const { return open_braces_; }

  /// errors  kBadText  at the token at hand: "expected WANTED, got …".
  Result<Token> Expect(char mark, std::string_view wanted);
  Error Unexpected(std::string_view wanted) const;
  Error ErrorAt(const Token& token, ErrorCode code, std::string message,
                std::string hint = {}) const;
  /// Sets the error's place to [from, to) of the text.
  Error Located(Error error, size_t from, size_t to) const;

 private:
  void Scan();
  bool SkipBlanks();
  void SkipLine();
  void ScanName();
  void ScanNumber();
  void ScanText();
  size_t ScanEscape(size_t at);
  void ScanMark();
  void Bad(size_t length, std::string message, std::string hint = {});
  char CharAt(size_t offset) const { return offset < text_.size() ? text_[offset] : '\0'; }

  std::string_view text_;
  std::string_view file_;
  Hash hash_;
  size_t previous_end_ = 0;
  int open_braces_ = 0;
  size_t next_ = 0;  ///< where scanning goes on
  bool starts_line_ = true;
  Token token_;
};

/// Before a node, and after a tree's name: it does not run. No symbol without quotes.
inline constexpr std::string_view kOff = "off";

/// Whether `name` can stand without quotes where a symbol, a tag or a tree's name is wanted.
bool IsName(std::string_view name);
/// The name, quoted and escaped where it must be.
std::string NameText(std::string_view name);
/// In double quotes, escaped.
std::string QuotedText(std::string_view text);
/// The shortest text that reads back as the same finite double. What is no number is "nan" on every
/// machine: its sign, which 0/0 gives or not as the processor likes, is not written.
std::string NumberText(double number);
/// The same to six digits, for messages.
std::string RoundedText(double number);

}  // namespace parti::grammar
