#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace parti {
namespace {

size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

}  // namespace

std::string FormatError(const Error& error) {
  if (!error.place) {
    std::string text = fmt::format("parti: error: {}", error.message);
    if (!error.hint.empty()) text += fmt::format("\n  hint: {}", error.hint);
    return text;
  }
  const SourcePlace& place = *error.place;
  // A tab in the line stays a tab under it, so that the caret stands where the eye expects it.
  std::string indent;
  for (int i = 0; i + 1 < place.column && i < static_cast<int>(place.line_text.size()); ++i) {
    indent += place.line_text[static_cast<size_t>(i)] == '\t' ? '\t' : ' ';
  }
  std::string text = fmt::format("{}:{}:{}: error: {}\n{:5} | {}\n      | {}^{:~<{}}",
                                 place.file.empty() ? "<text>" : place.file, place.line,
                                 place.column, error.message, place.line, place.line_text, indent,
                                 "", std::max(0, place.length - 1));
  if (!error.hint.empty()) text += fmt::format("  hint: {}", error.hint);
  return text;
}

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
  std::optional<std::string> best;
  size_t best_distance = 0;
  for (const std::string& candidate : candidates) {
    const size_t distance = EditDistance(word, candidate);
    const size_t allowed = std::max<size_t>(1, std::max(word.size(), candidate.size()) / 3);
    if (distance > allowed || (best && distance >= best_distance)) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

}  // namespace parti
