// The reference manual of the functions of rules, written from their table: docs/functions.md.
// Nobody edits that file: a test compares it with this.
#pragma once

#include <string>

namespace parti::grammar {

/// Markdown: one table, a line per row, in the order of the table.
std::string FunctionsManual();

}  // namespace parti::grammar
