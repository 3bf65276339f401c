// What rules tell beside the shapes that they make: report(key, value) and print(value) (CGA).
// What reports come to is report_table.h's; writing and showing them is the caller's.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// More reports of one lot are an error, more lines of it are only counted, and a longer one is
/// cut.
inline constexpr size_t kMostReports = 2'000'000;
inline constexpr size_t kMostPrints = 1000;
inline constexpr size_t kLongestPrint = 1000;  ///< bytes

/// report("windows.open", 1), made once.
struct RuleReport {
  std::string key;
  Value value;
  bool operator==(const RuleReport&) const = default;
};

/// Of one lot, in the order in which one thread derives it.
struct LotNotes {
  std::vector<RuleReport> reports;
  std::vector<std::string> prints;  ///< "house.cga:5:10: rule Floor: 3 m"; at most kMostPrints
  uint64_t more_prints = 0;         ///< what was printed besides
  bool operator==(const LotNotes&) const = default;
};

/// Notes while they are being made: lines without their places, which take time to find.
class NoteBook {
 public:
  /// False where there are kMostReports already.
  bool Report(std::string key, Value value);
  /// `range` is where the rules say so.
  void Print(const TextRange& range, const Value& value);
  /// What was made after all that is in here.
  void Append(NoteBook&& later);

  uint64_t reports() const { return reports_.size(); }
  /// With the places that they have in these rules, which made them.
  LotNotes Take(const RuleSet& rules) &&;

 private:
  struct Line {
    TextRange range;
    std::string text;
  };
  std::vector<RuleReport> reports_;
  std::vector<Line> lines_;
  uint64_t more_lines_ = 0;
};

}  // namespace parti::grammar
