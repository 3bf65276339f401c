// An operation that may be meant, before and after its numbers are adjusted.
// Made by the heuristics and by sampling, adjusted by descent.h, weighed by ranking.h.
#pragma once

#include <optional>
#include <vector>

#include "base/math.h"
#include "grammar/action.h"

namespace parti::sketch {

/// One operation, with what is known of its numbers.
struct Hypothesis {
  grammar::Action action;
  /// Groups of dials (indices into grammar::Dials) that were found equal and stay equal (6.5.3).
  std::vector<std::vector<size_t>> equal = {};
  /// Set where parts were judged equal by eye: the stretch of the item that they divide, m.
  std::optional<Segment3> spaced_along = {};
  /// Dials that descent turns; all of them where it is empty.
  std::vector<size_t> turned = {};
  double price = 0;  ///< how much less likely it is than others before a line is drawn [nat]
  bool by_heuristic = true;
};

}  // namespace parti::sketch
