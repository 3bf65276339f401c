#include "grammar/lexer.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/utf8.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kMarks = ".#:,;(){}[]|&*/~><='@%+-!";
constexpr char32_t kRightArrow = 0x2192;
constexpr char32_t kEpsilon = 0x3b5;
constexpr char32_t kByteOrderMark = 0xfeff;

std::string Described(const Token& token) {
  switch (token.kind) {
    case Token::Kind::kEnd:
      return "the end of the text";
    case Token::Kind::kName:
      return fmt::format("'{}'", token.text);
    case Token::Kind::kNumber:
      return "a number";
    case Token::Kind::kText:
      return "a quoted text";
    case Token::Kind::kArrow:
      return "an arrow";
    case Token::Kind::kMark:
      return fmt::format("'{}'", token.mark);
    case Token::Kind::kBad:
      break;
  }
  return token.message;
}

/// What to do about a character that no token begins with.
std::string HintFor(char32_t c) {
  if (c == 0x201c || c == 0x201d || c == 0x201e) return "texts stand in straight quotes: \"";
  if (c == 0x2018 || c == 0x2019) return "relative sizes have a straight quote: '0.5";
  if (c == 0x2013 || c == 0x2014 || c == 0x2212) return "write the minus of the keyboard: -";
  if (c == '^') return "powers are pow(base, exponent)";
  if (c == '$' || c == '?' || c == '\\' || c == '`') return "in a name or a file, put it in \"\"";
  if (c < 0x20 || c == 0x7f) return fmt::format("take byte 0x{:02x} out", static_cast<uint32_t>(c));
  return fmt::format("take U+{:04X} out, or put it in quotes", static_cast<uint32_t>(c));
}

}  // namespace

Lexer::Lexer(std::string_view text, std::string_view file, Hash hash)
    : text_(text), file_(file), hash_(hash) {
  if (CodePointAt(text_, 0).value == kByteOrderMark) next_ = 3;
  previous_end_ = next_;
  Scan();
}

Token Lexer::Next() {
  if (At('{')) ++open_braces_;
  if (At('}')) --open_braces_;
  Token token = std::move(token_);
  previous_end_ = token.end();
  Scan();
  return token;
}

void Lexer::SetHash(Hash hash) {
  if (hash_ == hash) return;
  hash_ = hash;
  next_ = previous_end_;
  // What stood before the token at hand is read again, now with the other meaning.
  const size_t line = text_.substr(0, next_).find_last_of('\n');
  const size_t start = line == std::string_view::npos ? 0 : line + 1;
  starts_line_ =
      text_.substr(start, next_ - start).find_first_not_of(" \t\r") == std::string_view::npos;
  Scan();
}

bool Lexer::Accept(char mark) {
  if (!At(mark)) return false;
  Next();
  return true;
}

bool Lexer::AcceptWord(std::string_view word) {
  if (!AtWord(word)) return false;
  Next();
  return true;
}

Result<Token> Lexer::Expect(char mark, std::string_view wanted) {
  if (At(mark)) return Next();
  return tl::unexpected<Error>(Unexpected(wanted));
}

Error Lexer::Unexpected(std::string_view wanted) const {
  if (At(Token::Kind::kBad)) {
    return ErrorAt(token_, ErrorCode::kBadText, token_.message, token_.hint);
  }
  return ErrorAt(token_, ErrorCode::kBadText,
                 fmt::format("expected {}, got {}", wanted, Described(token_)));
}

Error Lexer::ErrorAt(const Token& token, ErrorCode code, std::string message,
                     std::string hint) const {
  return Located(Error{code, std::move(message), std::move(hint)}, token.offset, token.end());
}

Error Lexer::Located(Error error, size_t from, size_t to) const {
  error.place = PlaceIn(text_, file_, from, to > from ? to - from : 1);
  return error;
}

void Lexer::Scan() {
  token_ = Token();
  const bool closed = SkipBlanks();
  token_.starts_line = starts_line_;
  starts_line_ = false;
  if (!closed) return;  // SkipBlanks has left the error
  token_.offset = next_;
  if (next_ >= text_.size()) return;
  const CodePoint c = CodePointAt(text_, next_);
  if (c.length == 0) return Bad(1, "this is not UTF-8 text", "save the file as UTF-8");
  if (IsDigit(c.value) || (c.value == '.' && IsDigit(static_cast<uint8_t>(CharAt(next_ + 1))))) {
    return ScanNumber();
  }
  if (IsLetter(c.value)) return ScanName();
  if (c.value == '"') return ScanText();
  ScanMark();
}

bool Lexer::SkipBlanks() {
  while (next_ < text_.size()) {
    const char c = text_[next_];
    if (c == '\n') starts_line_ = true;
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
      ++next_;
    } else if ((c == '/' && CharAt(next_ + 1) == '/') || (c == '#' && hash_ == Hash::kComment)) {
      SkipLine();
    } else if (c == '/' && CharAt(next_ + 1) == '*') {
      const size_t close = text_.find("*/", next_ + 2);
      if (close == std::string_view::npos) {
        token_.offset = next_;
        Bad(2, "this comment is not closed", "end it with */");
        next_ = text_.size();
        return false;
      }
      if (text_.substr(next_, close - next_).find('\n') != std::string_view::npos) {
        starts_line_ = true;
      }
      next_ = close + 2;
    } else {
      break;
    }
  }
  return true;
}

