// The lots that a text's rules are derived on: all of LOT, or those of them that can be used.
// Reading LOT is lot.h's, and deriving on lots session_state.h's.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session_state.h"

namespace parti::app {

/// What stands on lots, and which of them were left out.
struct UsedLots {
  std::shared_ptr<const Ground> ground;
  std::vector<Error> skipped;  ///< what is wrong with each
};

/// What rules make of LOT (docs/interfaces.md). With `skip_bad` a lot that can't be read or built
/// on, gives an attribute what it does not take, or that rules fail on is left out as if its file
/// did not have it: the others are numbered, placed and drawn for anew. Rules that fail on some
/// lot are derived a second time.
/// errors  those of ParseLots, ValuesOf and GroundOf, of the first lot that fails, naming the
/// remedy
///         where there are others; with `skip_bad` where all of them fail.
Result<UsedLots> UseLots(const std::string& lot, const std::shared_ptr<const RuleSource>& source,
                         const grammar::RuleSet& rules, const grammar::RuleThreads& threads,
                         bool skip_bad);

}  // namespace parti::app
