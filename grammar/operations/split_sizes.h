// Where a split cuts: sizes and repeat groups resolved along a length (CGA's split; errata 7).
// Knows nothing of geometry.
#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "grammar/action.h"

namespace parti::grammar {

/// A stretch of the axis, low < high, and the successor it belongs to (numbered as Product's are).
struct SplitPiece {
  double low = 0;
  double high = 0;
  int successor = 0;
  bool nil = false;
};

inline constexpr int kMostSplitPieces = 100'000;
/// Repeat groups may lie in repeat groups this deep.
inline constexpr int kDeepestRepeat = 16;

/// Resolves the successors along [0, length_m], in order.
///
/// Absolute sizes keep theirs, relative ones are shares of length_m, floating ones share what is
/// left in proportion. Sizes of 0 or less make nothing; where there is too little room, pieces are
/// cut and later ones make nothing; room that nothing asks for stays empty.
///
/// A group repeats in what its level leaves it (equal shares where a level has several groups; the
/// level's floating sizes count with their nominal size). A pattern with floating sizes is
/// stretched to fit the whole number of times that is nearest to its nominal size, at least once;
/// one without keeps its size and the last is cut, or is left to the level's floating sizes where
/// it has some. A group inside a group counts once towards its pattern's size and then fills what
/// it is given.
///
/// errors  kLimitReached  more than kMostSplitPieces;  kBadArguments  a pattern without size.
Result<void> ResolveSplit(std::span<const Successor> successors, double length_m,
                          std::vector<SplitPiece>* pieces);

/// The same for one group that repeats over the whole length: split(axis) { pattern }*.
Result<void> ResolveRepeat(std::span<const Successor> pattern, double length_m,
                           std::vector<SplitPiece>* pieces);

}  // namespace parti::grammar
