// A query in plain words, for people who don't read queries: "every Glass facing north in every
// even Floor". Names stay as they are written in the rules.
// Not responsible for which queries there are (generalise.h, query.h).
#pragma once

#include <string>

#include "grammar/query.h"

namespace parti::grammar {

/// One line of words for any query that ParseQuery reads; n >= 1 selectors. Different queries may
/// read alike only where they mean the same (nth(1) and first).
std::string ReadingOf(const Query& query);

}  // namespace parti::grammar
