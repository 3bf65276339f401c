// From shapes that a person tapped to the queries that may be meant: simple generalisations by
// name, direction, position and place, each tried with the query engine (Jesus 2018, 5.5).
// Not responsible for what is done with a query, or for learning from what is chosen.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "grammar/query.h"

namespace parti::grammar {

/// The numbers of generalising.
struct GeneraliseParameters {
  /// What a part of a query (a symbol, a filter, a number; an operation twice that, since few
  /// people think in them) costs [bit], (0, 10]. Chosen so that one tap on a window of a
  /// façade of 60 offers its kind before its side, and its side before its row.
  double bits_per_part = 1.5;
  /// What the first tap counts for, further ones counting 1 each, [0, 1]: a single tap says what is
  /// meant, and little of how few.
  double first_tap = 0.4;
  /// Shapes above the tapped ones whose position is looked at, the nearest that have siblings,
  /// [0, 8]: windows in rows in parts of façades have 3.
  int most_levels = 3;
  /// Most candidates, [3, 1000]: what a person reads.
  int most = 12;
};

/// One of several trees, and a shape of it.
struct TappedShape {
  size_t tree = 0;
  ShapeIndex shape = 0;
  bool operator==(const TappedShape&) const = default;
};

/// A query that selects all that was tapped.
struct QueryCandidate {
  Query query;
  std::string reading;  ///< in plain words (ReadingOf)
  size_t count = 0;     ///< shapes that it selects in all trees, those tapped included
  double cost = 0;      ///< [bit]: what the list is ordered by, least first
};

/// Queries that select every tapped shape: the same symbol or operation; facing the same way; at
/// the same, the first, the last, an even or odd place among its siblings, or so its parents, and
/// for several shapes pairs of these; in the same part; and the one by the whole path, which for
/// one shape selects nothing else. The kind, the side and the narrowest are always among them.
///
/// trees    the lots' trees, not null; tapped  n >= 1, each in one of them.
/// returns  best first. cost = (n - 1 + first_tap) log2(count / n) + bits_per_part * parts: the
///          shorter query, unless it selects many more (the size principle: whoever means more
///          would tap more variously). No two select the same; the cheaper one is kept. Empty where
///          tapped is.
/// cost     linear in the trees for each query that is tried, at most about 100.
/// Properties: (1) each selects all that was tapped; (2) its count is what ProductOf says; (3) the
/// order of tapping does not matter.
std::vector<QueryCandidate> Generalise(std::span<const ShapeTree* const> trees,
                                       std::span<const TappedShape> tapped,
                                       const GeneraliseParameters& parameters = {});

}  // namespace parti::grammar
