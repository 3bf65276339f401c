// UTF-8, as far as a lexer and typed text need it: one code point at a time, and which of them are
// letters. Not responsible for normal forms: names are compared byte by byte.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace parti {

/// One character and the bytes that it takes.
struct CodePoint {
  char32_t value = 0;
  size_t length = 0;  ///< bytes; 0: not UTF-8 here (or the end)
};

/// The code point that starts at `offset`. Overlong forms, surrogates and values past U+10FFFF are
/// not UTF-8.
CodePoint CodePointAt(std::string_view text, size_t offset);

/// The bytes of a code point; empty for surrogates and values past U+10FFFF.
std::string Utf8Of(char32_t value);

/// All of it, from the first byte to the last.
bool IsUtf8(std::string_view text);

/// Letters and _; of code points past ASCII everything but blanks, punctuation, arrows, symbols and
/// private use: the small price for not carrying Unicode's tables.
bool IsLetter(char32_t c);
inline bool IsDigit(char32_t c) { return c >= '0' && c <= '9'; }

}  // namespace parti
