// Selection-action trees inside another text: the trees' parser for who reads rules around them.
// Whole texts of trees are selection_action.h's.
#pragma once

#include <vector>

#include "grammar/lexer.h"
#include "grammar/selection_action.h"

namespace parti::grammar {

/// `tree NAME`, with or without quotes, is next.
bool AtTree(const Lexer& lexer);

/// Reads one tree, up to and with the brace that closes it, going on at its next node after an
/// error. The lexer stands at `tree` and takes # for a comment, now and afterwards.
/// errors  appended to `errors` with their places, while they are fewer than 50: those of
///         ParseTrees.
SelectionActionTree ReadTree(Lexer* lexer, std::vector<Error>* errors);

}  // namespace parti::grammar
