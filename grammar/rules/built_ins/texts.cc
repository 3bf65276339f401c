// len, find, substring …: functions of texts. Positions count bytes from 0, as long as texts are
// ASCII that is CGA's count of characters.
#include <algorithm>

#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

size_t CountOf(const std::string& text, const std::string& match) {
  if (match.empty()) return 0;
  size_t count = 0;
  for (size_t at = text.find(match); at != std::string::npos; at = text.find(match, at + 1))
    ++count;
  return count;
}

/// The start of the n-th match, from 0; -1: there are fewer. n < 0 counts from the end, -1 the
/// last.
double FindNth(const std::string& text, const std::string& match, double n) {
  if (match.empty()) return -1;
  const auto count = static_cast<double>(CountOf(text, match));
  double left = n < 0 ? count + n : n;
  if (!(left >= 0 && left < count)) return -1;
  size_t at = text.find(match);
  for (; left >= 1; left -= 1) at = text.find(match, at + 1);
  return static_cast<double>(at);
}

/// A position in a text of this length.
size_t Position(double position, size_t length) {
  return position > 0 ? static_cast<size_t>(std::min(position, static_cast<double>(length))) : 0;
}

Value Substring(Values values, const Situation&) {
  const std::string text = TextOf(values[0]);
  const size_t from = Position(NumberOf(values[1]), text.size());
  const size_t to = Position(NumberOf(values[2]), text.size());
  return to > from ? text.substr(from, to - from) : std::string();
}

/// Stops where the result is too long already: whoever asked for it says so.
Value Replace(Values values, const Situation&) {
  const std::string text = TextOf(values[0]), match = TextOf(values[1]), by = TextOf(values[2]);
  if (match.empty()) return text;
  std::string replaced;
  size_t from = 0;
  for (size_t at = text.find(match); at != std::string::npos; at = text.find(match, from)) {
    replaced.append(text, from, at - from).append(by);
    from = at + match.size();
    if (replaced.size() > kLongestText) break;
  }
  return replaced.append(text, from);
}

Value Find(Values values, const Situation&) {
  return FindNth(TextOf(values[0]), TextOf(values[1]), values.size() > 2 ? NumberOf(values[2]) : 0);
}

constexpr std::array<std::optional<ValueType>, 3> kTextTwoNumbers = {kText, kNumber, kNumber};
constexpr std::array<std::optional<ValueType>, 3> kTwoTextsNumber = {kText, kText, kNumber};

constexpr BuiltIn kRows[] = {
    {"len", First(kTexts, 1), kNumber, "how long a text is",
     [](Values values, const Situation&) -> Value {
       return static_cast<double>(TextOf(values[0]).size());
     }},
    {"count", First(kTexts, 2), kNumber, "how often the second is in the first",
     [](Values values, const Situation&) -> Value {
       return static_cast<double>(CountOf(TextOf(values[0]), TextOf(values[1])));
     }},
    {"find", First(kTwoTextsNumber, 2), kNumber,
     "where the second first begins in the first; -1: nowhere", Find},
    {"find", kTwoTextsNumber, kNumber, "the same for a later match, counted from 0", Find},
    {"substring", kTextTwoNumbers, kText, "the part from one position up to another", Substring},
    {"replace", kTexts, kText, "every match of the second replaced by the third", Replace},
    {"getPrefix", First(kTexts, 2), kText, "what stands before the first match",
     [](Values values, const Situation&) -> Value {
       const std::string text = TextOf(values[0]);
       const size_t at = text.find(TextOf(values[1]));
       return at == std::string::npos ? std::string() : text.substr(0, at);
     }},
    {"getRange", kTexts, kText,
     "what stands between the first match of one and the next of another",
     [](Values values, const Situation&) -> Value {
       const std::string text = TextOf(values[0]), open = TextOf(values[1]);
       const size_t at = text.find(open);
       if (at == std::string::npos) return std::string();
       const size_t from = at + open.size();
       const size_t to = text.find(TextOf(values[2]), from);
       return to == std::string::npos ? std::string() : text.substr(from, to - from);
     }},
    {"getSuffix", First(kTexts, 2), kText, "what stands after the last match",
     [](Values values, const Situation&) -> Value {
       const std::string text = TextOf(values[0]), match = TextOf(values[1]);
       const size_t at = text.rfind(match);
       return at == std::string::npos ? std::string() : text.substr(at + match.size());
     }},
};

}  // namespace

std::span<const BuiltIn> Texts() { return kRows; }

}  // namespace parti::grammar::built_ins
