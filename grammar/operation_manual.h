// The reference manual of the operations, written from the table: docs/operations.md.
// Nobody edits that file: a test compares it with this.
#pragma once

#include <string>

namespace parti::grammar {

/// Markdown: one section per row, in the order of the table.
std::string OperationsManual();

}  // namespace parti::grammar
