// The text of one action: "split(y) { 4: Ground | { ~3: Floor }* }" (language.md; errata 8).
// TextOf(Action) is in operation.h.
#pragma once

#include <string_view>

#include "grammar/lexer.h"
#include "grammar/operation.h"

namespace parti::grammar {

/// Braces may be nested this deep.
inline constexpr int kDeepestBraces = 32;

/// errors  kBadText;  kUnknownName  an operation, axis or selector, with "did you mean";
///         kBadArguments, kBadNumber  those of Check; all with their place.
Result<Action> ParseAction(std::string_view text, std::string_view file = {});

/// Reads one action and stops at the first token that can't belong to it.
/// `split(axis) { … }*` is the row "repeat", `segment(axis) { … }*` a segment with one group; both
/// forms of sizes and selectors are read:
/// `split(y) { 4: A | ~1: B }` and `split(y, 4, ~1) { A | B }`.
Result<Action> ReadAction(Lexer* lexer);

/// "4: tag("x") Ground"; a layer's name stands in the action's parentheses, not here.
std::string TextOf(const Successor& successor);
/// "'0.5", "~1", "3"
std::string TextOf(const Size& size);
/// "side", "inside", "2"
std::string TextOf(const Selector& selector);

}  // namespace parti::grammar
