// What rules report(), written as a table (docs/interfaces.md, Reports).
// What reports come to is grammar/rules/report_table.h's.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "base/error.h"
#include "grammar/rules/rule_notes.h"

namespace parti::app {

/// One object for each key and type of value: of all lots together. Empty where nothing was
/// reported.
nlohmann::ordered_json JsonOf(std::span<const grammar::LotNotes> lots);
/// On one line. Bytes of texts that are not UTF-8 become U+FFFD.
std::string TextOf(const nlohmann::ordered_json& json);

/// The rows of all lots together, then, where there are several, those of each.
/// errors  kNothingMade  nothing was reported;  kFile;  kUnknownName  another ending.
Result<void> WriteReports(std::span<const grammar::LotNotes> lots, const std::string& path);

/// ".csv, .json"
std::string ReportEndings();
/// What is wrong with a path to write to; "" nothing.
std::string ReportEndingError(const std::string& path);

}  // namespace parti::app
