// What reports come to: a row for every key, as CityEngine's report tables have it.
// Where reports come from is rule_notes.h's; the files that tables are written to are app's.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "grammar/rules/rule_notes.h"

namespace parti::grammar {

/// All that was reported under a key with values of one type.
struct ReportRow {
  std::string key;
  ValueType type = ValueType::kNumber;
  uint64_t count = 0;
  /// Of numbers: those that are none (0/0) are only counted. All 0 where there are no others.
  uint64_t no_numbers = 0;
  double sum = 0, average = 0, least = 0, most = 0;
  /// Of booleans and texts: how often each, by its text.
  std::map<std::string, uint64_t> values;
  bool operator==(const ReportRow&) const = default;
};

/// Sorted by key, then numbers, booleans, texts. Numbers are added in the order of the reports, so
/// that the same reports have the same sum to the last digit. cost  n log n.
std::vector<ReportRow> ReportTable(std::span<const RuleReport> reports);
/// Of several lots together, in their order.
std::vector<ReportRow> ReportTable(std::span<const LotNotes> lots);

}  // namespace parti::grammar
