// Reading queries from a text that goes on after them; ParseQuery and TextOf are in query.h.
// Not responsible for what a query selects.
#pragma once

#include "grammar/lexer.h"
#include "grammar/query.h"

namespace parti::grammar {

/// Queries in filters' parentheses may be nested this deep.
inline constexpr int kDeepestQuery = 16;

/// Reads one query and stops at the first token that can't belong to it. The parts of a selector
/// touch each other; between selectors blanks are free.
/// errors  as ParseQuery, and kLimitReached for queries nested deeper than kDeepestQuery.
Result<Query> ReadQuery(Lexer* lexer, int depth = 0);

/// Whether a query starts at the token at hand, as far as one token tells.
bool AtQuery(const Lexer& lexer);

}  // namespace parti::grammar
