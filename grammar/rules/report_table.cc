#include "grammar/rules/report_table.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "grammar/rules/conversions.h"

namespace parti::grammar {
namespace {

class Table {
 public:
  void Add(std::span<const RuleReport> reports) {
    for (const RuleReport& report : reports) {
      ReportRow& row = rows_[{report.key, TypeOf(report.value)}];
      ++row.count;
      if (const double* number = std::get_if<double>(&report.value)) {
        AddNumber(*number, &row);
      } else {
        ++row.values[TextOf(report.value)];
      }
    }
  }

  std::vector<ReportRow> Take() && {
    std::vector<ReportRow> rows;
    for (auto& [key, row] : rows_) {
      std::tie(row.key, row.type) = key;
      const uint64_t numbers = row.count - row.no_numbers;
      const bool is_number = row.type == ValueType::kNumber && numbers > 0;
      if (is_number) row.average = row.sum / static_cast<double>(numbers);
      rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  static void AddNumber(double number, ReportRow* row) {
    if (std::isnan(number)) {
      ++row->no_numbers;
      return;
    }
    const bool is_first = row->count - row->no_numbers == 1;
    row->sum += number;
    row->least = is_first ? number : std::min(row->least, number);
    row->most = is_first ? number : std::max(row->most, number);
  }

  std::map<std::pair<std::string, ValueType>, ReportRow> rows_;
};

}  // namespace

std::vector<ReportRow> ReportTable(std::span<const RuleReport> reports) {
  Table table;
  table.Add(reports);
  return std::move(table).Take();
}

std::vector<ReportRow> ReportTable(std::span<const LotNotes> lots) {
  Table table;
  for (const LotNotes& lot : lots) table.Add(lot.reports);
  return std::move(table).Take();
}

}  // namespace parti::grammar
