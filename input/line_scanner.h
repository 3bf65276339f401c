// Reads the words of one line of a drawing, each failure with its column.
// Not responsible for what the words mean (event_text.h).
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "base/math.h"

namespace parti::input {

/// A run of bytes of the line; `column` counts from 1.
struct Word {
  std::string_view text;
  int column = 1;
};

/// `key` or `key=value`. The value's quotes and escapes are still in place.
struct Attribute {
  Word key;
  Word value;  ///< text is empty for a bare key
  bool has_value = false;
};

/// Words are separated by blanks (space, tab). The line has no line break and outlives the scanner.
/// Every error is kDamagedFile with a place in `line` (line number 1, no file: the caller knows).
class LineScanner {
 public:
  explicit LineScanner(std::string_view line) : line_(line) {}

  /// True when only blanks are left.
  bool AtEnd();

  /// The next word; `what` names in the message what is missing when there is none.
  Result<Word> Next(std::string_view what);

  /// The next attribute; a value in double quotes may hold blanks.
  Result<Attribute> NextAttribute();

  /// Everything that is left, from the next non-blank on.
  Word Rest();

  /// A failure whose place is `word`.
  tl::unexpected<Error> FailAt(const Word& word, std::string message, std::string hint = {}) const;

 private:
  int column() const { return static_cast<int>(at_) + 1; }

  std::string_view line_;
  size_t at_ = 0;
};

/// A whole word as a finite number, pair ("12.5,-3"), or integer of [low, high].
Result<double> NumberIn(const LineScanner& line, const Word& word);
Result<Vec2> PairIn(const LineScanner& line, const Word& word);
Result<int> IntegerIn(const LineScanner& line, const Word& word, int low, int high);

/// Four to eight hexadecimal digits, as vendor and product numbers are written.
Result<uint32_t> HexIn(const LineScanner& line, const Word& word);

/// `text` in double quotes, with \" \\ and \xHH for bytes below 32 and 127; and back.
std::string Quoted(std::string_view text);
Result<std::string> UnquotedIn(const LineScanner& line, const Word& word);

}  // namespace parti::input