void Lexer::SkipLine() {
  const size_t end = text_.find('\n', next_);
  next_ = end == std::string_view::npos ? text_.size() : end;
}

void Lexer::ScanName() {
  const size_t start = next_;
  for (CodePoint c = CodePointAt(text_, next_); IsLetter(c.value) || IsDigit(c.value);
       c = CodePointAt(text_, next_)) {
    next_ += c.length;
  }
  token_.kind = Token::Kind::kName;
  token_.length = next_ - start;
  token_.text = text_.substr(start, token_.length);
  if (token_.length == 2 && CodePointAt(text_, start).value == kEpsilon) token_.text = "NIL";
}

void Lexer::ScanNumber() {
  const char* first = text_.data() + next_;
  const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), token_.number);
  const auto length = static_cast<size_t>(end - first);
  if (error != std::errc()) {
    return Bad(length, "this number is too large or too small to be held",
               "numbers are metres or degrees");
  }
  if (IsLetter(CodePointAt(text_, next_ + length).value)) {
    return Bad(length + 1, "a letter follows this number",
               "lengths are metres and angles degrees, without a unit");
  }
  token_.kind = Token::Kind::kNumber;
  token_.length = length;
  next_ += length;
}

void Lexer::ScanText() {
  for (size_t i = next_ + 1; i < text_.size() && text_[i] != '\n';) {
    const CodePoint c = CodePointAt(text_, i);
    if (c.length == 0)
      return Bad(i + 1 - next_, "this text is not UTF-8", "save the file as UTF-8");
    if (c.value == '"') {
      token_.kind = Token::Kind::kText;
      token_.length = i + 1 - next_;
      next_ = i + 1;
      return;
    }
    if (c.value != '\\') {
      token_.text += text_.substr(i, c.length);
      i += c.length;
      continue;
    }
    const size_t length = ScanEscape(i);
    if (length == 0) break;
    i += length;
  }
  const size_t line_end = std::min(text_.find('\n', next_), text_.size());
  Bad(line_end - next_, "this text is not closed, or holds a \\ that means nothing",
      R"(end it with " on the same line; only \" \' \\ \n \r \t \b \f \uXXXX are known)");
}

size_t Lexer::ScanEscape(size_t at) {
  constexpr std::string_view kEscapes = "\"\\'nrtbf";
  constexpr std::string_view kMeanings = "\"\\'\n\r\t\b\f";
  if (CharAt(at + 1) != 'u') {
    const size_t which = kEscapes.find(CharAt(at + 1));
    if (which == std::string_view::npos || at + 1 >= text_.size()) return 0;
    token_.text += kMeanings[which];
    return 2;
  }
  constexpr size_t kDigits = 4, kLength = 2 + kDigits;
  if (at + kLength > text_.size()) return 0;
  const char* digits = text_.data() + at + 2;
  uint32_t value = 0;
  if (std::from_chars(digits, digits + kDigits, value, 16).ptr != digits + kDigits) return 0;
  const std::string encoded = Utf8Of(value);
  if (encoded.empty()) return 0;
  token_.text += encoded;
  return kLength;
}

void Lexer::ScanMark() {
  const CodePoint c = CodePointAt(text_, next_);
  const std::string_view rest = text_.substr(next_);
  const size_t arrow = c.value == kRightArrow    ? c.length
                       : rest.starts_with("-->") ? 3
                       : rest.starts_with("->")  ? 2
                                                 : 0;
  if (arrow > 0) {
    token_.kind = Token::Kind::kArrow;
    token_.length = arrow;
  } else if (c.value < 0x80 && kMarks.find(static_cast<char>(c.value)) != std::string_view::npos) {
    token_.kind = Token::Kind::kMark;
    token_.mark = static_cast<char>(c.value);
    token_.length = 1;
  } else {
    return Bad(c.length, "this character means nothing here", HintFor(c.value));
  }
  next_ += token_.length;
}

void Lexer::Bad(size_t length, std::string message, std::string hint) {
  token_.kind = Token::Kind::kBad;
  token_.text.clear();
  token_.length = length;
  token_.message = std::move(message);
  token_.hint = std::move(hint);
  next_ = token_.offset + length;
}

bool IsName(std::string_view name) {
  if (name == kOff || name.empty() || !IsLetter(CodePointAt(name, 0).value)) return false;
  for (size_t i = 0; i < name.size();) {
    const CodePoint c = CodePointAt(name, i);
    if (!IsLetter(c.value) && !IsDigit(c.value)) return false;
    i += c.length;
  }
  return CodePointAt(name, 0).value != kEpsilon || name.size() > 2;
}

std::string NameText(std::string_view name) {
  return IsName(name) ? std::string(name) : QuotedText(name);
}

std::string QuotedText(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    constexpr std::string_view kEscaped = "\"\\\n\r\t";
    constexpr std::string_view kEscapes = "\"\\nrt";
    const size_t which = kEscaped.find(c);
    if (which == std::string_view::npos) {
      quoted += c;
    } else {
      quoted += {'\\', kEscapes[which]};
    }
  }
  return quoted + '"';
}

std::string NumberText(double number) {
  return std::isnan(number) ? "nan" : fmt::format("{}", number);
}

std::string RoundedText(double number) {
  return std::isnan(number) ? "nan" : fmt::format("{:.6g}", number);
}

}  // namespace parti::grammar
