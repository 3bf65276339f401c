// The reference manual of the operations, written from the table and their examples:
// docs/operations.md. Nobody edits that file: a test compares it with this.
// Not responsible for reading examples nor for drawing their pictures (tests/docs).
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace parti::grammar {

/// Markdown: one section per row, in the order of the table, with the rules of its example and a
/// link to their picture, operations/NAME.png.
///
/// example  the text of docs/operations/NAME.cga; called once for each row, with its name.
std::string OperationsManual(const std::function<std::string(std::string_view name)>& example);

}  // namespace parti::grammar
