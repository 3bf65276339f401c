#include "grammar/rules/rule_notes.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "base/utf8.h"
#include "grammar/rules/conversions.h"

namespace parti::grammar {
namespace {

/// One line, that a terminal shows as it is: no more than kLongestPrint bytes, no control
/// characters.
std::string LineOf(std::string_view text) {
  std::string line;
  for (size_t at = 0; at < text.size();) {
    const CodePoint point = CodePointAt(text, at);
    if (line.size() + point.length > kLongestPrint) return line + "…";
    const bool is_shown = point.length > 0 && point.value >= ' ' && point.value != 0x7f &&
                          (point.value < 0x80 || point.value > 0x9f);
    line += is_shown ? text.substr(at, point.length) : " ";
    at += point.length > 0 ? point.length : 1;
  }
  return line;
}

/// The declaration with the last name before `range`: "rule Floor"; "" where there is none.
class Declarations {
 public:
  explicit Declarations(const RuleSet& rules) : rules_(rules) {}

  std::string At(const TextRange& range) const {
    const TextRange* nearest = nullptr;
    std::string name;
    const auto consider = [&](const TextRange& own, std::string_view what, std::string_view named) {
      const bool is_before = own.file == range.file && own.from <= range.from;
      if (!is_before || (nearest != nullptr && own.from < nearest->from)) return;
      nearest = &own;
      name = fmt::format("{} {}", what, named);
    };
    for (const Rule& rule : rules_.rules) consider(rule.range, "rule", rule.symbol);
    for (const auto& one : rules_.functions) consider(one.range, "function", one.name);
    for (const auto& one : rules_.attributes) consider(one.range, "attribute", one.name);
    return name;
  }

 private:
  const RuleSet& rules_;
};

}  // namespace

bool NoteBook::Report(std::string key, Value value) {
  if (reports_.size() >= kMostReports) return false;
  reports_.push_back({std::move(key), std::move(value)});
  return true;
}

void NoteBook::Print(const TextRange& range, const Value& value) {
  if (lines_.size() < kMostPrints) {
    lines_.push_back({range, LineOf(TextOf(value))});
  } else {
    ++more_lines_;
  }
}

void NoteBook::Append(NoteBook&& later) {
  reports_.insert(reports_.end(), std::make_move_iterator(later.reports_.begin()),
                  std::make_move_iterator(later.reports_.end()));
  for (Line& line : later.lines_) {
    if (lines_.size() < kMostPrints) {
      lines_.push_back(std::move(line));
    } else {
      ++more_lines_;
    }
  }
  more_lines_ += later.more_lines_;
}

LotNotes NoteBook::Take(const RuleSet& rules) && {
  LotNotes notes;
  notes.reports = std::move(reports_);
  notes.more_prints = more_lines_;
  const Declarations declarations(rules);
  for (const Line& line : lines_) {
    const SourcePlace place = PlaceOf(rules, line.range);
    notes.prints.push_back(fmt::format("{}:{}:{}: {}: {}", place.file, place.line, place.column,
                                       declarations.At(line.range), line.text));
  }
  return notes;
}

}  // namespace parti::grammar
