#include "app/report_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "app/file_ending.h"
#include "base/text_file.h"
#include "grammar/lexer.h"
#include "grammar/rules/report_table.h"

namespace parti::app {
namespace {

using grammar::LotNotes;
using grammar::NumberText;
using grammar::ReportRow;
using grammar::ValueType;
using Json = nlohmann::ordered_json;

constexpr std::string_view kCsv = ".csv", kJson = ".json";

Json RowJson(const ReportRow& row) {
  Json json{{"report", row.key}, {"type", grammar::NameOf(row.type)}, {"count", row.count}};
  if (row.type != ValueType::kNumber) {
    json["values"] = Json::object();
    for (const auto& [value, count] : row.values) json["values"][value] = count;
    return json;
  }
  json["sum"] = row.sum;
  json["average"] = row.average;
  json["min"] = row.least;
  json["max"] = row.most;
  json["no_numbers"] = row.no_numbers;
  return json;
}

Json TableJson(const std::vector<ReportRow>& rows) {
  Json list = Json::array();
  for (const ReportRow& row : rows) list.push_back(RowJson(row));
  return list;
}

std::string JsonText(std::span<const LotNotes> lots) {
  Json json{{"reports", TableJson(grammar::ReportTable(lots))}};
  if (lots.size() > 1) json["lots"] = Json::array();
  for (size_t i = 0; i < lots.size() && lots.size() > 1; ++i) {
    json["lots"].push_back({{"lot", fmt::format("lot-{}", i)},
                            {"reports", TableJson(grammar::ReportTable(lots[i].reports))}});
  }
  return TextOf(json) + "\n";
}

/// A cell: in quotes where it has what would end it (RFC 4180).
std::string Cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

/// A line for numbers, one for each different value of what is only counted.
std::string CsvText(const std::string& lot, const std::vector<ReportRow>& rows) {
  std::string text;
  for (const ReportRow& row : rows) {
    const std::string head = fmt::format("{},{}", lot, Cell(row.key));
    if (row.type == ValueType::kNumber) {
      text += fmt::format("{},,{},{},{},{},{},{}\r\n", head, row.count, NumberText(row.sum),
                          NumberText(row.average), NumberText(row.least), NumberText(row.most),
                          row.no_numbers);
    }
    for (const auto& [value, count] : row.values) {
      text += fmt::format("{},{},{},,,,,\r\n", head, Cell(value), count);
    }
  }
  return text;
}

std::string CsvText(std::span<const LotNotes> lots) {
  std::string text = "lot,report,value,count,sum,average,min,max,no_numbers\r\n";
  text += CsvText("", grammar::ReportTable(lots));
  for (size_t i = 0; i < lots.size() && lots.size() > 1; ++i) {
    text += CsvText(fmt::format("lot-{}", i), grammar::ReportTable(lots[i].reports));
  }
  return text;
}

}  // namespace

Json JsonOf(std::span<const LotNotes> lots) { return TableJson(grammar::ReportTable(lots)); }

std::string TextOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<void> WriteReports(std::span<const LotNotes> lots, const std::string& path) {
  if (std::string wrong = ReportEndingError(path); !wrong.empty()) {
    return Fail(ErrorCode::kUnknownName, std::move(wrong));
  }
  const bool is_empty =
      std::all_of(lots.begin(), lots.end(), [](const auto& lot) { return lot.reports.empty(); });
  if (is_empty) {
    return Fail(ErrorCode::kNothingMade, fmt::format("the rules report nothing for {}", path),
                "say what: report(\"floor area\", geometry.area)");
  }
  return WriteFile(path, EndingOf(path) == kCsv ? CsvText(lots) : JsonText(lots));
}

std::string ReportEndings() { return fmt::format("{}, {}", kCsv, kJson); }

std::string ReportEndingError(const std::string& path) {
  const std::string ending = EndingOf(path);
  if (ending == kCsv || ending == kJson) return "";
  return fmt::format("reports are written to {}, not to '{}'", ReportEndings(), path);
}

}  // namespace parti::app
