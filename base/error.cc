#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

#include "base/note.h"

namespace parti {
namespace {

constexpr size_t kMostShown = 120;  // bytes of a line that stand around the caret

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// Letters inserted, dropped, replaced or, the commonest slip of all, swapped with a neighbour: each
// costs one (optimal string alignment).
size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> before, above(b.size() + 1), row(b.size() + 1);
  std::iota(above.begin(), above.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t substituted = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, substituted});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = std::exchange(above, row);
  }
  return above.back();
}

// The second and later bytes of a UTF-8 character, which take no room on the screen.
bool Continues(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) == 0x80; }

size_t CharactersIn(std::string_view text) {
  return text.size() - static_cast<size_t>(std::count_if(text.begin(), text.end(), Continues));
}

// Whole lines where they are short; of a long one (a batch's JSON) only what is near the caret.
struct Shown {
  std::string before, marked, after;
};

// Control characters could move the cursor or change colours: they show as a question mark.
std::string Printable(std::string_view text) {
  std::string printable(text);
  for (char& c : printable) {
    if (std::iscntrl(static_cast<unsigned char>(c)) && c != '\t') c = '?';
  }
  return printable;
}

Shown AroundCaret(const SourcePlace& place) {
  const std::string_view line = place.line_text;
  const size_t from = std::min(static_cast<size_t>(std::max(1, place.column)) - 1, line.size());
  const size_t wanted = static_cast<size_t>(std::max(1, place.length));
  const size_t to = from + std::min({wanted, line.size() - from, kMostShown});
  size_t start = from > kMostShown / 2 && line.size() > kMostShown ? from - kMostShown / 2 : 0;
  size_t end = std::max(to, std::min(line.size(), start + kMostShown));
  while (start < from && Continues(line[start])) ++start;
  while (end > to && end < line.size() && Continues(line[end])) --end;
  return {(start > 0 ? "…" : "") + Printable(line.substr(start, from - start)),
          Printable(line.substr(from, to - from)),
          Printable(line.substr(to, end - to)) + (end < line.size() ? "…" : "")};
}

// What stands under `before`: a tab under a tab, so that the caret stands where the eye expects it.
std::string Indent(std::string_view before) {
  std::string indent;
  for (const char c : before) {
    if (!Continues(c)) indent += c == '\t' ? '\t' : ' ';
  }
  return indent;
}

std::string Format(const Error& error, std::string_view kind) {
  if (!error.place) {
    std::string text = fmt::format("parti: {}: {}", kind, error.message);
    if (!error.hint.empty()) text += fmt::format("\n  hint: {}", error.hint);
    return text;
  }
  const SourcePlace& place = *error.place;
  const Shown shown = AroundCaret(place);
  const size_t tildes = std::max<size_t>(1, CharactersIn(shown.marked)) - 1;
  std::string text = fmt::format("{}:{}:{}: {}: {}\n{:5} | {}{}{}\n      | {}^{:~<{}}",
                                 place.file.empty() ? "<text>" : place.file, place.line,
                                 place.column, kind, error.message, place.line, shown.before,
                                 shown.marked, shown.after, Indent(shown.before), "", tildes);
  if (!error.hint.empty()) text += fmt::format("  hint: {}", error.hint);
  return text;
}

}  // namespace

std::string FormatError(const Error& error) { return Format(error, "error"); }

std::string FormatNote(const Error& note) { return Format(note, "note"); }

SourcePlace PlaceIn(std::string_view text, std::string_view file, size_t offset, size_t length) {
  offset = std::min(offset, text.size());
  const auto start = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  const size_t line_start = start == std::string_view::npos ? 0 : start + 1;
  size_t line_end = text.find('\n', offset);
  if (line_end == std::string_view::npos) line_end = text.size();
  const auto before = text.substr(0, line_start);
  SourcePlace place;
  place.file = file;
  place.line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
  place.column = 1 + static_cast<int>(offset - line_start);
  place.length = std::max(1, static_cast<int>(std::min(length, line_end - offset)));
  place.line_text = text.substr(line_start, line_end - line_start);
  if (!place.line_text.empty() && place.line_text.back() == '\r') place.line_text.pop_back();
  return place;
}

std::optional<std::string> DidYouMean(std::string_view word,
                                      const std::vector<std::string>& candidates) {
  const std::string meant = Lower(word);
  std::optional<std::string> best;
  size_t best_distance = 0;
  for (const std::string& candidate : candidates) {
    const size_t longer = std::max(word.size(), candidate.size());
    const size_t shorter = std::min(word.size(), candidate.size());
    const size_t allowed = std::max<size_t>(1, longer / 3);
    if (longer - shorter > allowed) continue;
    const size_t distance = EditDistance(meant, Lower(candidate));
    if (distance > allowed || distance == longer || (best && distance >= best_distance)) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

}  // namespace parti
